// Events of sensors as arrays, which are read after a step.
import { assertUsable } from '../ecs/guards.ts';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { COMPUTED_ANEW, markImmutable, namedResource } from '../memory/resource.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { listOf } from './contact-events.ts';
import { rigidTable } from './rigid-table.ts';

/** Pairs of a sensor and what it senses; entry i of each array is valid for i < `count`. */
export interface SensorPairs {
  readonly count: number;
  /** Ids of the entities with the sensors, and of those that overlap them: bodies, or parts of compound bodies. */
  readonly sensor: Uint32Array;
  readonly visitor: Uint32Array;
}

/** The events of the last step. The arrays are reused by every step. */
export interface SensorEvents {
  /** Pairs that began to overlap. */
  readonly begin: SensorPairs;
  /** Pairs that no longer overlap; one of them may be gone. */
  readonly end: SensorPairs;
}

const eventsOf = /* @__PURE__ */ namedResource<SensorEvents>(COMPUTED_ANEW, (world) => {
  const { words } = rigidTable(world);
  const pairs = (count: Word, sensor: Word, visitor: Word): SensorPairs => ({
    get count() {
      return words[count];
    },
    sensor: listOf(world, words[sensor]),
    visitor: listOf(world, words[visitor]),
  });
  return markImmutable({
    begin: pairs(Word.sensorBeginCount, Word.sensorBeginSensors, Word.sensorBeginVisitors),
    end: pairs(Word.sensorEndCount, Word.sensorEndSensors, Word.sensorEndVisitors),
  });
});

const NO_PAIRS: SensorPairs = {
  count: 0,
  sensor: /* @__PURE__ */ new Uint32Array(0),
  visitor: /* @__PURE__ */ new Uint32Array(0),
};
const NO_EVENTS: SensorEvents = { begin: NO_PAIRS, end: NO_PAIRS };

/**
 * Returns the events of sensors in the last step: always the same object. Overlaps are those at the start of the step. A fast
 * body that passed a sensor within the step, which does not move, begins and ends in it; these come before the others, and of
 * several sensors passed in one step not in the order of passing. So does an id that was despawned and given to another body in
 * the sensor. Count a pair up at each `begin` and down at each `end`, and the order does not matter. What has neither a mass nor
 * Velocity or AngularVelocity is static, and sensed by sensors that are not. A world without rigid bodies has none.
 * @throws PhysicsError E_CAPACITY, E_DESTROYED
 */
export function sensorEvents(world: PhysicsWorld): SensorEvents {
  assertUsable(world);
  return isSoftStep(world.integrator) ? eventsOf(world) : NO_EVENTS;
}

// The system of the `emit` phase.
import { removeComponent } from 'bitecs';
import { bitOf } from '../components/membership.ts';
import { leaveOutWaiting } from '../ecs/ranges.ts';
import type { MemoryRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import { nameSystem } from '../world/name-system.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { followBody } from './follow.ts';
import { emitterKernels } from './kernels.ts';
import { advanceNewborns } from './newborns.ts';
import { dropIncomplete } from './pool.ts';
import { N, W } from './record.ts';
import type { Emitter } from './types.ts';

/**
 * The emitters of a world, in order of creation, and the number ever made, which selects the random stream of the
 * next.
 */
export const emittersOf = namedResource('emitters', () => ({ list: [] as Emitter[], made: 0 }));

/**
 * Finding the rows that wait takes as long as gravity for half of them. Where most of the particles are there, it would not
 * pay.
 */
const MOSTLY_IN_USE = 0.5;

/** Ages particles of all emitters, ends those whose life is over and creates new ones. */
export const emitParticles = /* @__PURE__ */ nameSystem('emit particles', (world: PhysicsWorld, dt: number) => {
  const { list } = emittersOf(world);
  let room = 0;
  let alive = 0;
  for (let i = 0; i < list.length; i++) {
    const emitter = list[i];
    const { record } = emitter.internal.block;
    if (emitter.internal.membership !== world.versions.membership) {
      emitter.internal.membership = world.versions.membership;
      dropIncomplete(world, record);
    }
    if (emitter.internal.followed !== undefined) followBody(world, emitter, record);
    computeVelocity(record);
    const born = record.numbers[N.born];
    emitterKernels(world).stepEmitter(record.at, dt);
    advanceNewborns(world, record);
    if (record.words[W.changed] !== 0) world.versions.style++;
    // The previous pose of a new particle is its position of birth, which changes the previous-pose column.
    if (record.numbers[N.born] !== born) world.versions.pose++;
    if (world.internal.counts.Quarantined > 0) clearQuarantine(world, emitter);
    room += record.words[W.capacity];
    alive += record.words[W.alive];
  }
  if (alive < MOSTLY_IN_USE * room) leaveOutWaiting(world);
});

/** Computes the inherited velocity: the emitter's displacement since the last step over the time. */
function computeVelocity({ numbers }: MemoryRecord): void {
  const pending = numbers[N.pending];
  const factor = pending > 0 ? numbers[N.inheritVelocity] / pending : 0;
  numbers[N.velocityX] = (numbers[N.x] - numbers[N.lastX]) * factor;
  numbers[N.velocityY] = (numbers[N.y] - numbers[N.lastY]) * factor;
  numbers[N.velocityZ] = (numbers[N.z] - numbers[N.lastZ]) * factor;
}

/** Ends the quarantine of particles whose life is over. */
function clearQuarantine(world: PhysicsWorld, { ids }: Emitter): void {
  const { members } = world.internal;
  const mass = world.components.Mass.value;
  const bit = bitOf('Quarantined');
  for (let i = 0; i < ids.length; i++) {
    if ((members[ids[i]] & bit) !== 0 && mass[ids[i]] === 0) {
      removeComponent(world, ids[i], world.components.Quarantined);
    }
  }
}

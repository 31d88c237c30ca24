/** Random operations, through the API and through bitECS, with the invariants checked after each. */
import {
  bodies,
  COMPONENT_NAMES,
  type ComponentName,
  despawn,
  type EntityRef,
  entityRef,
  isAlive,
  moveCharacter,
  PhysicsError,
  type PhysicsWorld,
  resolve,
  spawn,
  spawnMany,
  step,
} from '@principia/physics';
import {
  addComponent,
  addEntity,
  entityExists,
  getAllEntities,
  hasComponent,
  query,
  removeComponent,
  removeEntity,
  set,
} from 'bitecs';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { DT, groundWorld } from '../support/worlds.ts';

const CAPACITY = 300;
const NAMES = ['Position', 'Velocity', 'Mass', 'Rotation', 'AngularVelocity', 'Collider', 'LinearDrag'] as const;

interface Model {
  readonly world: PhysicsWorld;
  /** All references ever taken, and whether their body should still exist. */
  readonly refs: Map<EntityRef, boolean>;
}

type Operation = readonly [kind: string, a: number, b: number];

const name = (b: number): (typeof NAMES)[number] => NAMES[b % NAMES.length];

/** Returns an id in use, or any id if `a` says so. */
function pick({ world }: Model, a: number): number {
  const all = getAllEntities(world);
  return all.length === 0 || a % 10 === 0 ? a % (CAPACITY + 5) : all[a % all.length];
}

const OPERATIONS: Record<string, (model: Model, a: number, b: number) => void> = {
  spawn({ world }, a, b) {
    spawn(world, {
      position: { x: a % 50, y: 1 + (b % 9) },
      ...(a % 2 === 0 ? { velocity: { x: b % 7 } } : {}),
      ...(b % 2 === 0 ? { mass: 1 + (a % 5), collider: 0.2 } : {}),
      ...(b % 3 === 0 ? { angularVelocity: 1, rotation: 2 } : {}),
    });
  },
  spawnMany({ world }, a, b) {
    spawnMany(world, a % 40, { position: { x: b % 9 }, ...(a % 2 === 0 ? { velocity: { y: 1 } } : {}), mass: 2 });
  },
  spawnBad: ({ world }, a) => void spawn(world, { position: {}, mass: a % 2 === 0 ? -1 : NaN }),
  spawnCharacter({ world }, a, b) {
    spawn(world, {
      position: { x: a % 9, y: b % 4 },
      velocity: {},
      collider: 0.3,
      ...(a % 2 === 0 ? { mass: 2, kinematic: {} } : {}),
    });
  },
  moveCharacter: (model, a, b) =>
    void moveCharacter(model.world, pick(model, a), { x: (b % 9) - 4, y: (a % 5) - 3 }, DT),
  despawn: (model, a) => despawn(model.world, pick(model, a)),
  rawAdd({ world }, _, b) {
    const eid = addEntity(world);
    addComponent(world, eid, world.components[name(b)]);
  },
  rawRemove: (model, a) => removeEntity(model.world, pick(model, a)),
  set(model, a, b) {
    const { components } = model.world;
    addComponent(model.world, pick(model, a), set(components.Velocity, { x: b % 4 === 0 ? NaN : b % 9 }));
  },
  removeComponent(model, a, b) {
    removeComponent(model.world, pick(model, a), model.world.components[name(b)]);
  },
  poison({ world }, a, b) {
    const { ids, count } = bodies(world);
    if (count === 0) return;
    const eid = ids[a % count];
    const { Position, Velocity, Rotation } = world.components;
    const [component, column] = (
      [
        [Position, Position.x],
        [Velocity, Velocity.y],
        [Rotation, Rotation.angle],
      ] as const
    )[b % 3];
    if (hasComponent(world, eid, component)) column[eid] = [NaN, Infinity, 1e30][a % 3];
  },
  reference({ world, refs }, a) {
    const { ids, count } = bodies(world);
    if (count > 0) refs.set(entityRef(world, ids[a % count]), true);
  },
  query({ world }, a, b) {
    query(world, [world.components[name(a)], world.components[name(b)]]);
  },
  step: ({ world }) => step(world, DT),
  editInStep(model, a, b) {
    const kinds = Object.keys(OPERATIONS).filter((kind) => kind !== 'step' && kind !== 'editInStep');
    const { input } = model.world.phases;
    input.push(() => {
      for (const shift of [0, 3, 8]) attempt(model, [kinds[(b + shift) % kinds.length], a + shift, b]);
    });
    step(model.world, DT);
    input.pop();
  },
};

/** Refusals are expected; any other error fails, as does an AggregateError of others. */
function attempt(model: Model, [kind, a, b]: Operation): void {
  try {
    OPERATIONS[kind](model, a, b);
  } catch (error) {
    const refused = error instanceof PhysicsError || String(error).includes('does not exist in the world');
    if (!refused) throw error;
  }
}

function checkRows(world: PhysicsWorld): void {
  const counts = Object.fromEntries(COMPONENT_NAMES.map((component) => [component, 0])) as Record<
    ComponentName,
    number
  >;
  let last = 0;
  for (let eid = 1; eid < 400; eid++) {
    for (const [bit, component] of COMPONENT_NAMES.entries()) {
      const has = entityExists(world, eid) && hasComponent(world, eid, world.components[component]);
      const isMember = ((world.internal.members[eid] >>> bit) & 1) === 1;
      if (has !== isMember) throw new Error(`row ${eid}, ${component}: bitECS says ${has}, the row ${isMember}`);
      if (has) {
        counts[component]++;
        last = eid;
      } else {
        for (const column of Object.values(world.components[component])) {
          if (column[eid] !== 0) throw new Error(`row ${eid} holds ${column[eid]} for a ${component} it has not`);
        }
      }
    }
  }
  expect(world.internal.counts).toEqual(counts);
  expect(world.lastId).toBe(last);
}

function checkBodies(world: PhysicsWorld): void {
  const found = [...query(world, [world.components.Position])].sort((a, b) => a - b);
  const { ids, count } = bodies(world);
  expect([...ids.subarray(0, count)]).toEqual(found);
  const { ranges } = world;
  const inside: number[] = [];
  let before = 0;
  for (let r = 0; r < ranges.count; r++) {
    const [first, end] = [ranges.bounds[2 * r], ranges.bounds[2 * r + 1]];
    expect(first % 16 === 0 && end % 16 === 0 && first >= before && end > first).toBe(true);
    const within = found.filter((eid) => eid >= first && eid < end);
    // Both ends of a range are bodies: it covers no unnecessary block.
    expect(within[0] < first + 16 && within[within.length - 1] >= end - 16).toBe(true);
    inside.push(...within);
    before = end;
  }
  expect(inside).toEqual(found);
}

function checkReferences({ world, refs }: Model): void {
  for (const [ref, wasAlive] of refs) {
    const alive = isAlive(world, ref);
    if (alive && !wasAlive) throw new Error(`reference ${ref} came back to life`);
    if (alive) expect(entityRef(world, resolve(world, ref))).toBe(ref);
    refs.set(ref, alive);
  }
}

function validateState(world: PhysicsWorld): void {
  const { Position, Velocity, Rotation } = world.components;
  // Entities without Position are not bodies: the step does not look at what was written to their rows.
  const { ids, count } = bodies(world);
  for (const column of [Position.x, Position.y, Velocity.x, Velocity.y, Rotation.angle]) {
    for (const eid of ids.subarray(0, count)) expect(Number.isFinite(column[eid]), `body ${eid}`).toBe(true);
  }
}

/** `npm run soak` asks for more runs, of other seeds. */
const RUNS = Number(process.env.SOAK_RUNS ?? 150);
const SEED = Number(process.env.SOAK_SEED ?? 20);

const operation = fc.tuple(fc.constantFrom(...Object.keys(OPERATIONS)), fc.nat(1000), fc.nat(1000));

it('members, counts, ranges, zero rows and references hold after any operations', () => {
  fc.assert(
    fc.property(fc.array(operation, { minLength: 1, maxLength: 60 }), (operations) => {
      const model: Model = { world: groundWorld({ capacity: CAPACITY }), refs: new Map() };
      for (const each of operations) {
        attempt(model, each);
        checkBodies(model.world);
        checkReferences(model);
      }
      checkRows(model.world);
      step(model.world, DT);
      validateState(model.world);
      expect(model.world.state).toBe('idle');
    }),
    { numRuns: RUNS, seed: SEED, endOnFailure: false },
  );
});

it('a world emptied by any operations is as good as new', () => {
  fc.assert(
    fc.property(fc.array(operation, { minLength: 1, maxLength: 60 }), (operations) => {
      const model: Model = { world: groundWorld({ capacity: CAPACITY }), refs: new Map() };
      for (const each of operations) attempt(model, each);
      for (const eid of [...getAllEntities(model.world)]) removeEntity(model.world, eid);
      checkRows(model.world);
      checkBodies(model.world);
      expect(spawnMany(model.world, CAPACITY, { position: {} })).toHaveLength(CAPACITY);
      checkRows(model.world);
    }),
    { numRuns: RUNS / 3, seed: SEED + 1 },
  );
});

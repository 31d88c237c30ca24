// A slider replaces a force at every frame: it takes no memory beyond that of the first.
import {
  clothWind,
  createCloth,
  createPhysicsWorld,
  defineForce,
  enclosedGas,
  enclosedMassGravity,
  type Force,
  mutualCoulomb,
  mutualGravity,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  pointerPull,
  polygonBuoyancy,
  replaceForce,
  restore,
  restrictForce,
  snapshot,
  spawn,
  step,
  turbulentDrag,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';

interface Case {
  readonly name: string;
  readonly dimensions: 2 | 3;
  readonly make: (value: number, triangles: Uint32Array) => Force;
}

const profile = { radii: [1, 2, 3], masses: [1, 2, 3] };
const hull = {
  shape: 2,
  vertices: [
    { x: -1, y: -1 },
    { x: 1, y: -1 },
    { x: 0, y: 1 },
  ],
};
const CASES: readonly Case[] = [
  { name: 'mutualGravity', dimensions: 2, make: (G) => mutualGravity({ G, softening: 0.1 }) },
  {
    name: 'mutualGravity by the tree',
    dimensions: 3,
    make: (G) => mutualGravity({ G, softening: 0.1, method: 'tree' }),
  },
  {
    name: 'mutualGravity by pairs',
    dimensions: 3,
    make: (G) => mutualGravity({ G, softening: 0.1, method: 'direct' }),
  },
  { name: 'mutualCoulomb', dimensions: 2, make: (k) => mutualCoulomb({ k, softening: 0.1 }) },
  { name: 'clothWind', dimensions: 3, make: (z, triangles) => clothWind({ triangles, velocity: { z } }) },
  {
    name: 'enclosedGas',
    dimensions: 3,
    make: (amount, faces) => enclosedGas({ faces, corners: 3, amount, ambient: amount / 10 }),
  },
  { name: 'turbulentDrag', dimensions: 3, make: (deviation) => turbulentDrag({ deviation, largest: 4 }) },
  {
    name: 'enclosedMassGravity',
    dimensions: 3,
    make: (gravitationalConstant) => enclosedMassGravity({ ...profile, gravitationalConstant }),
  },
  {
    name: 'polygonBuoyancy',
    dimensions: 2,
    make: (density) => polygonBuoyancy({ density, level: 3, gravity: { y: -9.8 } }, hull),
  },
  { name: 'pointerPull', dimensions: 2, make: (frequency) => pointerPull({ frequency }) },
  {
    name: 'a restricted mutualGravity',
    dimensions: 3,
    make: (G) =>
      restrictForce(mutualGravity({ G, softening: 0.1 }), { region: { min: { x: 0 }, max: { x: 5, y: 50, z: 50 } } }),
  },
];

/** A cloth and a few charges that drag on the air. */
function makeWorld(options: PhysicsWorldOptions): [PhysicsWorld, Uint32Array] {
  const world = createPhysicsWorld({ capacity: 1000, ...options });
  const cloth = createCloth(world, { corner: {}, columns: 10, rows: 10, spacing: 0.5, mass: 1, structural: 10 });
  for (let i = 0; i < 20; i++) {
    const position = { x: (7 * i) % 10, y: (3 * i) % 8 };
    spawn(world, { position, mass: 1, charge: 0.1, linearDrag: 0.1, rotation: 0, appearance: { shape: 2 } });
  }
  return [world, cloth.triangles];
}

const stateOf = ({ components: { Position, Velocity } }: PhysicsWorld) =>
  [Position.x, Position.y, Position.z, Velocity.x, Velocity.y, Velocity.z].map((column) => column.slice(0, 150));

const KINDS = CASES.flatMap((each) => (['f32', 'f64'] as const).map((precision) => ({ ...each, precision })));

describe.each(KINDS)('$name, $precision', ({ dimensions, precision, make }) => {
  it('is replaced 200 times in the memory of the first two, and acts as the last in a new world', () => {
    const [world, triangles] = makeWorld({ dimensions, precision });
    const value = (i: number) => 1 + (i % 7) / 10;
    world.forces.push(make(value(0), triangles));
    for (let i = 1; i <= 2; i++) {
      step(world, 1e-3);
      replaceForce(world, make(value(i), triangles));
    }
    step(world, 1e-3);
    const { top } = world.internal.arena;
    for (let i = 3; i <= 200; i++) {
      replaceForce(world, make(value(i), triangles));
      step(world, 1e-3);
    }
    expect(world.internal.arena.top).toBe(top);

    const [fresh, others] = makeWorld({ dimensions, precision });
    fresh.forces.push(make(value(3), others));
    replaceForce(world, make(value(3), triangles));
    const [columns, sources] = [fresh, world].map(({ components: { Position, Velocity } }) => [
      ...Object.values(Position),
      ...Object.values(Velocity),
    ]);
    for (const [i, column] of columns.entries()) column.set(sources[i]);
    fresh.time = world.time;
    for (const each of [world, fresh]) for (let i = 0; i < 5; i++) step(each, 1e-3);
    expect(stateOf(world)).toEqual(stateOf(fresh));
  });

  it('comes back with a snapshot from before it was replaced', () => {
    const [world, triangles] = makeWorld({ dimensions, precision });
    world.forces.push(make(1, triangles));
    step(world, 1e-3);
    const taken = snapshot(world);
    const go = () => {
      for (let i = 0; i < 5; i++) step(world, 1e-3);
      return stateOf(world);
    };
    const first = go();
    for (let i = 0; i < 5; i++) {
      replaceForce(world, make(2, triangles));
      step(world, 1e-3);
    }
    restore(world, taken);
    expect(go()).toEqual(first);
    replaceForce(world, make(3, triangles));
    expect(() => step(world, 1e-3)).not.toThrow();
  });
});

describe.each(KINDS)('$name, $precision, put in and taken out 100 times', ({ dimensions, precision, make }) => {
  const ways: Record<string, (world: PhysicsWorld) => void> = {
    pop: ({ forces }) => forces.pop(),
    splice: ({ forces }) => forces.splice(0, 1),
    length: ({ forces }) => {
      forces.length = 0;
    },
  };

  it.each(Object.entries(ways))(
    'by %s takes the memory of the first two, and comes back with a snapshot',
    (_, remove) => {
      const [world, triangles] = makeWorld({ dimensions, precision });
      const forces = [1, 2].map((value) => make(value, triangles));
      // What takes two blocks finds its own in the third round.
      for (let i = 0; i < 2; i++) {
        world.forces.push(forces[0]);
        step(world, 1e-3);
        remove(world);
        step(world, 1e-3);
      }
      world.forces.push(forces[0]);
      step(world, 1e-3);
      const taken = snapshot(world);
      step(world, 1e-3);
      const first = stateOf(world);
      const { top } = world.internal.arena;
      for (let i = 1; i <= 100; i++) {
        remove(world);
        // Each force comes again, and some are new; in some steps there is none.
        if (i % 5 === 0) step(world, 1e-3);
        world.forces.push(i % 3 === 0 ? make(3, triangles) : forces[i % 2]);
        step(world, 1e-3);
      }
      expect(world.internal.arena.top).toBe(top);
      restore(world, taken);
      step(world, 1e-3);
      expect(stateOf(world)).toEqual(first);
    },
  );
});

describe('the memory of a force', () => {
  it('is given back once, and stays with a force that comes again before the next step', () => {
    let released = 0;
    const force: Force = {
      ...defineForce({ name: 'own', accumulate: () => {} }),
      releaseMemory: () => {
        released++;
      },
    };
    const world = createPhysicsWorld({ forces: [force] });
    step(world, 0.01);
    world.forces.pop();
    world.forces.push(force);
    step(world, 0.01);
    expect(released).toBe(0);
    replaceForce(world, mutualGravity(), force);
    for (let i = 0; i < 3; i++) step(world, 0.01);
    expect(released).toBe(1);
  });

  it('stays with it while it is in the list once more', () => {
    const force = mutualGravity({ G: 1, softening: 0.1 });
    const world = createPhysicsWorld({ forces: [force, force] });
    for (let x = 0; x < 3; x++) spawn(world, { position: { x }, mass: 1 });
    step(world, 0.01);
    replaceForce(world, mutualGravity({ G: 1, softening: 0.1 }));
    step(world, 0.01);
    // Two in the first step, whose start is evaluated as well, and one in the second.
    expect(force.report(world).evaluations).toBe(3);
  });

  it('goes to the next force although the force replaced itself before', () => {
    const make = () => mutualGravity({ G: 1, softening: 0.1 });
    const force = make();
    const world = createPhysicsWorld({ forces: [force] });
    for (let x = 0; x < 3; x++) spawn(world, { position: { x }, mass: 1 });
    step(world, 0.01);
    replaceForce(world, force, force);
    step(world, 0.01);
    const { top } = world.internal.arena;
    world.forces.length = 0;
    step(world, 0.01);
    world.forces.push(make());
    step(world, 0.01);
    expect(world.internal.arena.top).toBe(top);
  });

  it('is taken anew where the force comes back after it was replaced', () => {
    const [one, two] = [1, 2].map((G) => mutualGravity({ G, softening: 0.1 }));
    const world = createPhysicsWorld({ forces: [one] });
    for (let x = 0; x < 3; x++) spawn(world, { position: { x }, mass: 1 });
    step(world, 0.01);
    const { top } = world.internal.arena;
    for (let i = 0; i < 100; i++) {
      replaceForce(world, i % 2 === 0 ? two : one);
      step(world, 0.01);
    }
    expect(world.internal.arena.top).toBe(top);
  });
});

it('says that the new force comes first, and that the old one must be that of the list', () => {
  const [old, other] = [uniformGravity({ y: -1 }), uniformGravity({ y: -1 })];
  const world = createPhysicsWorld({ forces: [old] });
  const message = 'old must be in world.forces; the new force comes first, got "uniform gravity".';
  expect(() => replaceForce(world, old, other)).toThrow(message);
  const third = uniformGravity({ y: -2 });
  expect(() => replaceForce(world, third, other)).toThrow(message);
  expect(world.forces).toEqual([old]);
  replaceForce(world, third, old);
  expect(world.forces).toEqual([third]);
});

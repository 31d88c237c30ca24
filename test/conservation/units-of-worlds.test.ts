/** Worlds of all kinds move the same to the bit in other units. */
import {
  box,
  boxWalls,
  circle,
  createEmitter,
  createJoint,
  createPhysicsWorld,
  createRope,
  INTEGRATORS,
  linearDrag,
  mutualGravity,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  particleContacts,
  quadraticDrag,
  revolute,
  rigidBodies,
  spawn,
  springs,
  step,
  uniformGravity,
  xpbd,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { KILOGRAM, METRE, SECOND } from '../support/other-units.ts';

const AXES = ['x', 'y', 'z'] as const;

/** Our units in those in which a world is made. */
interface Units {
  readonly m: number;
  readonly kg: number;
  readonly s: number;
}

type Make = (units: Units, options: PhysicsWorldOptions) => PhysicsWorld;

const gravityOf = ({ m, s }: Units) => uniformGravity({ y: (-10 * m) / (s * s) });

/** Balls of several sizes that fall on each other in a box. */
const heap: Make = (units, options) => {
  const { m, kg, s } = units;
  const walls = [
    boxWalls({ min: { x: 0, y: 0, z: 0 }, max: { x: 10 * m, z: 10 * m }, restitution: 0.5, friction: 0.3 }),
  ];
  const world = createPhysicsWorld({ ...options, preset: particleContacts, forces: [gravityOf(units)], walls });
  for (let i = 0; i < 80; i++) {
    spawn(world, {
      position: { x: (0.7 + 1.2 * (i % 8)) * m, y: (0.7 + 1.2 * Math.floor(i / 8)) * m },
      velocity: { x: (((i * 7) % 5) * m) / s },
      mass: (0.5 + ((i * 3) % 7) / 7) * kg,
      rotation: 0,
      collider: { radius: (0.2 + ((i * 5) % 11) / 40) * m, restitution: 0.4, friction: 0.5 },
    });
  }
  return world;
};

/** An elastic chain that hangs by its end in air, with the scheme of `options`. */
const chain: Make = (units, options) => {
  const { m, kg, s } = units;
  const forces = [gravityOf(units), springs(), linearDrag(), quadraticDrag()];
  const world = createPhysicsWorld({ ...options, forces });
  const links = Array.from({ length: 12 }, (_, i) =>
    spawn(world, {
      position: { x: i * m },
      velocity: { y: (i * m) / s },
      linearDrag: (0.01 * kg) / s,
      quadraticDrag: (0.001 * kg) / m,
      ...(i === 0 ? {} : { mass: kg }),
    }),
  );
  const spring = { stiffness: (200 * kg) / (s * s), damping: kg / s, length: m };
  for (let i = 1; i < links.length; i++) spawn(world, { spring: { a: links[i - 1], b: links[i], ...spring } });
  return world;
};

/** A motor that lifts a chain out of a heap of boxes and balls, one of them heavy. */
const machine: Make = (units, options) => {
  const { kg } = units;
  const world = createPhysicsWorld({ ...options, preset: rigidBodies, forces: [gravityOf(units)] });
  const post = spawn(world, { position: { y: -1 }, collider: { shape: box(80, 2), friction: 0.6 } });
  let last = post;
  for (let i = 0; i < 8; i++) {
    const b = spawn(world, {
      position: { x: i + 0.5, y: 6 },
      rotation: 0,
      collider: { shape: box(1, 0.2), density: kg },
    });
    const motor = { speed: 1, max: 300 * kg };
    const [first, others] = [{ motor }, { limits: { lower: -0.5, upper: 0.5 } }];
    createJoint(world, revolute({ a: last, b, anchor: { x: i, y: 6 }, ...(i === 0 ? first : others) }));
    last = b;
  }
  for (let i = 0; i < 24; i++) {
    const shape = i % 2 === 0 ? box(1, 0.7) : circle(0.4);
    const collider = { shape, density: (i === 9 ? 30 : 1) * kg, friction: 0.6, restitution: 0.3 };
    spawn(world, { position: { x: 4 + ((i * 5) % 7) / 2, y: 7 + 0.7 * i }, rotation: i, collider });
  }
  return world;
};

/** A rope between two pins, inextensible. */
const rope: Make = (units, options) => {
  const { m, kg } = units;
  const forces = [gravityOf(units), springs()];
  const world = createPhysicsWorld({ ...options, forces, integrator: xpbd({ substeps: 4, iterations: 4 }) });
  createRope(world, { from: {}, to: { x: 10 * m }, nodes: 24, mass: kg, length: 12 * m, pins: 'both' });
  return world;
};

/** A cluster of stars, by the tree. */
const stars: Make = ({ m, kg, s }, options) => {
  const G = (m * m * m) / (kg * s * s);
  const world = createPhysicsWorld({ ...options, forces: [mutualGravity({ G, softening: 0.05 * m, method: 'tree' })] });
  for (let i = 0; i < 200; i++) {
    const [x, y, z] = [7, 11, 13].map((prime) => ((i * prime) % 17) + i / 40 - 10);
    const position = world.dimensions === 2 ? { x: x * m, y: y * m } : { x: x * m, y: y * m, z: z * m };
    spawn(world, { position, velocity: {}, mass: 0.05 * kg });
  }
  return world;
};

/** Sparks of an emitter, in air. */
const sparks: Make = (units, options) => {
  const { m, kg, s } = units;
  const world = createPhysicsWorld({ ...options, forces: [gravityOf(units), linearDrag()] });
  createEmitter(world, {
    capacity: 200,
    rate: 60 / s,
    lifetime: 2 * s,
    speed: (5 * m) / s,
    direction: { y: 1 },
    spread: 1,
    mass: kg,
    linearDrag: (0.2 * kg) / s,
  });
  return world;
};

interface Case {
  readonly name: string;
  readonly make: Make;
  readonly options?: PhysicsWorldOptions;
  /** The units that may be others; by default all. */
  readonly free?: readonly (keyof Units)[];
}

/** Contacts of balls push overlaps out by some radii a second. */
const NO_TIME = ['m', 'kg'] as const;
/** Rigid bodies are solved by lengths and times that suit those of 0.1 to 10 m. */
const ONLY_MASS = ['kg'] as const;

const CASES: readonly Case[] = [
  { name: 'balls', make: heap, free: NO_TIME },
  { name: 'balls in space', make: heap, options: { precision: 'f32', dimensions: 3 }, free: NO_TIME },
  { name: 'rigid bodies on joints', make: machine, free: ONLY_MASS },
  { name: 'rigid bodies on joints in f32', make: machine, options: { precision: 'f32' }, free: ONLY_MASS },
  { name: 'a rope', make: rope },
  { name: 'a rope in f32', make: rope, options: { precision: 'f32' } },
  { name: 'stars', make: stars },
  { name: 'stars in space', make: stars, options: { precision: 'f32', dimensions: 3 } },
  { name: 'sparks', make: sparks, options: { precision: 'f32' } },
  ...Object.entries(INTEGRATORS)
    // It has a central mass and its gravity.
    .filter(([name]) => name !== 'wisdomHolman')
    .map(([name, { create }]) => ({ name: `a chain by ${name}`, make: chain, options: { integrator: create() } })),
];

describe('worlds move the same in other units', () => {
  /** Coordinates and velocities after 60 steps of 1/64 s, in metres and seconds. */
  function motion(make: Make, units: Units, options: PhysicsWorldOptions): number[] {
    const world = make(units, { capacity: 300, ...options });
    for (let i = 0; i < 60; i++) step(world, units.s / 64);
    const { Position, Velocity } = world.components;
    const ids = Array.from({ length: world.lastId }, (_, i) => i + 1);
    return ids.flatMap((id) =>
      AXES.flatMap((axis) => [Position[axis][id] / units.m, (Velocity[axis][id] * units.s) / units.m]),
    );
  }

  it.each(CASES)('$name', ({ make, options = {}, free = ['m', 'kg', 's'] }) => {
    const units = { m: 1, kg: 1, s: 1 };
    const ours = motion(make, units, options);
    const others = { m: METRE, kg: KILOGRAM, s: SECOND };
    const changed = free.map((unit) => [unit, others[unit]]);
    expect(motion(make, { ...units, ...Object.fromEntries(changed) }, options)).toEqual(ours);
    expect(ours.some((value) => Math.abs(value) > 1)).toBe(true);
  });
});

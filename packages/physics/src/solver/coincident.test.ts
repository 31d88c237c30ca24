// Bodies that were put in one place part no faster than overlap is pushed out, and keep no speed of it.
import {
  type BodyInput,
  box,
  capsule,
  circle,
  createJoint,
  momentum,
  revolute,
  softStep,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const COUNT = 100;
/** Default of `softStep({ contactSpeed })`, m/s. */
const PUSHED = 3;

type Shape = NonNullable<BodyInput['collider']>;
/** What overlaps completely, and how wide it is, m. */
const SHAPES: readonly (readonly [name: string, shape: Shape, width: number])[] = [
  ['boxes', { shape: box(1, 1) }, 1],
  ['discs', { radius: 0.5 }, 1],
  ['rounded boxes', { shape: box(1, 1, { rounding: 0.1 }) }, 1],
  // All of them lie side by side, so that they part in a column of a hundred layers.
  ['capsules', { shape: capsule(0.6, 0.2) }, 0.4],
];

function crowd({ world, shape, at }: { world: ReturnType<typeof rigidWorld>; shape: Shape; at: BodyInput }): number[] {
  const collider = { ...(shape as object), density: 1, friction: 0.6 };
  return Array.from({ length: COUNT }, () => spawn(world, { ...at, collider }));
}

describe.each(['f32', 'f64'] as const)('in %s a hundred', (precision) => {
  it.each(SHAPES)('%s in one place part at 3 m/s and come to rest', (_, shape, width) => {
    // What falls asleep would lose its momentum.
    const world = rigidWorld({ precision, forces: [], integrator: softStep({ sleepTime: 0 }) });
    const ids = crowd({ world, shape, at: { position: { x: 3, y: 0.5 } } });
    const { Position, Velocity } = world.components;
    let [farthest, fastest] = [0, 0];
    // The outermost of a column of them has half its length to go.
    const steps = Math.ceil((1.2 * COUNT * width) / 2 / PUSHED / DT);
    for (let i = 0; i < steps; i++) {
      const before = ids.map((id) => [Position.x[id], Position.y[id]] as const);
      step(world, DT);
      ids.forEach((id, k) => {
        const [x, y] = before[k] ?? [0, 0];
        farthest = Math.max(farthest, Math.hypot(Position.x[id] - x, Position.y[id] - y));
        fastest = Math.max(fastest, Math.hypot(Velocity.x[id], Velocity.y[id]));
      });
    }
    // Places are rounded to 1e-6 m, a part in 1e4 of the way.
    expect(farthest).toBeLessThan(PUSHED * DT * 1.001);
    expect(fastest).toBeLessThan(PUSHED);
    const between = (a: number, b: number) => Math.hypot(Position.x[a] - Position.x[b], Position.y[a] - Position.y[b]);
    for (const a of ids) for (const b of ids) if (a < b) expect(between(a, b)).toBeGreaterThan(0.85 * width);
    expect(Math.abs(momentum(world).x)).toBeLessThan(COUNT * (precision === 'f32' ? 1e-3 : 1e-10));
  });

  it.each(SHAPES)('%s part as well while all of them fly', (_, shape) => {
    const world = rigidWorld({ precision, forces: [] });
    const ids = crowd({ world, shape, at: { position: {}, velocity: { x: 40 } } });
    const { Velocity } = world.components;
    for (let i = 0; i < 60; i++) {
      step(world, DT);
      for (const id of ids) expect(Math.hypot(Velocity.x[id] - 40, Velocity.y[id])).toBeLessThan(PUSHED);
    }
    const { x } = momentum(world);
    const mass = ids.reduce((sum, id) => sum + world.components.Mass.value[id], 0);
    expect(x / mass).toBeCloseTo(40, precision === 'f32' ? 3 : 9);
  });

  it.each(SHAPES)('%s on the ground gain no energy', (_, shape) => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -1 }, collider: { shape: box(900, 2), friction: 0.6 } });
    const ids = crowd({ world, shape, at: { position: { x: 3, y: 0.5 } } });
    const { Position, Velocity } = world.components;
    let highest = 0;
    for (let i = 0; i < 240; i++) {
      step(world, DT);
      for (const id of ids) {
        highest = Math.max(highest, Position.y[id]);
        // Bodies that were lifted may fall again.
        const fastest = Math.hypot(PUSHED, Math.sqrt(2 * 10 * highest));
        expect(Math.hypot(Velocity.x[id], Velocity.y[id])).toBeLessThan(fastest);
      }
    }
  });

  it.each(SHAPES)('%s part as well beside a wall that is static, kinematic, or moves', (_, shape) => {
    const still = { kinematic: {}, velocity: {} };
    for (const [wall, vy] of [
      [{}, 0],
      [still, 0],
      [{ ...still, velocity: { y: 2 } }, 2],
    ] as const) {
      const world = rigidWorld({ precision, forces: [], integrator: softStep({ sleepTime: 0 }) });
      spawn(world, { position: { x: 0.98 }, ...wall, collider: { shape: box(1, 6), friction: 0.6 } });
      const ids = crowd({ world, shape, at: { position: {} } });
      const { Velocity } = world.components;
      for (let i = 0; i < 120; i++) {
        step(world, DT);
        // What it has not yet carried along has its speed against it.
        const bound = Math.max(PUSHED, vy);
        for (const id of ids) expect(Math.hypot(Velocity.x[id], Velocity.y[id] - vy)).toBeLessThanOrEqual(bound);
      }
    }
  });

  it('jointed figures in one place part without flying off', () => {
    const world = rigidWorld({ precision, forces: [] });
    const collider = { shape: box(1, 0.3), density: 1 };
    const ids = Array.from({ length: 30 }, () => {
      const [a, b, c] = [0, 1, 2].map((x) => spawn(world, { position: { x }, collider })) as [number, number, number];
      // Limits and friction, as in a ragdoll.
      const joint = { limits: { lower: -0.5, upper: 0.5 }, motor: { speed: 0, max: 0.1 } };
      createJoint(world, revolute({ a, b, anchor: { x: 0.5 }, ...joint }));
      createJoint(world, revolute({ a: b, b: c, anchor: { x: 1.5 }, ...joint }));
      return [a, b, c];
    }).flat();
    const { Position, Velocity } = world.components;
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      for (const id of ids) expect(Math.hypot(Velocity.x[id], Velocity.y[id])).toBeLessThan(PUSHED);
    }
    // Stacked they would be 9 m high.
    for (const id of ids) expect(Math.hypot(Position.x[id] - 1, Position.y[id])).toBeLessThan(9);
  });

  it('circles in one place part in every direction', () => {
    const world = rigidWorld({ precision, forces: [] });
    const ids = Array.from({ length: COUNT }, () =>
      spawn(world, { position: {}, collider: { shape: circle(0.5), density: 1 } }),
    );
    for (let i = 0; i < 120; i++) step(world, DT);
    const { Position } = world.components;
    const quadrants = ids.map((id) => (Position.x[id] > 0 ? 1 : 0) + (Position.y[id] > 0 ? 2 : 0));
    for (let q = 0; q < 4; q++) expect(quadrants.filter((each) => each === q).length).toBeGreaterThan(COUNT / 8);
  });
});

// Limits of hinges that bodies hang on: they stop what turns, and give it nothing.
import {
  asleepCount,
  box,
  createJoint,
  energy,
  isAsleep,
  jointPosition,
  revolute,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

type Column = Float32Array | Float64Array;

/** A box of a chain: its size, density, hinge to the one before or the ceiling, and the limits of that. */
interface Link {
  readonly size: readonly [number, number];
  readonly density: number;
  readonly anchor: { readonly x: number; readonly y: number };
  readonly limits?: { readonly lower: number; readonly upper: number };
}

/** Light on top and heavy below: what a limit stops weighs up to twenty times as much as the bodies that it acts on. */
const CHAINS: Readonly<Record<string, readonly Link[]>> = {
  two: [
    { size: [0.3, 0.287], density: 2.31, anchor: { x: -0.803, y: -0.228 } },
    { size: [0.857, 0.945], density: 9.51, anchor: { x: 0.121, y: -0.356 }, limits: { lower: -0.032, upper: 0.19 } },
  ],
  three: [
    { size: [0.252, 0.263], density: 1.17, anchor: { x: -0.792, y: 0.19 } },
    { size: [0.284, 0.846], density: 1.17, anchor: { x: 0.59, y: -0.314 }, limits: { lower: -0.331, upper: 0.7 } },
    { size: [0.785, 1.084], density: 1.07, anchor: { x: 1.847, y: 0.44 } },
  ],
  four: [
    { size: [0.31, 1.19], density: 4.61, anchor: { x: -1.016, y: 0.492 }, limits: { lower: -0.747, upper: 0.088 } },
    { size: [0.205, 0.344], density: 1.457, anchor: { x: 0.393, y: 0.303 }, limits: { lower: -0.048, upper: 0.684 } },
    { size: [0.665, 1.186], density: 1.824, anchor: { x: 1.7, y: 0.499 }, limits: { lower: -0.578, upper: 0.033 } },
    { size: [0.671, 1.149], density: 2.613, anchor: { x: 2.742, y: 0.285 }, limits: { lower: -0.135, upper: 0.169 } },
  ],
  // A thousand times as heavy below as on top: one limit strikes, and in the next sub-step its impact must not seem to drive
  // other hinges into theirs.
  'four, the last by far the heaviest,': [
    { size: [0.186, 0.203], density: 1.696, anchor: { x: -0.918, y: 0.296 }, limits: { lower: -0.639, upper: 0.452 } },
    { size: [0.156, 0.322], density: 62.464, anchor: { x: 0.091, y: -0.214 }, limits: { lower: -0.752, upper: 0.538 } },
    { size: [0.769, 0.468], density: 22.385, anchor: { x: 2.261, y: 0.389 }, limits: { lower: -0.808, upper: 0.231 } },
    { size: [0.774, 0.873], density: 85.892, anchor: { x: 3.254, y: 0.116 }, limits: { lower: -0.459, upper: 0.015 } },
  ],
};

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each(Object.keys(CHAINS))('a chain of %s that falls into its limits loses energy and keeps to them', (name) => {
    const world = rigidWorld({ precision });
    const links = CHAINS[name] as readonly Link[];
    const ids: number[] = [];
    links.forEach(({ size: [width, height], density, anchor, limits }, i) => {
      const b = spawn(world, { position: { x: 1.2 * i }, collider: { shape: box(width, height), density, layers: 0 } });
      const upper = i === 0 ? {} : { a: ids[i - 1] as number };
      createJoint(world, revolute({ ...upper, b, anchor, ...(limits && { limits }) }));
      ids.push(b);
    });
    const { Rotation, AngularVelocity } = world.components;
    const start = energy(world).total;
    let highest = -Infinity;
    let passed = 0;
    let fastest = 0;
    for (let i = 0; i < 1200; i++) {
      step(world, DT);
      highest = Math.max(highest, energy(world).total);
      links.forEach(({ limits }, k) => {
        if (limits === undefined) return;
        const fromAbove = (column: Column) => column[ids[k] as number] - (k === 0 ? 0 : column[ids[k - 1] as number]);
        const angle = fromAbove(Rotation.angle);
        passed = Math.max(passed, limits.lower - angle, angle - limits.upper);
        fastest = Math.max(fastest, Math.abs(fromAbove(AngularVelocity.z)));
      });
    }
    // They begin at rest, so that no time has more; before, some had a metre more, and the heaviest a hundred.
    expect(highest).toBeLessThanOrEqual(start);
    // A limit is met within the sub-step, and what is left is how far the bodies fall in one, g h², times levers. Under loads a
    // thousand times as heavy as the body it holds, it may be one sub-step late.
    expect(passed).toBeLessThan(name.includes('heaviest') ? (fastest * DT) / 4 : 0.005);
  });
});

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('three rods that lie on the ground with joints at their limits come to rest and sleep', () => {
    for (let pose = 0; pose < 24; pose++) {
      const world = rigidWorld({ precision });
      spawn(world, { planeWall: { friction: 0.6 } });
      const rods = [0, 1, 2].map((i) => {
        const angle = (pose * Math.PI) / 12 + (i * 2 * Math.PI) / 3;
        return spawn(world, {
          position: { x: 0.25 * Math.cos(angle), y: 2 + 0.25 * Math.sin(angle) },
          rotation: angle,
          mass: 5,
          collider: { shape: box(0.5, 0.1), friction: 0.6, group: -1 },
        });
      });
      const limits = { lower: -0.5, upper: 0.5 };
      for (const b of rods.slice(1)) createJoint(world, revolute({ a: rods[0], b, anchor: { y: 2 }, limits }));
      run(world, 15);
      expect(asleepCount(world), `pose ${pose}`).toBe(3);
    }
  });
});

describe.each(['f32', 'f64'] as const)('beside a limit that something keeps passed, in %s', (precision) => {
  it.each([0.05, 0.2, 1, 2])('a flap rests on its limit, at %d m', (size) => {
    const world = rigidWorld({ precision });
    const place = (x: number, y: number, width: number, height: number, density: number) =>
      spawn(world, {
        position: { x: x * size, y: y * size },
        collider: { shape: box(width * size, height * size), density, friction: 0.6 },
      });
    const collider = { shape: box(6 * size, size), friction: 0.6 };
    spawn(world, { position: { x: -3 * size, y: -0.5 * size }, collider });
    const bar = place(-0.9, 0.2, 2, 0.4, 100);
    const flap = place(0.5, 0.2, 0.8, 0.3, 100);
    const raised = { lower: 0.01, upper: 1 };
    createJoint(world, revolute({ b: bar, anchor: { x: -1.9 * size, y: 0.2 * size }, limits: raised }));
    const limits = { lower: -0.3, upper: 0.5 };
    const hinge = createJoint(world, revolute({ a: bar, b: flap, anchor: { x: 0.1 * size, y: 0.2 * size }, limits }));
    // A block that does not move keeps the bar from its limit.
    const block = { shape: box(size, size), friction: 0.6 };
    spawn(world, { position: { x: -size, y: 0.87 * size }, collider: block });
    let least = 0;
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      least = Math.min(least, jointPosition(world, hinge));
    }
    expect(isAsleep(world, flap)).toBe(true);
    // Limits hold as contacts do, within the slop of 5 mm: here of an arc of 0.3 m and more, or 0.017 rad.
    expect(least).toBeGreaterThan(-0.3 - 0.017);
    expect(Math.abs(jointPosition(world, hinge) + 0.3)).toBeLessThan(0.02);
  });
});

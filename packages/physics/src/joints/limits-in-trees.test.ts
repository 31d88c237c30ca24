// Limits of hinges that bodies hang on: they stop what turns, and give it nothing.
import { box, createJoint, energy, revolute, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

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
    const { Rotation } = world.components;
    const start = energy(world).total;
    let highest = -Infinity;
    let passed = 0;
    for (let i = 0; i < 1200; i++) {
      step(world, DT);
      highest = Math.max(highest, energy(world).total);
      links.forEach(({ limits }, k) => {
        if (limits === undefined) return;
        const above = k === 0 ? 0 : (Rotation.angle[ids[k - 1] as number] as number);
        const angle = (Rotation.angle[ids[k] as number] as number) - above;
        passed = Math.max(passed, limits.lower - angle, angle - limits.upper);
      });
    }
    // They begin at rest, so that no time has more; before limits were solved with their trees, some had a metre more.
    expect(highest).toBeLessThanOrEqual(start);
    // A limit is met within the sub-step, whatever comes: what is left is how far the bodies fall in one, g h², times levers.
    expect(passed).toBeLessThan(0.005);
  });
});

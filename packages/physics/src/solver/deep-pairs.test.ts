// Two bodies that are put into each other are pushed apart, and keep next to nothing of that speed.
import { box, capsule, momentum, polygon, type Shape, softStep, spawn } from '@principia/physics';
import { expect, test } from 'vitest';
import { rigidWorld, run } from '../../../../test/support/rigid-world.ts';
import { angularMomentum } from '../diagnostics/energy.ts';

/** The speed at which overlap is pushed out, m/s. */
const PUSH = 3;

const SHAPES: Readonly<Record<string, Shape>> = {
  box: box(1, 1),
  plank: box(2, 0.5),
  triangle: polygon([
    { x: -0.5, y: -0.4 },
    { x: 0.5, y: -0.4 },
    { x: 0, y: 0.6 },
  ]),
  capsule: capsule(1, 0.3),
};

/** Where the second body begins: side by side, above, turned a little, turned by much. */
const PLACES = [
  { x: 0.2, y: 0.1, angle: 0 },
  { x: 0.1, y: 0.3, angle: 0 },
  { x: 0, y: 0.3, angle: 0.1 },
  { x: 0.3, y: 0, angle: 0.7 },
];

const cases = Object.keys(SHAPES).flatMap((name) =>
  (['f32', 'f64'] as const).flatMap((precision) => [1, 10].map((density) => ({ name, precision, density }))),
);

test.each(cases)('a $name in one of $density times its density parts from it at rest, in $precision', (each) => {
  const shape = SHAPES[each.name];
  for (const { x, y, angle } of PLACES) {
    const world = rigidWorld({ precision: each.precision, forces: [], integrator: softStep({ sleepTime: 0 }) });
    const a = spawn(world, { position: {}, collider: { shape, density: 1, friction: 0.6 } });
    const b = spawn(world, { position: { x, y }, rotation: angle, collider: { shape, density: each.density } });
    run(world, 3);
    const { Velocity: v } = world.components;
    // One pass leaves up to a third, and four what is below a fiftieth.
    expect(Math.hypot(v.x[b] - v.x[a], v.y[b] - v.y[a])).toBeLessThan(PUSH / 50);
    const rounding = each.precision === 'f32' ? 1e-5 : 1e-13;
    const total = momentum(world);
    expect(Math.hypot(total.x, total.y)).toBeLessThan(each.density * PUSH * rounding);
    expect(Math.abs(angularMomentum(world).z)).toBeLessThan(each.density * PUSH * rounding);
  }
});

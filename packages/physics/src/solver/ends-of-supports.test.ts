// What slides over the end of what carries it is carried by nothing beyond that end.
import { box, capsule, isAsleep, overlapShape, type SoftStepOptions, softStep, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

/** A ledge that ends at x = 0 with its top at y = 0, without friction. */
function ledgeWorld(precision: 'f32' | 'f64', options: SoftStepOptions = {}) {
  const world = rigidWorld({ precision, integrator: softStep(options) });
  spawn(world, { position: { x: -2, y: -0.5 }, collider: { shape: box(4, 1), friction: 0 } });
  return world;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    [0.05, 60],
    [0.1, 60],
    [0.1, 240],
    [0.5, 60],
    [1, 60],
    [1, 240],
  ])('a box of %d m that is stopped 4 cm beyond the end falls, with %d steps a second', (size, rate) => {
    const world = ledgeWorld(precision);
    const { Position, Velocity } = world.components;
    const id = spawn(world, {
      position: { x: -0.6 * size, y: size / 2 },
      velocity: { x: 0.1 },
      collider: { shape: box(size, size), density: 100, friction: 0 },
    });
    for (let k = 0; Position.x[id] < 0.04 && k < 2000; k++) step(world, 1 / rate);
    Velocity.x[id] = 0;
    run(world, 3);
    expect(isAsleep(world, id)).toBe(false);
    expect(Position.y[id]).toBeLessThan(-5);
  });

  it('a capsule, too, and a plank of which the pillars are moved apart', () => {
    const world = ledgeWorld(precision);
    const { Position, Velocity } = world.components;
    const rod = spawn(world, {
      position: { x: -0.3, y: 0.05 },
      velocity: { x: 0.1 },
      collider: { shape: capsule(0.3, 0.05), density: 100, friction: 0 },
    });
    for (let k = 0; Position.x[rod] < 0.04 && k < 2000; k++) step(world, 1 / 60);
    Velocity.x[rod] = 0;
    const pillars = [-0.2, 0.2].map((x) =>
      spawn(world, { position: { x: 9 + x, y: 5 }, collider: { shape: box(0.2, 1) } }),
    );
    const plank = spawn(world, { position: { x: 9, y: 5.52 }, collider: { shape: box(0.22, 0.04), density: 100 } });
    run(world, 1);
    expect(Position.y[plank]).toBeGreaterThan(5.5);
    Position.x[pillars[0]] -= 0.02;
    Position.x[pillars[1]] += 0.02;
    run(world, 2);
    expect(Position.y[plank]).toBeLessThan(0);
    expect(Position.y[rod]).toBeLessThan(-5);
  });

  it('what is set aside, clear of what carried it, falls at once', () => {
    const world = ledgeWorld(precision);
    const { Position } = world.components;
    const shape = box(0.06, 0.06);
    const id = spawn(world, { position: { x: -0.01, y: 0.03 }, collider: { shape, density: 100, friction: 0 } });
    run(world, 2);
    Position.x[id] = 0.035;
    expect(overlapShape(world, shape, { x: 0.035, y: 0.03 })).toEqual([id]);
    run(world, 0.5);
    // Free fall, but for the first sub-step of semi-implicit Euler's: g t²/2 (1 + h/t).
    expect(Position.y[id] - 0.03).toBeCloseTo((-G * 0.25 * (1 + 1 / 240 / 0.5)) / 2, 3);
  });

  it.each([60, 240, 960])('a box begins to tip where its centre passes the end, with %d steps a second', (rate) => {
    const world = ledgeWorld(precision, { sleepTime: 0 });
    const { Position, Rotation } = world.components;
    const [size, speed, turned] = [1, 0.02, 0.01];
    const id = spawn(world, {
      position: { x: -0.02, y: size / 2 },
      velocity: { x: speed },
      collider: { shape: box(size, size), density: 100, friction: 0 },
    });
    for (let k = 0; Rotation.angle[id] > -turned && k < 5 * rate; k++) step(world, 1 / rate);
    // Its weight turns it about its centre by m g x/I with I = m s²/6: the angle is g x³/(s² v²). An end is passed by 5 mm at most.
    const ideal = Math.cbrt((turned * size * size * speed * speed) / G);
    expect(Position.x[id]).toBeGreaterThan(0.9 * ideal);
    expect(Position.x[id]).toBeLessThan(ideal + 0.005);
  });
});

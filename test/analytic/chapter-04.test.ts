// Motion, force, work and power, in units where y points down.
import { bodies, type PhysicsWorld, positionFirstEuler, rgba, step } from '@principia/physics';
import { worldSource } from '@principia/render-core';
import { addComponent, set } from 'bitecs';
import { expect, test } from 'vitest';
import ball from '../../packages/scenes/src/examples/ch04/ball.ts';
import ballInheritsParticle from '../../packages/scenes/src/examples/ch04/ball-inherits-particle.ts';
import fallWithDrag from '../../packages/scenes/src/examples/ch04/fall-with-drag.ts';
import motionGraphs from '../../packages/scenes/src/examples/ch04/motion-graphs.ts';
import { forceOn, run, started } from '../support/laws.ts';

/** What a renderer would draw of a body: place, radii and colour. */
function drawn(world: PhysicsWorld, id: number) {
  const { position, radius, size, color } = worldSource(world);
  return { x: position.x[id], y: position.y[id], radius: radius[id], size: size[id], color: color[id] };
}

test('ch04-ball: eleven balls are drawn, where they are, as large and in the colour they were given', () => {
  const { world } = started(ball);
  const { ids, count } = bodies(world);
  const before = Array.from(ids.subarray(0, count), (id) => drawn(world, id));
  expect(worldSource(world).count).toBe(11);
  // Without a size of its own a body is drawn as large as its collider.
  expect(before[0]).toEqual({ x: 150, y: 50, radius: 20, size: 0, color: rgba(1, 0.35, 0.3) });
  step(world, 0.25);
  for (const [i, { x, y, radius, size, color }] of before.entries()) {
    if (i > 0) expect(radius).toBe(Math.min(30, Math.max(10, radius)));
    expect([size, color]).toEqual([0, i === 0 ? rgba(1, 0.35, 0.3) : rgba(0.3, 0.55, 1)]);
    // A quarter of a second is a binary fraction: only the sums are rounded, by half a unit of 512's last place.
    const now = drawn(world, ids[i]);
    expect(Math.max(Math.abs(now.x - x - 25 / 4), Math.abs(now.y - y - 15 / 4))).toBeLessThan(2 ** -44);
    expect(now).toEqual({ x: now.x, y: now.y, radius, size, color });
  }
});

test('ch04-ball-inherits-particle: a particle that is given the shape of the ball is drawn as the ball is', () => {
  const { world } = started(ballInheritsParticle);
  const [whole, particle] = bodies(world).ids;
  const { radius, size, color } = drawn(world, whole);
  addComponent(world, particle, set(world.components.Appearance, { size, color }));
  addComponent(world, particle, set(world.components.Collider, { radius }));
  expect(radius).toBe(20);
  for (let i = 0; i < 2; i++) {
    const shown = drawn(world, whole);
    expect(drawn(world, particle)).toEqual({ ...shown, y: shown.y + 200 });
    step(world, 0.25);
  }
});

test('ch04-motion-graphs: the slope of the displacement is the velocity, to the order of dt', () => {
  for (const dt of [0.1, 0.01]) {
    const { world, at, going } = started(motionGraphs);
    let last = at().x;
    run(world, 2, dt, () => {
      expect(Math.abs((at().x - last) / dt - going().x)).toBeLessThan(3 * dt);
      last = at().x;
    });
  }
});

test('ch04-fall-with-drag: v(5) = 18.3583, acceleration g e^(-t/τ), terminal speed 20', () => {
  const { world, eid, going } = started(fallWithDrag);
  run(world, 5);
  expect(going().y).toBeCloseTo(18.3583, 4);
  expect(going().y).toBeCloseTo(20 * (1 - Math.exp(-2.5)), 5);
  expect(forceOn(world, eid).y).toBeCloseTo(10 * Math.exp(-2.5), 5);
  const first = started(fallWithDrag, { integrator: positionFirstEuler });
  run(first.world, 5);
  expect(first.going().y).toBeCloseTo(18.3754, 4);
  run(world, 45);
  expect(going().y).toBeCloseTo(20, 6);
});

// Motion, force, work and power, in units where y points down.
import { createPhysicsWorld, positionFirstEuler, spawn, step } from '@principia/physics';
import { worldSource } from '@principia/render-core';
import { addComponent, set } from 'bitecs';
import { expect, test } from 'vitest';
import fallWithDrag from '../../packages/scenes/src/examples/ch04/fall-with-drag.ts';
import motionGraphs from '../../packages/scenes/src/examples/ch04/motion-graphs.ts';
import { forceOn, run, started } from '../support/laws.ts';

/** A red ball of 20 px at (150, 50) and ten blue ones of 12 to 30 px beside it, all on their way. */
const ELEVEN_BALLS = Array.from({ length: 11 }, (_, i) => {
  const radius = i === 0 ? 20 : 10 + 2 * i;
  return { x: 150 + i, y: 50, radius, color: i === 0 ? 0xffff0000 : 0xff0000ff, velocity: { x: 4 * i, y: -2 } };
});

test.each([
  ['ch04-ball: made in one call', true],
  ['ch04-ball-inherits-particle: a particle that is given a shape', false],
])('%s, eleven balls are drawn where they are, as large and in the colour they were given', (_, isWhole) => {
  const world = createPhysicsWorld({ capacity: 12 });
  for (const { x, y, radius, color, velocity } of ELEVEN_BALLS) {
    const particle = { position: { x, y }, velocity, mass: 1 };
    const shape = { collider: { radius }, appearance: { size: radius, color } };
    if (isWhole) spawn(world, { ...particle, ...shape });
    else {
      const eid = spawn(world, particle);
      const { Appearance, Collider } = world.components;
      addComponent(world, eid, set(Appearance, shape.appearance));
      addComponent(world, eid, set(Collider, shape.collider));
    }
  }
  // A quarter of a second is a binary fraction: the places are exact.
  step(world, 0.25);
  const { ids, count, position, radius, size, color } = worldSource(world);
  expect(count).toBe(11);
  const drawn = Array.from(ids.subarray(0, count), (id) => [
    position.x[id],
    position.y[id],
    radius[id],
    size[id],
    color[id],
  ]);
  expect(drawn).toEqual(ELEVEN_BALLS.map((ball, i) => [150 + 2 * i, 49.5, ball.radius, ball.radius, ball.color]));
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

import { bodies, nearestPoint, step } from '@principia/physics';
import { dragBodies } from '@principia/shell';
import { expect, it } from 'vitest';
import { settings } from './settings.ts';
import { applyValue, blast, createSim, dropBlock, report, throwBall } from './sim.ts';

const VALUES = { build: 'tower', count: 90, gravity: 9.81, friction: 0.6, restitution: 0 };
const make = (values: Partial<typeof VALUES> = {}) => createSim({ values: { ...VALUES, ...values }, seed: 1 });

function run(sim: ReturnType<typeof make>, seconds: number) {
  for (let i = 0; i < seconds / sim.dt; i++) step(sim.world, sim.dt);
  return sim;
}

const heights = ({ world }: ReturnType<typeof make>) => {
  const { ids, count } = bodies(world);
  return Array.from(ids.subarray(0, count), (id) => world.components.Position.y[id]);
};

it.each(['tower', 'pyramid'])('a %s stands for ten seconds and falls asleep', (build) => {
  const sim = make({ build });
  const before = heights(sim);
  run(sim, 10);
  const sunk = before.map((y, i) => y - heights(sim)[i]);
  // Every contact may close its gap of 2 mm and overlap by the slop of 5 mm; there are at most 20 of them on top of each other.
  expect(Math.max(...sunk.map(Math.abs))).toBeLessThan(20 * 0.007);
  const { bodies: total, asleep } = report(sim);
  expect(asleep).toBe(total - 1);
});

it('a row of dominoes falls, each by the one before it', () => {
  const sim = run(make({ build: 'dominoes', count: 30 }), 20);
  const standing = heights(sim).filter((y) => y > 0.45).length;
  expect(standing).toBe(0);
});

it('a bridge of hinged planks carries its load', () => {
  const sim = run(make({ build: 'bridge' }), 5);
  expect(
    heights(sim)
      .filter((y) => y > 0)
      .every((y) => y > 1),
  ).toBe(true);
});

it('a ball and a blast knock over what stood, and a block lands on top', () => {
  for (const act of [throwBall, blast]) {
    const sim = run(make(), 1);
    const top = Math.max(...heights(sim));
    act(sim);
    run(sim, 4);
    expect(Math.max(...heights(sim))).toBeLessThan(0.9 * top);
  }
  const sim = run(make({ build: 'pyramid' }), 1);
  const top = Math.max(...heights(sim));
  dropBlock(sim);
  run(sim, 0.9);
  expect(Math.max(...heights(sim))).toBeGreaterThan(top);
});

it('a full world takes no more bodies and goes on', () => {
  const sim = make({ count: 10 });
  for (let i = 0; i < 3000; i++) throwBall(sim);
  expect(report(sim).bodies).toBeLessThan(sim.world.capacity);
  step(sim.world, sim.dt);
});

it('a dragged body follows its pointer, pushes others, and is thrown', () => {
  const sim = make({ build: 'pyramid', count: 10 });
  const { world } = sim;
  const dragging = dragBodies(world);
  const { body } = nearestPoint(world, { x: -1.2, y: 0.2 }, { mask: 1 }) as { body: number };
  const { Position, Velocity } = world.components;
  dragging.grab(1, body, Position.x[body], Position.y[body]);
  dragging.move(1, -4, 2);
  run(sim, 0.5);
  expect(Position.x[body]).toBeCloseTo(-4, 2);
  expect(Position.y[body]).toBeCloseTo(2, 2);
  dragging.release(1, 0, 5);
  step(world, sim.dt);
  expect(Velocity.y[body]).toBeCloseTo(5 - 9.81 / 60, 2);
});

it('applies gravity and the surface of bodies while running, and asks for a new world for a new build', () => {
  const sim = make();
  const values = { ...VALUES, gravity: 1, friction: 0.1, restitution: 0.5 };
  for (const name of ['gravity', 'friction', 'restitution']) expect(applyValue(sim, name, values)).toBe(true);
  for (const name of ['build', 'count']) expect(applyValue(sim, name, values)).toBe(false);
  expect(Object.values(settings.build.choices)).toContain(VALUES.build);
  expect(sim.world.components.Collider.friction[sim.ground]).toBeCloseTo(0.1, 6);
});

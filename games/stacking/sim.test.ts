import { bodies, nearestPoint, step } from '@principia/physics';
import { dragBodies } from '@principia/shell';
import { describe, expect, it } from 'vitest';
import { cutAlong } from './cut.ts';
import { join } from './join.ts';
import { sceneOf } from './saved-scene.ts';
import { readScene, writeScene } from './scene-link.ts';
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

it('as many balls of a cradle leave as come, and they swing for twenty seconds', () => {
  const sim = make({ build: 'cradles', count: 5 });
  const { Velocity, Mass } = sim.world.components;
  const { ids, count } = bodies(sim.world);
  const balls = Array.from(ids.subarray(0, count)).filter((id) => id !== sim.ground && Mass.value[id] > 0);
  // 2.4 m long, a quarter of a period is 0.79 s at 40 degrees.
  run(sim, 1);
  expect(balls.map((id) => Math.abs(Velocity.x[id]) > 0.5)).toEqual([false, false, false, false, true]);
  const fastest = () => {
    let most = 0;
    for (let i = 0; i < 200; i++) {
      step(sim.world, sim.dt);
      for (const id of balls) most = Math.max(most, Math.abs(Velocity.x[id]));
    }
    return most;
  };
  const start = fastest();
  run(sim, 14);
  expect((fastest() / start) ** 2).toBeGreaterThan(0.95);
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

describe('tools', () => {
  const total = ({ world }: ReturnType<typeof make>) => {
    const { ids, count } = bodies(world);
    return Array.from(ids.subarray(0, count)).reduce((sum, id) => sum + (world.components.Mass.value[id] || 0), 0);
  };

  it('a cut makes two bodies of each that it crosses, with its mass and momentum', () => {
    const sim = run(make({ build: 'pyramid', count: 10 }), 0.1);
    const { world } = sim;
    const before = { count: report(sim).bodies, mass: total(sim) };
    // Through the whole lowest row of four bricks of 40 cm height.
    expect(cutAlong(world, { x: -3, y: 0.17 }, { x: 3, y: 0.19 })).toBe(4);
    expect(report(sim).bodies).toBe(before.count + 4);
    expect(total(sim)).toBeCloseTo(before.mass, 3);
    run(sim, 1);
    expect(world.faults.faults).toEqual([]);
    // A line that ends before a body crosses nothing.
    expect(cutAlong(world, { x: -3, y: 30 }, { x: 3, y: 30 })).toBe(0);
  });

  it('a hinge to the world holds a body up, a motor turns it, and a weld keeps two together', () => {
    const sim = make({ build: 'mixed', count: 10 });
    const { world } = sim;
    const { Position, AngularVelocity } = world.components;
    const { ids } = bodies(world);
    const free = Array.from(ids.subarray(0, 10));
    const heights = free.map((id) => Position.y[id]);
    const [hung, turned] = [free[9], free[6]];
    expect(join(world, 'hinge', { x: Position.x[hung], y: Position.y[hung] })).toBeGreaterThan(0);
    expect(join(world, 'motor', { x: Position.x[turned], y: Position.y[turned] })).toBeGreaterThan(0);
    expect(join(world, 'weld', { x: 100, y: 100 })).toBe(0);
    run(sim, 2);
    expect(Position.y[hung]).toBeCloseTo(heights[9], 2);
    expect(Math.abs(AngularVelocity.z[turned])).toBeGreaterThan(1);
    expect(report(sim).joints).toBe(2);
  });

  it('a scene comes back from its link, joints included, and a broken link gets a sentence', async () => {
    const sim = run(make({ build: 'bridge', count: 30 }), 0.5);
    join(sim.world, 'motor', { x: sim.world.components.Position.x[5], y: sim.world.components.Position.y[5] });
    const scene = sceneOf(sim.world, sim.ground);
    const text = await writeScene(scene);
    expect(text.length).toBeLessThan(2500);
    const copy = createSim({ values: { ...VALUES, build: 'tower' }, seed: 1, scene: await readScene(text) });
    expect(report(copy)).toMatchObject({ bodies: report(sim).bodies, joints: report(sim).joints });
    expect(total(copy)).toBeCloseTo(total(sim), 1);
    run(copy, 2);
    // The bridge still hangs.
    const { ids, count } = bodies(copy.world);
    const highest = Math.max(...Array.from(ids.subarray(0, count), (id) => copy.world.components.Position.y[id]));
    expect(highest).toBeGreaterThan(2);
    for (const wrong of ['', '1.', '9.abc', `${text.slice(0, 40)}`, '1.!!!']) {
      await expect(readScene(wrong)).rejects.toThrow(/^The scene in the address cannot be read because/);
    }
    await expect(writeScene(sceneOf(make({ count: 900 }).world, 0))).rejects.toThrow(/250 bodies at most/);
  });

  const shapes = [[0, 0.5]];
  const pair = [
    [0, 0, 1, 0, 1, 1],
    [0, 2, 1, 0, 1, 1],
  ];
  const linkOf = (a: number, b: number, kind: number) => ({
    shapes,
    bodies: pair,
    joints: [[a, b, kind, 0, 0, 0, 0, 0, 0, 0]],
  });
  it.each([
    ['a polygon of two corners', { shapes: [[2, 0, 0, 0, 1, 0]], bodies: [pair[0]], joints: [] }],
    ['an unknown shape', { shapes: [[9, 0.5]], bodies: [pair[0]], joints: [] }],
    ['half a shape', { shapes: [...shapes, [0, 1]], bodies: [[0.5, 0, 1, 0, 1, 1]], joints: [] }],
    ['a body without a place', { shapes, bodies: [[0]], joints: [] }],
    ['a body at the end of the world', { shapes, bodies: [[0, 1e12, 1, 0, 1, 1]], joints: [] }],
    ['an unknown joint', linkOf(0, 1, 99)],
    ['a joint of a body to itself', linkOf(1, 1, 0)],
  ])('a link with %s is refused in a sentence, before a game starts with it', async (_, scene) => {
    await expect(readScene(await writeScene(scene))).rejects.toThrow(
      /^The scene in the address cannot be read because it has .* that cannot be\. A tower stands instead\.$/,
    );
  });

  it('a link keeps the surface of each body; one without surfaces has those of the panel', async () => {
    const sim = make({ build: 'cradles', count: 5 });
    const scene = await readScene(await writeScene(sceneOf(sim.world, sim.ground)));
    const older = { ...scene, bodies: scene.bodies.map((body) => body.slice(0, 6)) };
    const values = { ...VALUES, friction: 0.25, restitution: 0.5 };
    const surfaces = (saved: typeof scene) => {
      const { world, ground } = createSim({ values, seed: 1, scene: saved });
      const { friction, restitution } = world.components.Collider;
      const { ids, count } = bodies(world);
      const others = Array.from(ids.subarray(0, count)).filter((id) => id !== ground);
      return others.map((id) => `${friction[id].toFixed(2)} ${restitution[id].toFixed(2)}`);
    };
    expect(surfaces(scene)).toEqual(['0.60 0.00', ...Array(5).fill('0.00 1.00')]);
    expect(surfaces(older)).toEqual(Array(6).fill('0.25 0.50'));
  });
});

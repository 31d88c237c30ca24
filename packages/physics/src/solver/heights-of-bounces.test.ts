// A body that bounces under gravity comes back as high as its restitution says, for a minute.
import { box, circle, destroyWorld, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const HEIGHT = 2;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  /** Heights to which a body of the half width 0.2 m comes back from the floor, m. */
  function apexes(shape: ReturnType<typeof circle>, restitution: number, seconds: number, dt = DT): number[] {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(10, 1), restitution } });
    const collider = { shape, density: 1, restitution };
    const body = spawn(world, { position: { y: HEIGHT + 0.2 }, collider, neverSleep: {} });
    const { Position, Velocity } = world.components;
    const heights: number[] = [];
    let rises = false;
    for (let i = 0; i < seconds / dt; i++) {
      step(world, dt);
      if (rises && Velocity.y[body] <= 0) heights.push(Position.y[body] - 0.2);
      rises = Velocity.y[body] > 0;
    }
    destroyWorld(world);
    return heights;
  }

  it.each([
    ['disc', circle(0.2), DT],
    ['disc', circle(0.2), DT / 2],
    ['box', box(0.4, 0.4), DT],
  ] as const)('an elastic %s', (_, shape, dt) => {
    const heights = apexes(shape, 1, 60, dt);
    // A period is 2 √(2 h/g).
    expect(heights.length).toBeGreaterThan(60 / (2 * Math.sqrt((2 * HEIGHT) / G)) - 3);
    // In each bounce the speed u is off by a h/2 times a dt/u: for 47 of them, 0.8 % of the height. And the slop is 0.25 % of it.
    for (const height of heights) expect(Math.abs(height / HEIGHT - 1)).toBeLessThan(0.0105);
  });

  it('a disc with e = 0.8 reaches e² of its height each time', () => {
    const heights = apexes(circle(0.2), 0.8, 3);
    expect(heights.length).toBeGreaterThan(2);
    for (const [i, height] of heights.slice(0, 3).entries()) {
      expect(Math.abs(height / (HEIGHT * 0.64 ** (i + 1)) - 1)).toBeLessThan(0.008);
    }
  });
});

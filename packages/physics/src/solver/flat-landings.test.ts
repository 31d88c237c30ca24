// Bodies that land flat: friction turns them, which changes the load of the two contact points, which changes friction.
import { box, spawn } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const FRICTION = 0.2;

/** A box above a slope, let go at rest, parallel to it, and its speeds down the slope and away from it. */
function dropOnSlope(precision: 'f32' | 'f64', slope: number, fall: number, width = 1, height = 1) {
  const world = rigidWorld({ precision });
  const [c, s] = [Math.cos(slope), Math.sin(slope)];
  const ground = { shape: box(200, 1), friction: FRICTION };
  spawn(world, { rotation: slope, position: { x: 0.5 * s, y: -0.5 * c }, collider: ground });
  const above = height / 2 + fall;
  const collider = { shape: box(width, height), density: 1, friction: FRICTION };
  const body = spawn(world, { rotation: slope, position: { x: -above * s, y: above * c }, collider });
  const { Velocity } = world.components;
  const down = () => -(Velocity.x[body] * c + Velocity.y[body] * s);
  const away = () => -Velocity.x[body] * s + Velocity.y[body] * c;
  return { world, down, away };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([0.25, 0.4])('a box that lands flat on a slope of %d rad is braked by Coulomb’s friction', (slope) => {
    const { world, down } = dropOnSlope(precision, slope, 0.5);
    const seconds = 1.5;
    run(world, seconds);
    // The ground takes the momentum m g cos φ t along the normal, however it comes, and friction μ times that.
    const exact = G * seconds * (Math.sin(slope) - FRICTION * Math.cos(slope));
    expect(Math.abs(down() / exact - 1)).toBeLessThan(1e-3);
  });

  it('a plank that falls flat from 5 m stays down', () => {
    const { world, away } = dropOnSlope(precision, 0.2, 5, 2, 0.2);
    let [fastest, bounce] = [0, 0];
    for (let i = 0; i < 120; i++) {
      run(world, 1 / 60);
      fastest = Math.max(fastest, -away());
      if (fastest > 9 && away() > -1) bounce = Math.max(bounce, away());
    }
    expect(fastest).toBeGreaterThan(9);
    // In one relaxing pass it left the ground at a fourteenth of its speed.
    expect(bounce).toBeLessThan(0.005 * fastest);
  });
});

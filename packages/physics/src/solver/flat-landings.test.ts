// Bodies that land flat: friction turns them, which changes the load of the two contact points, which changes friction.
import { box, contactEvents, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

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

/** From 1.1 to 35 m/s. */
const SPEEDS = Array.from({ length: 60 }, (_, k) => 1.1 + 0.57 * k);

/**
 * Bodies beside each other fly to a floor at all speeds, and reach it at all times of a step. They are hit `hits` times together, after which they turn at most at `turn`, in
 * parts of the speed over half of the width.
 */
function landFlat(precision: 'f32' | 'f64', width: number, height: number) {
  const world = rigidWorld({ precision, forces: [] });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(500, 1) } });
  const collider = { shape: box(width, height), density: 1 };
  for (const [k, speed] of SPEEDS.entries()) {
    const y = height / 2 + speed * (0.2 + DT * ((k * 0.618034) % 1));
    spawn(world, { position: { x: 3 * (k - 30), y }, velocity: { y: -speed }, collider });
  }
  const { hit } = contactEvents(world);
  const speedOfTurning = world.components.AngularVelocity.z;
  let [turn, hits] = [0, 0];
  for (let i = 0; i < 0.5 / DT; i++) {
    step(world, DT);
    hits += hit.count;
    for (let j = 0; j < hit.count; j++) {
      turn = Math.max(turn, (Math.abs(speedOfTurning[hit.b[j]]) * width) / (2 * hit.speed[j]));
    }
  }
  return { turn, hits };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    ['box', 1, 1],
    ['plank', 2, 0.2],
  ])('a %s that lands flat does not turn, and is hit once', (_, width, height) => {
    const { turn, hits } = landFlat(precision, width, height);
    expect(hits).toBe(SPEEDS.length);
    // An impulse at one point moves the other by c of what it moves this one, and each pass over both leaves c² of what is wrong. The first
    // one turns the body at up to its speed; three more follow.
    const yields = (3 * width ** 2) / (width ** 2 + height ** 2);
    const c = (yields - 1) / (yields + 1);
    const rounding = precision === 'f32' ? 1e-5 : 1e-12;
    expect(turn).toBeLessThan(c ** 6 + rounding);
  });

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

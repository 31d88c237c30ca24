// A disc that slides, and a car that rolls, round the inside of a closed chain, by several of its segments in a step.
import {
  box,
  createJoint,
  destroyWorld,
  energy,
  type PhysicsWorld,
  type Precision,
  softStep,
  spawn,
  spawnChain,
  step,
  wheel,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { rigidWorld } from '../../../../test/support/rigid-world.ts';

const DT = 1 / 60;

/** A world without gravity and sleep, with a closed chain of `count` segments on a circle about the origin. */
function loopWorld(precision: Precision, radius: number, count: number, friction: number): PhysicsWorld {
  const world = rigidWorld({ precision, capacity: 600, forces: [], integrator: softStep({ sleepTime: 0 }) });
  const points = Array.from({ length: count }, (_, i) => {
    const angle = (-2 * Math.PI * (i + 0.5)) / count - Math.PI / 2;
    return { x: radius * Math.cos(angle), y: radius * Math.sin(angle) };
  });
  spawnChain(world, points, { friction }, { closed: true });
  return world;
}

/** Steps until a body has gone round the origin once, at most a thousand times. Returns the number of steps. */
function goRound(world: PhysicsWorld, body: number, check = () => {}): number {
  const { x, y } = world.components.Position;
  let turned = 0;
  let steps = 0;
  for (let angle = Math.atan2(y[body], x[body]); turned < 2 * Math.PI && steps < 1000; steps++) {
    step(world, DT);
    const now = Math.atan2(y[body], x[body]);
    turned += Math.atan2(Math.sin(now - angle), Math.cos(now - angle));
    angle = now;
    check();
  }
  return steps;
}

/** A car of 390 kg on two wheels of 30 kg with springs, at the lowest point of a loop. */
function addCar(world: PhysicsWorld, radius: number, low: number, speed: number): number {
  const body = spawn(world, {
    position: { y: low + 0.9 },
    velocity: { x: speed },
    angularVelocity: { z: speed / radius },
    collider: { shape: box(2.6, 0.3), density: 500, friction: 1 },
  });
  for (const x of [-1.2, 1.2]) {
    const anchor = { x, y: -Math.sqrt(radius * radius - x * x) + 0.42 };
    const disc = spawn(world, {
      position: anchor,
      rotation: 0,
      velocity: { x: speed },
      angularVelocity: { z: -speed / 0.4 },
      collider: { radius: 0.4, density: 60, friction: 1 },
    });
    const spring = { hertz: 8, dampingRatio: 1 };
    createJoint(world, wheel({ a: body, b: disc, anchor, spring, limits: { lower: -0.3, upper: 0.3 } }));
  }
  return body;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  test.each([
    [5, 20, 64],
    [5, 20, 256],
    [5, 12, 128],
    [5, 12, 512],
    [10, 15, 512],
    [20, 30, 128],
    [20, 30, 512],
  ])('on a circle of %i m at %i m/s, %i segments take from it what their corners do', (radius, speed, count) => {
    const world = loopWorld(precision, radius, count, 0);
    const low = -radius * Math.cos(Math.PI / count) + 0.2;
    const disc = spawn(world, { position: { y: low }, velocity: { x: speed }, collider: { radius: 0.2, density: 10 } });
    const before = energy(world).total;
    const { x, y } = world.components.Position;
    const steps = goRound(world, disc, () => {
      expect(Math.hypot(x[disc], y[disc]) + 0.2).toBeLessThan(radius + 0.01);
    });
    // Each corner of the angle β takes the part sin² β of the energy, without friction and bounces. A disc that lies on several corners at
    // once may be turned by two of them at once.
    const corner = (2 * Math.PI) / count;
    const kept = energy(world).total / before;
    expect(kept).toBeLessThan(Math.cos(corner) ** (2 * count) + 0.01);
    expect(kept).toBeGreaterThan(Math.cos(corner) ** (2 * count) - 0.03);
    // It is never stopped on its way: it takes as long as at the speed that it has in the end, at most.
    expect(steps * DT).toBeLessThan((2 * Math.PI * radius) / (speed * Math.sqrt(kept)) + 2 * DT);
    destroyWorld(world);
  });

  test.each([
    [5, 20, 64],
    [5, 20, 512],
    [5, 12, 256],
    [10, 15, 128],
    [20, 30, 512],
  ])(
    'a car without a motor goes round a loop of %i m at %i m/s on %i segments, and is not faster then',
    (radius, speed, count) => {
      const world = loopWorld(precision, radius, count, 1);
      const car = addCar(world, radius, -radius * Math.cos(Math.PI / count), speed);
      const before = energy(world).total;
      const steps = goRound(world, car);
      const kept = energy(world).total / before;
      // It lands on its wheels at first, and the springs are damped: what it keeps follows from no formula. It was stopped, or gained.
      expect(kept).toBeLessThan(1);
      expect(kept).toBeGreaterThan(0.7);
      expect(steps * DT).toBeLessThan((2 * Math.PI * radius) / (speed * Math.sqrt(0.7)));
      destroyWorld(world);
    },
  );
});

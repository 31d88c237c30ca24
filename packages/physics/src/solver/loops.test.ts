// A disc that slides round the inside of a closed chain, by several of its segments in a step.
import { destroyWorld, energy, softStep, spawn, spawnChain, step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { rigidWorld } from '../../../../test/support/rigid-world.ts';

const DT = 1 / 60;

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
    const world = rigidWorld({ precision, capacity: 600, forces: [], integrator: softStep({ sleepTime: 0 }) });
    const points = Array.from({ length: count }, (_, i) => {
      const angle = (-2 * Math.PI * (i + 0.5)) / count - Math.PI / 2;
      return { x: radius * Math.cos(angle), y: radius * Math.sin(angle) };
    });
    spawnChain(world, points, {}, { closed: true });
    const low = -radius * Math.cos(Math.PI / count) + 0.2;
    const disc = spawn(world, { position: { y: low }, velocity: { x: speed }, collider: { radius: 0.2, density: 10 } });
    const before = energy(world).total;
    const { x, y } = world.components.Position;
    let turned = 0;
    let steps = 0;
    for (let angle = Math.atan2(y[disc], x[disc]); turned < 2 * Math.PI && steps < 1000; steps++) {
      step(world, DT);
      const now = Math.atan2(y[disc], x[disc]);
      turned += Math.atan2(Math.sin(now - angle), Math.cos(now - angle));
      angle = now;
      expect(Math.hypot(x[disc], y[disc]) + 0.2).toBeLessThan(radius + 0.01);
    }
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
});

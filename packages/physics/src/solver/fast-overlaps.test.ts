// What is very fast and is found inside others, as after it has passed through what bullets do not, is pushed out, and no energy is
// gained: contacts without restitution only take.
import { box, destroyWorld, energy, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([40, 100, 300])('a box of %d m/s inside two stacked boxes makes no energy', (speed) => {
    for (let x = -0.4; x < 0.5; x += 0.2) {
      for (let y = 0.4; y < 1.9; y += 0.2) {
        const world = rigidWorld({ precision, capacity: 10 });
        spawn(world, { position: { y: -1 }, collider: { shape: box(60, 2), friction: 0.6 } });
        for (const height of [0.5, 1.5]) {
          spawn(world, { position: { y: height }, collider: { shape: box(1, 1), density: 1, friction: 0.3 } });
        }
        const collider = { shape: box(0.5, 0.5), density: 4, friction: 0.6 };
        spawn(world, { position: { x, y }, velocity: { x: speed }, collider });
        const start = energy(world).kinetic;
        // Overlap of half a metre lifts what is above by as much: 3 kg by 0.5 m, 15 J.
        const lift = 3 * G * 0.5;
        for (let i = 0; i < 10; i++) {
          step(world, DT);
          expect(energy(world).kinetic).toBeLessThan(start + lift);
        }
        destroyWorld(world);
      }
    }
  });
});

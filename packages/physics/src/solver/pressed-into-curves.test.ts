// What is pressed against the inside of a curve at many times its weight sinks in while it slides, and never comes out at the other side.
import { box, capsule, spawn, spawnChain, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const RADIUS = 2;
const SEGMENTS = 40;
const SHAPES = [
  ['a capsule', capsule(0.2, 0.1)],
  ['a longer capsule', capsule(0.6, 0.1)],
  ['a rounded box', box(0.4, 0.2, { rounding: 0.09 })],
] as const;

/** Walked along, the inside is on the right. */
const ring = Array.from({ length: SEGMENTS }, (_, i) => {
  const angle = (-2 * Math.PI * i) / SEGMENTS;
  return { x: RADIUS * Math.cos(angle), y: RADIUS * Math.sin(angle) };
});

test.each(SHAPES)('%s at 20 to 100 times its weight stays in a ring, and goes round', (_, shape) => {
  for (const speed of [20, 25, 30, 45]) {
    for (const bullet of [false, true]) {
      const world = rigidWorld();
      spawnChain(world, ring, { friction: 0 }, { closed: true });
      const position = { x: 0.02, y: 0.14 - RADIUS };
      const body = spawn(world, {
        position,
        velocity: { x: speed },
        collider: { shape, density: 1, friction: 0, bullet },
      });
      const { x, y } = world.components.Position;
      let turned = 0;
      let angle = Math.atan2(y[body], x[body]);
      for (let i = 0; i < 120; i++) {
        step(world, DT);
        expect(Math.hypot(x[body], y[body])).toBeLessThan(RADIUS);
        const now = Math.atan2(y[body], x[body]);
        turned += Math.atan2(Math.sin(now - angle), Math.cos(now - angle));
        angle = now;
      }
      expect(turned).toBeGreaterThan(2 * Math.PI);
    }
  }
});

// Ropes between two pins that are moved apart beyond the length of the rope, and back.
import { describe, expect, it } from 'vitest';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { movePin } from '../soft-bodies/pins.ts';
import { createRope } from '../soft-bodies/rope.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { xpbd } from './xpbd.ts';

const DT = 1 / 60;
const SUBSTEPS = 4;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    ['rods', 12],
    ['rods', 25],
    ['strings', 25],
  ] as const)('a rope of %s with %d nodes that is pulled taut stays on the line, without a jump', (kind, nodes) => {
    const forces = [uniformGravity(), springs()];
    const integrator = xpbd({ substeps: SUBSTEPS });
    const world = createPhysicsWorld({ dimensions: 2, precision, capacity: 50, integrator, forces });
    const to = { x: 0.9, y: 0.3 };
    const rope = createRope(world, {
      from: {},
      to,
      length: 1,
      nodes,
      mass: 1,
      pins: 'both',
      tensionOnly: kind === 'strings',
    });
    const end = rope.nodes.at(-1) as number;
    const { Position, Velocity } = world.components;
    for (let i = 0; i < 240; i++) {
      const part = i < 60 ? 1 + (0.3 * i) / 60 : i < 120 ? 1.3 : 1.3 - (i - 120) / 240;
      movePin(world, end, { x: 0.9 * part, y: 0.3 * part }, DT);
      step(world, DT);
      const distance = Math.hypot(Position.x[end] as number, Position.y[end] as number);
      for (const node of rope.nodes) {
        // No node goes further than a link in a sub-step.
        const speed = Math.hypot(Velocity.x[node] as number, Velocity.y[node] as number);
        expect(speed).toBeLessThan((1 / (nodes - 1)) * (SUBSTEPS / DT));
        const aside =
          Math.abs(0.3 * (Position.x[node] as number) - 0.9 * (Position.y[node] as number)) / Math.hypot(0.9, 0.3);
        // The height of an arc over the chord is at most sqrt(3/8 (length - chord) chord), and half the length.
        const sag = Math.sqrt(Math.max(0, 0.375 * (1 - distance) * distance));
        expect(aside).toBeLessThan(1.2 * sag + 0.01);
      }
    }
  });
});

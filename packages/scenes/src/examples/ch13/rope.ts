import { createPhysicsWorld, keepState, pin, rungeKutta4, unpin } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { addRope, ROPE, ropeForces } from '../support/heavy-rope.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

export default defineExample({
  id: 'ch13-rope',
  title: 'Let go of the end of a rope',
  chapter: 13,
  tags: ['rope', 'spring', 'soft bodies'],
  about:
    'Fifteen heavy beads on springs make a rope. Held at both ends it sags in a curve; let go, its end swings down. Hanging straight, each spring is stretched by the weight of all beads below it, so the upper links are longer than the lower ones.',
  duration: 120,
  parameters: {
    release: { label: 'Let go after', unit: 's', initial: 60, min: 0, max: 120 },
    stiffness: { label: 'Stiffness of a link', unit: 'N/m', initial: 500, min: 200, max: 2000 },
    drag: { label: 'Drag of a bead', unit: 'kg/s', initial: 5, min: 1, max: 20 },
  },
  presets: [{ label: 'Let go at once', values: { release: 0 } }],
  build({ release, stiffness, drag }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 50, forces: ropeForces(), integrator });
    const beads = addRope(world, stiffness, drag);
    const end = beads[beads.length - 1];
    const hand = { mass: pin(world, end) };
    keepState(world, hand);
    const letGo = () => {
      if (hand.mass > 0) unpin(world, end, hand.mass);
      hand.mass = 0;
    };
    world.phases.input.push(() => {
      if (hand.mass > 0 && world.time > release - 1e-6) letGo();
    });
    return { world, dt: 1 / 60, beads, end, hand, letGo };
  },
  picture({ world, end, hand }) {
    return {
      yDown: true,
      view: { minX: 60, maxX: 460, minY: 80, maxY: 450 },
      springs: { coils: 5 },
      trails: [{ body: end, length: 800 }],
      dots: [{ at: ROPE.support, radius: 7, color: COLORS.grey }],
      labels: [
        {
          at: () => ({ x: positionOf(world, end).x + 10, y: positionOf(world, end).y - 12 }),
          text: () => (hand.mass > 0 ? 'held' : ''),
        },
      ],
    };
  },
  actions: { action: { label: 'Let go', about: 'let go of the end', key: 'l', press: ({ letGo }) => letGo() } },
  plots: (plot) => [
    plot(
      'Depth of the middle and of the end',
      'y, px',
      { label: 'middle', value: ({ world, beads }) => positionOf(world, beads[7]).y },
      { label: 'end', value: ({ world, end }) => positionOf(world, end).y },
    ),
  ],
  checks: ({ at }) => [
    at(
      59,
      'Middle bead of the rope held at both ends, x',
      { exact: 260.9, unit: 'px', absolute: 0.05 },
      ({ world, beads }) => positionOf(world, beads[7]).x,
    ),
    at(
      59,
      'Middle bead of the rope held at both ends, y',
      { exact: 159.757, unit: 'px', absolute: 0.05 },
      ({ world, beads }) => positionOf(world, beads[7]).y,
    ),
    at(
      120,
      'End of the rope that hangs down, 100 + 300 + 24',
      { exact: 424, unit: 'px', absolute: 0.05 },
      ({ world, end }) => positionOf(world, end).y,
    ),
    at(
      120,
      'Stretch of its uppermost spring but one, 14 m g/k',
      {
        exact: ({ stiffness }) => (14 * ROPE.mass * ROPE.gravity) / stiffness,
        unit: 'px',
        absolute: 0.05,
        preset: 'Let go at once',
      },
      ({ world, beads }) => distanceBetween(positionOf(world, beads[1]), positionOf(world, beads[0])) - ROPE.length,
    ),
  ],
  tryThis: [
    'Choose “Let go at once”: watch the end crack like a whip when the rope is straight below.',
    'Make the links softer: the rope sags lower, and its upper links get longer.',
  ],
});

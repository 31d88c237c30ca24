import { createPhysicsWorld, rgba, rungeKutta4, spawn, thrust } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow } from '../support/arrows.ts';
import { addRope, ROPE, ropeForces } from '../support/heavy-rope.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

export default defineExample({
  id: 'ch13-rope-pull',
  title: 'Pull a rope',
  chapter: 13,
  tags: ['rope', 'spring', 'soft bodies', 'drag the mouse'],
  about:
    'The last bead of the rope is drawn towards the blue grip, 50 N for each pixel of distance. Drag the grip: the rope follows. At rest the pull of the grip and the pull of the last link are equal: if the grip is far away the link is long.',
  duration: 60,
  parameters: {
    x: { label: 'Grip at x', unit: 'px', initial: 380, min: 100, max: 600 },
    y: { label: 'Grip at y', unit: 'px', initial: 330, min: 60, max: 480 },
    pull: { label: 'Pull of the grip', unit: 'N/px', initial: 50, min: 5, max: 200 },
  },
  presets: [{ label: 'Far away', values: { x: 600, y: 120 } }],
  build({ x, y, pull }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 50, forces: [...ropeForces(), thrust()], integrator });
    const stiffness = 500;
    const beads = addRope(world, stiffness, 5);
    const end = spawn(world, {
      position: { x: ROPE.support.x + 20 * (ROPE.count + 1), y: ROPE.support.y },
      velocity: {},
      mass: ROPE.mass,
      linearDrag: 5,
      // The pull of the grip takes the place of the weight of the last bead.
      thrust: { y: -ROPE.mass * ROPE.gravity },
      collider: 6,
      appearance: rgba(1, 0.5, 0.4),
    });
    const before = beads[beads.length - 1];
    spawn(world, { spring: { a: before, b: end, stiffness, damping: 20, length: ROPE.length } });
    const grip = spawn(world, { position: { x, y }, velocity: {}, collider: 9, appearance: rgba(0.4, 0.65, 1) });
    spawn(world, { spring: { a: grip, b: end, stiffness: pull } });
    const [at, from, to] = [end, before, grip].map((id) => () => positionOf(world, id));
    const gripForce = () => pull * distanceBetween(at(), to());
    const linkForce = () => stiffness * (distanceBetween(at(), from()) - ROPE.length);
    return { world, dt: 1 / 60, end, grip, before, gripForce, linkForce };
  },
  picture({ world, end, grip, before, linkForce, gripForce }) {
    const towards = (id: number, force: () => number) => () => {
      const [at, there] = [positionOf(world, end), positionOf(world, id)];
      const share = force() / Math.max(distanceBetween(at, there), 1e-9);
      return { x: share * (there.x - at.x), y: share * (there.y - at.y) };
    };
    return {
      yDown: true,
      view: { minX: 60, maxX: 640, minY: 60, maxY: 490 },
      springs: 'lines',
      dots: [{ at: ROPE.support, radius: 7, color: COLORS.grey }],
      arrows: [
        forceArrow(world, end, 'rope', towards(before, linkForce), 0.04),
        { ...forceArrow(world, end, 'grip', towards(grip, gripForce), 0.04), color: COLORS.violet },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Pulls on the last bead',
      'force, N',
      { label: 'grip', value: ({ gripForce }) => gripForce() },
      { label: 'rope', value: ({ linkForce }) => linkForce() },
    ),
  ],
  checks: ({ at }) => [
    at(
      60,
      'Pull of the rope by that of the grip, at rest',
      { exact: () => 1, relative: 0.01 },
      ({ linkForce, gripForce }) => linkForce() / gripForce(),
    ),
    at(
      60,
      'The same with the grip far away',
      { exact: 1, relative: 0.01, preset: 'Far away' },
      ({ linkForce, gripForce }) => linkForce() / gripForce(),
    ),
  ],
  tryThis: [
    'Drag the grip to and fro: waves run up the rope and come back.',
    'Choose “Far away”: the rope is nearly straight, and its links are much longer than before.',
  ],
});

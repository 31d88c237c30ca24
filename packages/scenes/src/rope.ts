// A rope hung between two points, longer than the gap, with its middle pulled down: when released, it swings and
// settles into a catenary.
import { createPhysicsWorld, createRope, linearDrag, springs, uniformGravity, xpbd } from '@principia/physics';
import { countOf, defineScene } from './scene.ts';
import { shake } from './shake.ts';
import { threadStretch } from './stretch.ts';

/** Length of the rope and distance of its ends, m. */
const LENGTH = 10;
const GAP = 8;
/** Initial depth of its middle, m: both halves are straight. */
const DEPTH = Math.sqrt(LENGTH * LENGTH - GAP * GAP) / 2;

/** An inextensible rope hung between two points. */
export const rope = defineScene({
  name: 'rope',
  description: 'an inextensible rope hung between two points',
  precision: 'f32',
  parameters: {
    count: countOf('nodes', 1000, 100_000, 2),
    mass: { about: 'mass of the rope', unit: 'kg', initial: 1, min: 0.01, max: 1000 },
    drag: { about: 'drag of a node by its mass', unit: '1/s', initial: 0.5, min: 0, max: 20 },
    push: { about: 'largest initial speed of a node along an axis', unit: 'm/s', initial: 0.05, min: 0, max: 10 },
    substeps: countOf('sub-steps of a step', 4, 100),
    iterations: countOf('iterations of a sub-step where the rope cannot be solved directly', 10, 100),
  },
  build({ dimensions, precision, seed, parameters }) {
    const { count, mass, drag, push, substeps, iterations } = parameters;
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: 4 * count,
      integrator: xpbd({ substeps, iterations }),
      forces: [uniformGravity(), linearDrag(), springs()],
    });
    const { nodes } = createRope(world, {
      from: {},
      to: { x: GAP },
      length: LENGTH,
      nodes: count,
      mass,
      pins: 'both',
      components: { linearDrag: (drag * mass) / count },
    });
    const { y } = world.components.Position;
    nodes.forEach((node, i) => {
      const along = (2 * i) / (count - 1) - 1;
      y[node] = DEPTH * (Math.abs(along) - 1);
    });
    shake(world, nodes, push, seed);
    return {
      world,
      dt: 1 / 60,
      stretch: threadStretch,
      losesEnergy: 'air drag and inelastic tightening of the rope dissipate energy',
    };
  },
});

// A square cloth hung by its upper edge, in a breeze (3D). In 2D it hangs as a net in still air.
import {
  clothWind,
  createCloth,
  createPhysicsWorld,
  linearDrag,
  sin,
  springs,
  uniformGravity,
  xpbd,
} from '@principia/physics';
import { countOf, defineScene } from './scene.ts';
import { shake } from './shake.ts';
import { threadStretch } from './stretch.ts';

/** Edge of the cloth, m. */
const SIZE = 2;

/** A cloth hung by its upper edge in a breeze. */
export const cloth = defineScene({
  name: 'cloth',
  description: 'a cloth hung by its upper edge in a breeze',
  precision: 'f32',
  parameters: {
    count: countOf('nodes', 10_000, 1_000_000, 4),
    mass: { about: 'mass of the cloth', unit: 'kg', initial: 0.8, min: 0.01, max: 100 },
    shear: { about: 'stiffness against shear', unit: 'N/m', initial: 1000, min: 0, max: 1e6 },
    bend: { about: 'stiffness against bending', unit: 'N/m', initial: 10, min: 0, max: 1e6 },
    wind: { about: 'speed of the breeze', unit: 'm/s', initial: 2, min: 0, max: 30 },
    drag: { about: 'drag of a node by its mass', unit: '1/s', initial: 0.5, min: 0, max: 20 },
    substeps: countOf('sub-steps of a step', 4, 100),
    iterations: countOf('iterations of a sub-step', 1, 100),
  },
  build({ dimensions, precision, seed, parameters }) {
    const { count, mass, shear, bend, wind, drag, substeps, iterations } = parameters;
    const columns = Math.max(2, Math.floor(Math.sqrt(count)));
    const rows = Math.max(2, Math.floor(count / columns));
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: 8 * columns * rows,
      integrator: xpbd({ substeps, iterations }),
      forces: [uniformGravity(), linearDrag(), springs()],
    });
    const sheet = createCloth(world, {
      corner: {},
      columns,
      rows,
      spacing: SIZE / columns,
      mass,
      shear,
      bend,
      components: { linearDrag: (drag * mass) / (columns * rows) },
    });
    shake(world, sheet.nodes, 0.02, seed);
    if (dimensions === 3) {
      const now = { x: 0, y: 0, z: 0 };
      const breeze = (time: number) => {
        now.z = wind * (0.6 + 0.4 * sin(2 * time));
        now.x = 0.3 * wind * sin(0.7 * time);
        return now;
      };
      world.forces.push(clothWind({ triangles: sheet.triangles, velocity: breeze }));
    }
    return {
      world,
      dt: 1 / 60,
      stretch: threadStretch,
      losesEnergy: 'air drag and inelastic tightening of threads dissipate energy',
    };
  },
});

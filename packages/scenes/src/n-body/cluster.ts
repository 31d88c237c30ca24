// A star cluster in equilibrium, by direct summation and by the tree: a Plummer sphere in 3D, a Kuzmin disc in 2D.
// N-body units (Heggie & Mathieu 1986): G = 1, mass 1, virial radius 1, so the energy is -1/4 and the crossing time 2√2
// s.
import {
  createPhysicsWorld,
  type DistanceLaw,
  type MutualForce,
  mutualGravity,
  type PhysicsWorld,
  pow,
  rgba,
  spawnMany,
  velocityVerlet,
} from '@principia/physics';
import { countOf, defineScene, type SceneRun, type Setup } from '../scene.ts';
import { inDimensions, kuzminDisc, plummerSphere } from './stars.ts';

/** A scene with a mutual force. */
export interface ClusterRun extends SceneRun {
  readonly gravity: MutualForce;
  readonly law: DistanceLaw;
  /** RMS relative error of the forces, measured against direct summation for a sample of stars. */
  readonly forceError: (world: PhysicsWorld) => number;
}

/** Scale length of a Plummer sphere whose virial radius is 1: 3π/16. */
const SCALE = (3 * Math.PI) / 16;

export const relativeErrorParameter = {
  about: 'RMS relative error of the forces that the tree may make',
  unit: '',
  initial: 0.005,
  min: 0,
  max: 0.1,
} as const;

/**
 * The softening with the smallest error for this number of stars, in scale lengths: below it two-body relaxation
 * dominates, above it the field is biased (Dehnen, MNRAS 324, 273, 2001).
 */
function bestSoftening(count: number): number {
  return 0.98 * pow(count, -0.26);
}

interface Gravity {
  readonly gravity: MutualForce;
  readonly law: DistanceLaw;
}

function clusterOf({ dimensions, precision, seed, progress, parameters }: Setup<never>, { gravity, law }: Gravity) {
  const { count } = parameters;
  const world = createPhysicsWorld({
    dimensions,
    precision,
    seed,
    capacity: count,
    integrator: velocityVerlet,
    forces: [gravity],
  });
  const stars = dimensions === 3 ? plummerSphere(count, SCALE, seed) : kuzminDisc(law, count, SCALE, seed);
  const appearance = { color: rgba(1, 0.93, 0.8), size: 0.004 };
  spawnMany(world, count, { ...inDimensions(stars, dimensions), mass: 1 / count, appearance }, progress);
  return { world, dt: 1 / 256, gravity, law, forceError: (of: PhysicsWorld) => gravity.rmsError(of, 1000) };
}

/** A star cluster in equilibrium, all pairs summed. */
export const nbodyDirect = defineScene({
  name: 'nbody-direct',
  description: 'a star cluster in equilibrium, all pairs summed',
  precision: 'f32',
  parameters: { count: countOf('stars', 2000, 100_000) },
  build(setup): ClusterRun {
    const softening = SCALE * bestSoftening(setup.parameters.count);
    const gravity = mutualGravity({ G: 1, softening, method: 'direct' });
    return clusterOf(setup, { gravity, law: 'inverse-square' });
  },
});

/** A star cluster in equilibrium, by a Barnes-Hut tree. */
export const nbodyTree = defineScene({
  name: 'nbody-tree',
  description: 'a star cluster in equilibrium, by a Barnes-Hut tree',
  precision: 'f32',
  parameters: {
    count: countOf('stars', 100_000, 4_000_000),
    relativeError: relativeErrorParameter,
    falloff: {
      about: 'power of the distance: 2, or 1 in the plane',
      unit: '',
      initial: 2,
      min: 1,
      max: 2,
      integer: true,
    },
  },
  build(setup): ClusterRun {
    const softening = SCALE * bestSoftening(setup.parameters.count);
    const { relativeError, falloff } = setup.parameters;
    const law = falloff === 2 || setup.dimensions === 3 ? 'inverse-square' : 'inverse-distance';
    const gravity = mutualGravity({ G: 1, softening, method: 'tree', relativeError, law });
    return clusterOf(setup, { gravity, law });
  },
});

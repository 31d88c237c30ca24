// Measures the cost of resting bodies: the same world with its bodies in the air.
import { bodies, step } from '@principia/physics';
import { particles, type SceneRun } from '@principia/scenes';
import { applyVariant, type ParticlesRun } from '../particles-variants.ts';
import type { Peer } from './peer.ts';

/** Undefined where bodies do not rest. */
export function inFlight(run: SceneRun): Peer | undefined {
  const { variant, world: resting, gravity, side } = run as ParticlesRun;
  if (variant?.resting !== true) return undefined;
  const { dimensions, precision, seed, integrator } = resting;
  const { count } = bodies(resting);
  const flying = particles.create({ count, dimensions, precision, seed, integrator, gravity, side });
  const { world, dt } = applyVariant(flying, { ...variant, resting: false });
  return {
    name: 'this framework, bodies in flight',
    step: () => step(world, dt),
    positions: (axis) => world.components.Position[axis],
    differs: true,
  };
}

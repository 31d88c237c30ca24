// A steady force on each body, its own: jets, oars, a hand on the tiller.
//
//   F = T        or, with T in the body's own axes,  F = R T
//
//   T  the column Thrust, N: write it to steer    R  rotation of the body, from Rotation or Orientation
//
// No mass is spent: `rocketEngines` for that. Cost: one addition an axis; in the body's axes a sine and a cosine in 2D,
// two cross products in 3D.
import { checkKeys } from '../faults/validate';
import type { PhysicsWorld } from '../world';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { checkFrame } from './lift';

export interface ThrustOptions {
  /** Whether the vector is in axes of the world (default) or of the body. */
  readonly frame?: 'world' | 'body';
}

/** @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN */
export function thrust(options: ThrustOptions = {}): Force {
  checkKeys(options, 'thrust', ['frame']);
  const frame = checkFrame(options.frame ?? 'world', 'thrust.frame');
  return {
    name: 'thrust',
    equation: frame === 'world' ? 'F = T' : 'F = R T',
    reads: ['Thrust', ...(frame === 'body' ? ['Rotation', 'Orientation'] : [])],
    local: true,
    timeless: true,
    accumulate(world, first, last) {
      if (world.internal.counts.Thrust === 0) return;
      const { x, y, z } = world.addresses.Thrust;
      addColumns(world, x, y, z, frame, first, last);
    },
  };
}

/** Adds three columns to the force, as they are or turned with the body. */
export function addColumns(
  world: PhysicsWorld,
  x: number,
  y: number,
  z: number,
  frame: 'world' | 'body',
  first: number,
  last: number,
): void {
  const { kernels, addresses, dimensions, scratch } = world;
  const f = scratch.at.force;
  if (frame === 'world') {
    kernels.addColumn(f.x, x, first, last);
    kernels.addColumn(f.y, y, first, last);
    if (dimensions === 3) kernels.addColumn(f.z, z, first, last);
  } else if (dimensions === 2) {
    lawKernels(world).turnedForce2d(f.x, f.y, x, y, addresses.Rotation.angle, first, last);
  } else {
    const q = addresses.Orientation;
    lawKernels(world).turnedForce3d(f.x, f.y, f.z, x, y, z, q.x, q.y, q.z, q.w, first, last);
  }
}

// A force that swings with time, the same on every body with mass.
//
//   F = A cos Ωt + B sin Ωt
//
//   A, B  amplitudes, N    Ω  angular frequency, rad/s; 0 is a constant force A    t  time, s
//
// A driven oscillator of mass m, stiffness k and damping c settles to the amplitude |A|/√((k - mΩ²)² + c²Ω²): Landau
// and Lifshitz, Mechanics, section 26. For some bodies only, wrap it in `limited`. Cost: one addition an axis.
import { checkKeys, checkNumber, checkVector, type VectorInput } from '../faults/validate';
import { cos, sin } from '../math/elementary';
import { ANY } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { shownVector } from './time-vector';

export interface PeriodicDriveOptions {
  /** A, N; default none. */
  readonly cosine?: VectorInput;
  /** B, N; default none. */
  readonly sine?: VectorInput;
  /** Ω, rad/s. */
  readonly angularFrequency: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function periodicDrive(options: PeriodicDriveOptions): Force {
  checkKeys(options, 'periodicDrive', ['cosine', 'sine', 'angularFrequency']);
  const a = checkVector(options.cosine ?? {}, 'periodicDrive.cosine', ANY);
  const b = checkVector(options.sine ?? {}, 'periodicDrive.sine', ANY);
  const frequency = checkNumber(options.angularFrequency, 'periodicDrive.angularFrequency', { min: 0, max: 1e12 });
  return {
    name: 'periodic drive',
    equation: 'F = A cos Ωt + B sin Ωt',
    parameters: {
      angularFrequency: { unit: 'rad/s', value: frequency },
      ...shownVector('cosine', 'N', a),
      ...shownVector('sine', 'N', b),
    },
    reads: ['Mass'],
    local: true,
    accumulate(world, first, last, time) {
      const kernels = lawKernels(world);
      const { x, y, z } = world.scratch.at.force;
      const mass = world.addresses.Mass.value;
      const c = cos(frequency * time);
      const s = sin(frequency * time);
      kernels.pushAxis(x, mass, a.x * c + b.x * s, first, last);
      kernels.pushAxis(y, mass, a.y * c + b.y * s, first, last);
      if (world.dimensions === 3) kernels.pushAxis(z, mass, a.z * c + b.z * s, first, last);
    },
  };
}

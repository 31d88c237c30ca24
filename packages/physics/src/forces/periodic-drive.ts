// A force that oscillates with time, the same on every body with mass.
//
//   F = A cos Ωt + B sin Ωt
//
//   A, B  amplitudes, N    Ω  angular frequency, rad/s; 0 is a constant force A    t  time, s
//
// A driven oscillator of mass m, stiffness k and damping c settles to the amplitude |A|/√((k - mΩ²)² + c²Ω²): Landau
// and Lifshitz, Mechanics, section 26. To select bodies, wrap it in `restrictForce`. Cost: two operations per axis.
import { defineLaw } from '../dynamics/define-law.ts';
import type { VectorInput } from '../errors/validate.ts';
import { select, vec3 } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { ANY } from './support/bounds.ts';

/** Options of `periodicDrive`. */
export interface PeriodicDriveOptions {
  /** Amplitude A, N; default zero. */
  readonly cosine?: VectorInput;
  /** Amplitude B, N; default zero. */
  readonly sine?: VectorInput;
  /** Angular frequency Ω, rad/s. */
  readonly angularFrequency: number;
}

const law = /* @__PURE__ */ defineLaw({
  name: 'periodic drive',
  formula: 'F = A cos Ωt + B sin Ωt',
  source: 'Landau and Lifshitz, Mechanics, section 26.',
  parameters: {
    cosine: vector('N', { default: {}, ...ANY }),
    sine: vector('N', { default: {}, ...ANY }),
    angularFrequency: scalar('rad/s', { min: 0, max: 1e12 }),
  },
  force({ mass, time }, { cosine, sine, angularFrequency }) {
    const angle = angularFrequency.mul(time);
    const force = cosine.mul(angle.cos()).add(sine.mul(angle.sin()));
    return select(mass.greater(0), force, vec3(0, 0, 0));
  },
});

/**
 * A force that oscillates with time, the same on every body with mass: F = A cos Ωt + B sin Ωt, N.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function periodicDrive(options: PeriodicDriveOptions): Force {
  return law(options);
}

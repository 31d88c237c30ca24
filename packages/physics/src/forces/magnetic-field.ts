// The magnetic part of the Lorentz force in a uniform field, steady or changing with time.
//
//   F = q v × B(t)        in 2D, B = B_z normal to the plane:  F = q B_z (v_y, -v_x)
//
//   q  charge, C    v  velocity, m/s    B  flux density, T
//
// It does no work: a charge circles with radius m v/(|q| B) and period 2π m/(|q| B). As a force it works with every
// integrator, but none of them conserves the speed: with Ω = q B/m, semi-implicit and explicit Euler gain (Ω dt)²/2 of it per
// step, velocity Verlet, the default, gains (Ω dt)⁴/8, and Runge-Kutta 4 loses (Ω dt)⁶/144. With velocity Verlet the speed grows
// as e^((Ω dt)⁴ n/8) in n steps: with one turn a second and 60 steps to 2.5 times in 1000 s, with 30 steps to 4 times in 200 s.
// Rigid bodies move by semi-implicit Euler in sub-steps of h, so that the speed grows as e^(Ω² h t/2): with Ω = 1/s, four
// sub-steps and 1/60 s by a quarter in 100 s, with 5/s a hundredfold. A warning tells the rate under every integrator that changes
// the speed by more than 1 % in a minute. The integrator `boris` turns the
// velocity instead and conserves the speed to rounding for any dt: prefer it where a charge makes more than a few turns, and
// omit this force then. The electric field induced by a changing magnetic field is not included. Lorentz
// (1895); Jackson, Classical Electrodynamics, section 12.2; Birdsall and Langdon, Plasma Physics via Computer
// Simulation, section 4.3. Cost: four to twelve operations per body.
import { Charge } from '../components/charge.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { axialVectorOverTime } from '../laws/parameter.ts';
import type { VectorOverTime } from '../laws/time-vector.ts';
import type { Force } from '../world/types.ts';
import { ANY } from './support/bounds.ts';

const law = /* @__PURE__ */ defineLaw({
  name: 'magnetic field',
  formula: 'F = q v × B(t)',
  source: 'Jackson, Classical Electrodynamics, section 12.2.',
  reads: { charge: Charge },
  parameters: {
    /** Flux density B, T, or a function of time, s, that returns it; in 2D only its z is used. */
    field: axialVectorOverTime('T', ANY),
  },
  force: ({ velocity, charge }, { field }) => velocity.mul(charge).cross(field),
});

/**
 * The magnetic force on charges, in a uniform field, steady or changing with time: F = q v × B, N. It does no work,
 * but only `boris` keeps the speed exactly.
 *
 * @param field B, T, or a function of the time, s, that returns it; in 2D only its z acts
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function magneticField(field: VectorOverTime): Force {
  return law({ field });
}

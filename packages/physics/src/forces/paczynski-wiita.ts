// The pseudo-Newtonian pull of a black hole, which has the innermost stable circular orbit of a Schwarzschild hole.
//
//   F = -m μ r̂/(r - r_s)²        U = -m μ/(r - r_s)
//
//   m  mass, kg    μ = G M, m³/s²    r_s  Schwarzschild radius, m; 2 μ/c² by default    r  distance, m
//
// Circular orbits are stable beyond 3 r_s and bound beyond 2 r_s, as in general relativity; time and light are
// Newton's. At r_s and inside there is no force and no potential: the body is swallowed, and should be removed.
// Paczyński and Wiita, Astronomy and Astrophysics 88, 23 (1980). Cost: one square root, one division a body.
import { MAX_SPEED } from '../components/velocity';
import { checkKeys, checkNumber } from '../faults/validate';
import { LENGTHS, POSITIVE } from './bounds';
import { CENTRE_KEYS, type CentreOptions, centralForce, LAW, type LawParameters } from './central';
import type { Force } from './force';

export interface PaczynskiWiitaOptions extends CentreOptions {
  /** Gravitational parameter μ = G M, m³/s². */
  readonly mu: number;
  /** Schwarzschild radius r_s, m; default 2 μ/c² with the true speed of light. */
  readonly horizon?: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function paczynskiWiita(options: PaczynskiWiitaOptions): Force {
  checkKeys(options, 'paczynskiWiita', ['mu', 'horizon', ...CENTRE_KEYS]);
  const mu = checkNumber(options.mu, 'paczynskiWiita.mu', POSITIVE);
  const byDefault = (2 * mu) / (MAX_SPEED * MAX_SPEED);
  const horizon = checkNumber(options.horizon ?? byDefault, 'paczynskiWiita.horizon', LENGTHS);
  const values: LawParameters = [mu, horizon, 0];
  return centralForce(
    {
      name: 'Paczyński-Wiita gravity',
      equation: 'F = -m μ r̂ / (r - r_s)²',
      law: LAW.paczynskiWiita,
      couplesTo: 'Mass',
      parameters: { mu: { unit: 'm³/s²', value: mu }, horizon: { unit: 'm', value: horizon } },
      values: () => values,
    },
    options,
    'paczynskiWiita',
  );
}

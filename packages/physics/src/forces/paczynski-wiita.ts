// The pseudo-Newtonian attraction of a black hole, with the innermost stable circular orbit of the Schwarzschild
// metric.
//
//   F = -m μ r̂/(r - r_s)²        U = -m μ/(r - r_s)
//
//   m  mass, kg    μ = G M, m³/s²    r_s  Schwarzschild radius, m; 2 μ/c² by default    r  distance, m
//
// Circular orbits are stable beyond 3 r_s and bound beyond 2 r_s, as in general relativity; time and light are
// Newtonian. At r_s and inside there is neither force nor potential: the body is captured, and should be removed.
// Paczyński and Wiita, Astronomy and Astrophysics 88, 23 (1980). Cost: one square root, two divisions and 19 more
// operations per body.
import { MAX_SPEED } from '../components/velocity.ts';
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { LENGTH_BOUNDS, POSITIVE } from './support/bounds.ts';
import {
  CENTRE_KEYS,
  type CentralLaw,
  type CentreOptions,
  centralForce,
  inverseWhere,
} from './support/central-force.ts';

/** Options of `paczynskiWiita`. */
export interface PaczynskiWiitaOptions extends CentreOptions {
  /** Gravitational parameter μ = G M, m³/s². */
  readonly mu: number;
  /** Schwarzschild radius r_s, m; default 2 μ/c² with the true speed of light. */
  readonly horizon?: number;
}

const parameters = { mu: scalar('m³/s²', POSITIVE), horizon: scalar('m', LENGTH_BOUNDS) };

const LAW: CentralLaw<typeof parameters> = {
  name: 'Paczyński-Wiita gravity',
  formula: 'F = -m μ r̂ / (r - r_s)²',
  source: 'Paczyński and Wiita, Astronomy and Astrophysics 88, 23 (1980).',
  parameters,
  field(r, { mu, horizon }) {
    const distance = r.length();
    const isOutside = distance.greater(horizon);
    const steep = inverseWhere(isOutside, distance.sub(horizon));
    const direction = r.mul(inverseWhere(isOutside, distance));
    return direction.mul(mu.mul(steep).mul(steep)).negate();
  },
  energy(r, { mu, horizon }) {
    const distance = r.length();
    return mu.mul(inverseWhere(distance.greater(horizon), distance.sub(horizon))).negate();
  },
};

/**
 * The pseudo-Newtonian attraction of a black hole, with its innermost stable orbit at 3 r_s: F = -m μ r̂/(r - r_s)²,
 * N, on every body with mass. Paczyński and Wiita (1980).
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function paczynskiWiita(options: PaczynskiWiitaOptions): Force {
  checkKeys(options, 'paczynskiWiita', ['mu', 'horizon', ...CENTRE_KEYS]);
  const mu = checkNumber(options.mu, 'paczynskiWiita.mu', POSITIVE);
  const horizon = options.horizon ?? (2 * mu) / (MAX_SPEED * MAX_SPEED);
  return centralForce(LAW, 'Mass', { ...options, horizon });
}

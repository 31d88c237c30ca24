// The tension of an inextensible string from a fixed pivot: a pendulum.
//
//   T = F·n + m v_t²/r + 2 m λ v_r + m λ² (r² - L²)/(2r)  along -n when r ≥ (1 - 10⁻³) L, and never negative; else 0
//
//   F  force of all laws listed before this one, N    n  unit vector from the pivot to the body
//   v_t, v_r  speed across the string and along it, m/s    r  distance from the pivot, m    L  length of the string, m
//   λ  rate of correction, 1/s
//
// It reacts to the forces before it, so list it last. The first two terms give exactly the radial acceleration of a circle;
// but then nothing takes back the errors of the integrator, and the length drifts. The terms with λ make errors of the
// length decay as e^(-λ t) (Baumgarte, Comp. Meth. Appl. Mech. Eng. 1, 1, 1972). They act along the string, where a taut
// one does not move, so swings are not damped while v dt < 0.089 L. With longer steps a stage of the integrator is nearer to the
// pivot than (1 - 10⁻³) L, where the string counts as slack: then each period takes up to 8 % of m g L, and the length changes by
// 1 to 9 %. A pendulum released at 30°, 60° and 85° takes 37, 76 and 110 steps per period for that, and with 60 steps a second one
// released at 60° must be longer than 0.34 m. Beyond, errors depend on the steps per period and on λ √(L/g) alone. At 120 steps and
// λ = 1.6 √(g/L), which is 5/s for 1 m, Runge-Kutta 4 keeps the length of those three to 10⁻⁷, 6·10⁻⁷ and 10⁻⁶ L and changes the
// energy by at most 2·10⁻⁷ m g L a period; with λ = 5 √(g/L), 5/s for 10 m, by ten to a hundred times as much. Velocity Verlet at 200
// steps keeps the length to 4·10⁻⁵, 2·10⁻⁴ and 6·10⁻⁴ L and the energy to 3·10⁻⁵, 5·10⁻⁴ and 2·10⁻³ m g L a period. Without, λ = 0,
// Runge-Kutta 4 at 100 steps changes the length of those released at 30° and 60° by 5·10⁻⁵ and 0.8 L in ten periods. A string that
// goes slack and becomes taut with a jerk stretches by about v_r/(e λ) and does not bounce; for less, use a rod of a rigid body,
// or `xpbd`. Goldstein, Classical Mechanics, section 1.3. To select bodies, wrap it in `restrictForce`. Cost: about 40 operations
// and two divisions per body.
import { defineLaw } from '../dynamics/define-law.ts';
import type { VectorInput } from '../errors/validate.ts';
import { select, vec3 } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { LENGTH_BOUNDS, POSITION_BOUNDS } from './support/bounds.ts';

/** Options of `stringTension`. */
export interface StringOptions {
  /** Position of the pivot, m; default the origin. */
  readonly pivot?: VectorInput;
  /** Length L, m. */
  readonly length: number;
  /** Rate λ at which errors of the length decay, 1/s; default 5, and 0 for none. Some √(g/L) to ten times that is best. */
  readonly correctionRate?: number;
}

const TAUT_RATIO = 0.999;

const law = /* @__PURE__ */ defineLaw({
  name: 'string tension',
  formula: 'T = F·n + m v_t²/r + 2 m λ v_r + m λ² (r² - L²)/2r',
  source: 'Goldstein, Classical Mechanics, section 1.3.',
  parameters: {
    pivot: vector('m', { default: {}, ...POSITION_BOUNDS }),
    length: scalar('m', LENGTH_BOUNDS),
    correctionRate: scalar('1/s', { default: 5, min: 0, max: 1e4 }),
  },
  // The law is proportional to mass: T/m reacts to F/m. With the vector r for the unit vector n, T/(m r) = (F·r/m +
  // v_t² + 2 λ v·r + λ² (r² - L²)/2)/r².
  acceleration({ position, velocity, acceleration }, { pivot, length, correctionRate }) {
    const offset = position.sub(pivot);
    const square = offset.lengthSquared();
    const radial = velocity.dot(offset);
    const tangentialSquare = velocity.lengthSquared().sub(radial.square().div(square));
    const circular = acceleration.dot(offset).add(tangentialSquare);
    const excess = square.sub(length.square()).mul(correctionRate.mul(0.5));
    const tension = circular.add(correctionRate.mul(radial.mul(2).add(excess))).div(square);
    const isTaut = square.greaterOrEqual(length.mul(TAUT_RATIO).square());
    return select(isTaut.and(tension.greater(0)), offset.mul(tension).negate(), vec3(0, 0, 0));
  },
});

/**
 * The tension of an inextensible string from a fixed pivot, a pendulum: along the string, N, against the forces listed
 * before it. List it last.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function stringTension(options: StringOptions): Force {
  return law(options);
}

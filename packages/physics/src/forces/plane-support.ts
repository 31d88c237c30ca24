// A slope, floor or runway that bodies stand, slide and roll on: normal force and dry friction, without contacts.
//
//   normal   N = -F·n where that presses
//   sticking  f = (D + m u/dt)/(1 + m r²/I) against the driving force D and the slip u, as long as f ≤ μ_s N
//   slipping  f = μ_k N against u, and never more than stops it within the step
//
//   F  force of all laws listed before this one, N    n  unit normal out of the plane    D = F + N n  along the plane, N
//   u = v_t - r ω × n  slip of the point of contact when the step began, m/s    r  radius of the collider, m    I  moment of inertia, kg m²
//
// It answers the forces before it: list it last. N is what the other forces leave, so a lifting wing is lighter on the
// runway. A body with Inertia and AngularVelocity rolls, a (solid) ball down a slope with g sinθ/(1 + 2/5); one without
// is a block, 1/I = 0. Friction turns at rest into what holds: with μ_s = tanθ to the last digit it does not move.
// A body is on the plane when its surface is within `gap`, and leaves when the forces lift it. What arrives with a speed
// into the plane is not stopped: that is an impact, and the work of a wall. Less than `stickSpeed` is taken for rounding.
// Coulomb (1785); Goldstein, Classical Mechanics, section 2.4 for rolling. Cost: one to three square roots a body.

import { Collider } from '../components/collider.ts';
import { Inertia } from '../components/inertia.ts';
import { AngularVelocity } from '../components/rotation.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, checkVector, type VectorInput } from '../errors/validate.ts';
import type { BodySymbols } from '../laws/body-symbols.ts';
import { type Condition, constant, type Scalar, select, type Vector, vec3 } from '../laws/expression.ts';
import { scalar, suppliedScalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { PLACES } from './support/bounds.ts';
import { unit } from './support/unit-vector.ts';

export interface PlaneSupportOptions {
  /** A point of the plane, m; default the origin. */
  readonly point?: VectorInput;
  /** Normal out of it, of any length; default +y. */
  readonly normal?: VectorInput;
  /** μ_s; default the kinetic one. */
  readonly staticFriction?: number;
  /** μ_k; default 0. */
  readonly kineticFriction?: number;
  /** How far from the plane a body is still on it, m; default 10⁻³. */
  readonly gap?: number;
  /** Slip below which a body sticks, and speed along the normal that is stopped, m/s; default 10⁻⁶. */
  readonly stickSpeed?: number;
}

/** The plane as the law sees it. */
interface PlaneSymbols {
  readonly point: Vector;
  readonly normal: Vector;
  readonly staticFriction: Scalar;
  readonly kineticFriction: Scalar;
  readonly gap: Scalar;
  readonly stickSpeed: Scalar;
  readonly rounding: Scalar;
}

interface RollingSymbols extends BodySymbols {
  readonly collider: { readonly radius: Scalar };
  readonly inertia: Scalar;
}

/** What the plane does to a body, per mass: all of the law is in proportion to it. */
interface Support {
  readonly presses: Condition;
  /** Along the normal, and along the plane, m/s². */
  readonly normal: Scalar;
  readonly friction: Vector;
  /** Radius of a body that rolls, and zero of a block, m. */
  readonly arm: Scalar;
}

const known = /* @__PURE__ */ new WeakMap<BodySymbols, Support>();

/** Force and torque are parts of one answer, which is made once. */
function supportOf(body: RollingSymbols, plane: PlaneSymbols): Support {
  const support = known.get(body) ?? answer(body, plane);
  known.set(body, support);
  return support;
}

function answer(body: RollingSymbols, plane: PlaneSymbols): Support {
  const { position, acceleration, startVelocity, angularVelocity, mass, inertia, dt } = body;
  const { radius } = body.collider;
  const n = plane.normal;
  const height = position.sub(plane.point).dot(n).sub(radius);
  const normal = acceleration.dot(n).negate();
  const turns = body.has(AngularVelocity).and(inertia.greater(0));
  const arm = select(turns, radius, 0);
  const lever = select(turns, mass.mul(radius.square()).div(inertia), 0);
  // Slip and spin are those at the start of the step, in every evaluation: the angular velocity moves only when the step
  // is over, and the two must belong together.
  const going = startVelocity.sub(angularVelocity.cross(n).mul(arm));
  const leaving = going.dot(n);
  const slip = going.sub(n.mul(leaving));
  const driving = acceleration.add(n.mul(normal));
  // Outside of a step there is none within which a slip could end.
  const hurry = select(dt.greater(0), constant(1).div(dt), 0);
  const holding = driving.add(slip.mul(hurry)).div(lever.add(1)).negate();
  const friction = limitedFriction(plane, slip, holding, normal);
  // What little speed rounding gives a body along the normal would add up, and it would sink into the plane or leave it.
  const isRounding = leaving.square().lessOrEqual(smallSquare(plane, startVelocity));
  const stop = select(isRounding, leaving.mul(hurry), 0);
  const presses = height.lessOrEqual(plane.gap).and(normal.greater(0));
  return { presses, normal: normal.sub(stop), friction, arm };
}

/** Square of the speed that counts as none. */
function smallSquare({ stickSpeed, rounding }: PlaneSymbols, velocity: Vector): Scalar {
  return velocity.lengthSquared().mul(rounding.square()).add(stickSpeed.square());
}

/** Sticking, a body has the friction that holds it, as long as there is so much; slipping, no more than would stop it. */
function limitedFriction(plane: PlaneSymbols, slip: Vector, holding: Vector, normal: Scalar): Vector {
  const { staticFriction, kineticFriction, stickSpeed, rounding } = plane;
  const speed = slip.length();
  const needed = holding.length();
  const most = kineticFriction.mul(normal);
  // What holds to the last digit shall hold: both sides are made of forces as large as `normal` and `needed`.
  const holds = needed.lessOrEqual(staticFriction.mul(normal).add(normal.add(needed).mul(rounding)));
  const sliding = select(needed.greater(most), slip.mul(most.div(speed)).negate(), holding);
  const sticking = select(holds, holding, holding.mul(most.div(needed)));
  return select(speed.greater(stickSpeed), sliding, sticking);
}

const NONE = vec3(0, 0, 0);

const law = /* @__PURE__ */ defineLaw({
  name: 'plane support',
  formula: 'N = -F·n, |f| ≤ μ N',
  source: 'Coulomb (1785); Goldstein, Classical Mechanics, section 2.4.',
  reads: { collider: Collider, inertia: Inertia },
  parameters: {
    point: vector('m', { default: {}, ...PLACES }),
    normal: vector(''),
    staticFriction: scalar('', { min: 0, max: 100 }),
    kineticFriction: scalar('', { min: 0, max: 100 }),
    gap: scalar('m', { default: 1e-3, min: 0, max: 1e12 }),
    stickSpeed: scalar('m/s', { default: 1e-6, min: 0, max: 1e6 }),
    // Some ten roundings lie between the forces and each side of the comparison.
    rounding: suppliedScalar(({ precision }) => 16 * (precision === 'f32' ? 2 ** -24 : 2 ** -53)),
  },
  acceleration(body, plane) {
    const { presses, normal, friction } = supportOf(body, plane);
    return select(presses, plane.normal.mul(normal).add(friction), NONE);
  },
  torque(body, plane) {
    const { presses, friction, arm } = supportOf(body, plane);
    return select(presses, plane.normal.cross(friction).mul(arm.mul(body.mass)).negate(), NONE);
  },
});

const KEYS = ['point', 'normal', 'staticFriction', 'kineticFriction', 'gap', 'stickSpeed'];

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function planeSupport(options: PlaneSupportOptions = {}): Force {
  checkKeys(options, 'planeSupport', KEYS);
  const normal = checkVector(options.normal ?? { y: 1 }, 'planeSupport.normal', PLACES);
  const { kineticFriction = 0, staticFriction = kineticFriction } = options;
  return law({ ...options, normal: unit(normal, 'planeSupport.normal'), staticFriction, kineticFriction });
}

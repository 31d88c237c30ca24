// A slope, floor or runway on which bodies stand, slide and roll: normal force and dry friction, without contacts.
//
//   normal   N = -F·n if positive
//   sticking  f = (D + m u/dt)/(1 + m r²/I) against the driving force D and the slip u, as long as f ≤ μ_s N
//   slipping  f = μ_k N against u, and at most what stops the slip within the step
//
//   F  force of all laws listed before this one, N    n  unit normal out of the plane    D = F + N n  along the plane, N
//   u = v_t - r ω × n  slip of the contact point at the start of the step, m/s    r  radius of the collider, m    I  moment of inertia, kg m²
//
// It reacts to the forces before it, so list it last. N is the remaining normal force, so lift reduces the load on a
// runway. A body with Inertia and AngularVelocity rolls: a solid ball down a slope with g sinθ/(1 + 2/5). A body
// without them is a block, 1/I = 0. At rest static friction balances the driving force: at μ_s = tanθ, to rounding, a
// block does not move. A body is in contact if its surface is within `gap`, and loses contact if the forces lift it.
// A velocity into the plane is not stopped: that is an impact, for which walls are made. Slip below `stickSpeed`
// counts as rounding. Coulomb (1785); Goldstein, Classical Mechanics, section 2.4 for rolling. Cost: one to three
// square roots per body.

import { Collider } from '../components/collider.ts';
import { Inertia } from '../components/inertia.ts';
import { AngularVelocity } from '../components/rotation.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, checkVector, type VectorInput } from '../errors/validate.ts';
import type { BodySymbols } from '../laws/body-symbols.ts';
import { type Condition, constant, type Scalar, select, type Vector, vec3 } from '../laws/expression.ts';
import { scalar, suppliedScalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { POSITION_BOUNDS } from './support/bounds.ts';
import { unit } from './support/unit-vector.ts';

/** Options of `planeSupport`. */
export interface PlaneSupportOptions {
  /** A point of the plane, m; default the origin. */
  readonly point?: VectorInput;
  /** Normal out of the plane, of any length; default +y. */
  readonly normal?: VectorInput;
  /** Static coefficient μ_s; default the kinetic one. */
  readonly staticFriction?: number;
  /** Kinetic coefficient μ_k; default 0. */
  readonly kineticFriction?: number;
  /** Distance from the plane within which a body is in contact, m; default 10⁻³. */
  readonly gap?: number;
  /** Slip below which a body sticks, and normal speed that is stopped, m/s; default 10⁻⁶. */
  readonly stickSpeed?: number;
}

/** The parameters of the plane as expressions. */
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

/** The reaction of the plane per mass; the law is proportional to the mass. */
interface Support {
  readonly inContact: Condition;
  /** Accelerations along the normal, and along the plane, m/s². */
  readonly normal: Scalar;
  readonly friction: Vector;
  /** Radius of a rolling body, and zero for a block, m. */
  readonly arm: Scalar;
}

const supports = /* @__PURE__ */ new WeakMap<BodySymbols, Support>();

/** Returns the reaction, cached because force and torque share it. */
function supportOf(body: RollingSymbols, plane: PlaneSymbols): Support {
  const support = supports.get(body) ?? computeSupport(body, plane);
  supports.set(body, support);
  return support;
}

function computeSupport(body: RollingSymbols, plane: PlaneSymbols): Support {
  const { position, acceleration, startVelocity, angularVelocity, mass, inertia, dt } = body;
  const { radius } = body.collider;
  const n = plane.normal;
  const height = position.sub(plane.point).dot(n).sub(radius);
  const normal = acceleration.dot(n).negate();
  const rolls = body.has(AngularVelocity).and(inertia.greater(0));
  const arm = select(rolls, radius, 0);
  const rollingTerm = select(rolls, mass.mul(radius.square()).div(inertia), 0);
  // Slip and spin are those at the start of the step in every evaluation: the angular velocity changes only at the
  // end of the step, and the two must be consistent.
  const contactVelocity = startVelocity.sub(angularVelocity.cross(n).mul(arm));
  const normalSpeed = contactVelocity.dot(n);
  const slip = contactVelocity.sub(n.mul(normalSpeed));
  const driving = acceleration.add(n.mul(normal));
  // Outside of a step dt is 0, and slip is not stopped.
  const inverseStep = select(dt.greater(0), constant(1).div(dt), 0);
  const holding = driving.add(slip.mul(inverseStep)).div(rollingTerm.add(1)).negate();
  const friction = limitFriction(plane, slip, holding, normal);
  // Rounding gives a body a small normal velocity, which would accumulate and make it sink or rise.
  const isRounding = normalSpeed.square().lessOrEqual(minSpeedSquare(plane, startVelocity));
  const stop = select(isRounding, normalSpeed.mul(inverseStep), 0);
  const inContact = height.lessOrEqual(plane.gap).and(normal.greater(0));
  return { inContact, normal: normal.sub(stop), friction, arm };
}

/** Returns the square of the speed that counts as zero. */
function minSpeedSquare({ stickSpeed, rounding }: PlaneSymbols, velocity: Vector): Scalar {
  return velocity.lengthSquared().mul(rounding.square()).add(stickSpeed.square());
}

/** A sticking body gets the holding friction up to the static limit; a slipping one at most what stops it. */
function limitFriction(plane: PlaneSymbols, slip: Vector, holding: Vector, normal: Scalar): Vector {
  const { staticFriction, kineticFriction, stickSpeed, rounding } = plane;
  const speed = slip.length();
  const needed = holding.length();
  const maxFriction = kineticFriction.mul(normal);
  // Equality to rounding counts as holding: both sides are computed from forces as large as `normal` and `needed`.
  const holds = needed.lessOrEqual(staticFriction.mul(normal).add(normal.add(needed).mul(rounding)));
  const sliding = select(needed.greater(maxFriction), slip.mul(maxFriction.div(speed)).negate(), holding);
  const sticking = select(holds, holding, holding.mul(maxFriction.div(needed)));
  return select(speed.greater(stickSpeed), sliding, sticking);
}

const ZERO = vec3(0, 0, 0);

const law = /* @__PURE__ */ defineLaw({
  name: 'plane support',
  formula: 'N = -F·n, |f| ≤ μ N',
  source: 'Coulomb (1785); Goldstein, Classical Mechanics, section 2.4.',
  reads: { collider: Collider, inertia: Inertia },
  parameters: {
    point: vector('m', { default: {}, ...POSITION_BOUNDS }),
    normal: vector(''),
    staticFriction: scalar('', { min: 0, max: 100 }),
    kineticFriction: scalar('', { min: 0, max: 100 }),
    gap: scalar('m', { default: 1e-3, min: 0, max: 1e12 }),
    stickSpeed: scalar('m/s', { default: 1e-6, min: 0, max: 1e6 }),
    // About ten roundings lie between the forces and each side of the comparison.
    rounding: suppliedScalar(({ precision }) => 16 * (precision === 'f32' ? 2 ** -24 : 2 ** -53)),
  },
  acceleration(body, plane) {
    const { inContact, normal, friction } = supportOf(body, plane);
    return select(inContact, plane.normal.mul(normal).add(friction), ZERO);
  },
  torque(body, plane) {
    const { inContact, friction, arm } = supportOf(body, plane);
    return select(inContact, plane.normal.cross(friction).mul(arm.mul(body.mass)).negate(), ZERO);
  },
});

const KEYS = ['point', 'normal', 'staticFriction', 'kineticFriction', 'gap', 'stickSpeed'];

/**
 * A floor or slope on which bodies with a collider stand, slide and roll, without contacts: normal force and dry
 * friction, N, against the forces listed before it. List it last.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function planeSupport(options: PlaneSupportOptions = {}): Force {
  checkKeys(options, 'planeSupport', KEYS);
  const normal = checkVector(options.normal ?? { y: 1 }, 'planeSupport.normal', POSITION_BOUNDS);
  const { kineticFriction = 0, staticFriction = kineticFriction } = options;
  return law({ ...options, normal: unit(normal, 'planeSupport.normal'), staticFriction, kineticFriction });
}

// A wing, or a part of one, a tail, a fin: lift and drag by the angle of attack, at a point of the body.
//
//   F = ½ ρ A |w| (C_L(α) (s × w) - C_D(α) w)        τ = R p × F
//   w = u - (s · u) s        u = v + ω × R p - wind
//   α = atan2(-w · n, w · f) + i + e δ        n = s × f
//
//   ρ  density of the air, kg/m³    A  area, m²    C_L, C_D  curves over α, rad    p  aerodynamic centre in the body's axes,
//   m    s  unit vector along the span, from the left tip to the right    f  unit vector forwards along the chord, across s
//   u  velocity of the point through the air, m/s    w  its part across the span, which alone makes forces (infinite swept
//   wing)    i  incidence, the angle at which the wing is fixed to the body, rad    δ  deflection of a control surface, rad,
//   from a component    e  its effectiveness, change of α per angle
//
// Because the velocity is that of the point, wings damp rolling, pitching and yawing, and a wing whose inner half is
// stalled autorotates: a spin. Steady flow: no vortex takes time to build up, and one wing does not feel the wake of another.
// Mach below 0.3. It acts on every body with mass; `restrictForce` limits it to some. Anderson, Fundamentals of
// Aerodynamics, sections 1.5 and 5.3; Etkin and Reid, Dynamics of Flight, section 2. Cost: some 150 operations, an arc
// tangent and a square root a body.
import type { ComponentSpec } from '../components/define.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import {
  checkKeys,
  checkNumber,
  checkVector,
  isRecord,
  mustBe,
  type Vector,
  type VectorInput,
} from '../errors/validate.ts';
import type { BodySymbols } from '../laws/body-symbols.ts';
import type { Scalar, Vector as VectorSymbol } from '../laws/expression.ts';
import { scalar, suppliedVector, vector } from '../laws/parameter.ts';
import { type CurvePoints, checkCurve, piecewiseLinear } from '../laws/piecewise-linear.ts';
import type { Force } from '../world/types.ts';
import { NOT_NEGATIVE, POSITION_BOUNDS } from './support/bounds.ts';
import { unit } from './support/unit-vector.ts';
import { type Wind, windParameter } from './support/wind.ts';

/** A control surface: the field of a component with its deflection, rad, positive for more lift. */
export interface WingDeflection {
  readonly component: ComponentSpec;
  readonly field: string;
  /** Effectiveness e, change of the angle of attack per deflection; default 1, for a wing that turns as a whole. */
  readonly effectiveness?: number;
}

/** Options of `wing`. */
export interface WingOptions {
  /** Area A, m². */
  readonly area: number;
  /** Lift coefficient: points (α, C_L), α in rad from -π to π; constant beyond the first and the last. */
  readonly lift: CurvePoints;
  /** Drag coefficient: points (α, C_D). */
  readonly drag: CurvePoints;
  /** Aerodynamic centre p in the body's axes, m; default the centre of mass. */
  readonly position?: VectorInput;
  /** Span axis s in the body's axes, from the left tip to the right; default +z. In 2D it is +z. */
  readonly span?: VectorInput;
  /** Forward direction f along the chord in the body's axes; default +x. Its part along the span is removed. */
  readonly forward?: VectorInput;
  /** Incidence i, rad; default 0. */
  readonly incidence?: number;
  /** Density of the air ρ, kg/m³; default 1.225, at sea level. */
  readonly density?: number;
  /** Velocity of the air, m/s; default at rest. */
  readonly wind?: Wind;
  /** What deflects the control surface; default none. */
  readonly deflection?: WingDeflection;
}

const KEYS = ['area', 'lift', 'drag', 'position', 'span', 'forward', 'incidence', 'density', 'wind', 'deflection'];

/** Density of the standard atmosphere at sea level, kg/m³: ICAO Doc 7488. */
const SEA_LEVEL_DENSITY = 1.225;
const ANGLE = { min: -4, max: 4 };
const DIRECTION = { min: -1e12, max: 1e12 };

/**
 * A wing, a tail or a fin: lift and drag by the angle of attack, N, with stall and control surfaces, at a point of the
 * body, and so torques.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function wing(options: WingOptions): Force {
  checkKeys(options, 'wing', KEYS);
  const span = unit(checkVector(options.span ?? { z: 1 }, 'wing.span', DIRECTION), 'wing.span');
  const chord = checkVector(options.forward ?? { x: 1 }, 'wing.forward', DIRECTION);
  const lift = checkCurve(options.lift, 'wing.lift');
  const drag = checkCurve(options.drag, 'wing.drag');
  const make = wingLaw({ span, forward: across(chord, span), lift, drag, deflection: checkDeflection(options) });
  return make({
    halfDensityArea:
      (checkNumber(options.area, 'wing.area', NOT_NEGATIVE) *
        checkNumber(options.density ?? SEA_LEVEL_DENSITY, 'wing.density', NOT_NEGATIVE)) /
      2,
    position: checkVector(options.position ?? {}, 'wing.position', POSITION_BOUNDS),
    incidence: checkNumber(options.incidence ?? 0, 'wing.incidence', ANGLE),
    wind: options.wind ?? {},
  });
}

interface WingShape {
  readonly span: Vector;
  readonly forward: Vector;
  readonly lift: CurvePoints;
  readonly drag: CurvePoints;
  readonly deflection: Required<WingDeflection> | undefined;
}

type WingSymbols = Record<'position' | 'span' | 'forward' | 'wind', VectorSymbol> &
  Record<'incidence' | 'halfDensityArea', Scalar>;

const OUT_OF_PLANE: Vector = { x: 0, y: 0, z: 1 };

function wingLaw({ span, forward, lift, drag, deflection }: WingShape) {
  const force = (body: BodySymbols, wing: WingSymbols, angle: Scalar | undefined): VectorSymbol => {
    const s = body.rotate(wing.span);
    const f = body.rotate(wing.forward);
    const u = body.velocity.add(body.angularVelocity.cross(body.rotate(wing.position))).sub(wing.wind);
    const w = u.sub(s.mul(s.dot(u)));
    const attack = w.dot(s.cross(f)).negate().atan2(w.dot(f)).add(wing.incidence);
    const alpha = angle === undefined ? attack : attack.add(angle);
    const lifted = s.cross(w).mul(piecewiseLinear(alpha, lift));
    return lifted.sub(w.mul(piecewiseLinear(alpha, drag))).mul(w.length().mul(wing.halfDensityArea));
  };
  const deflected = (body: unknown): Scalar | undefined => {
    if (deflection === undefined) return undefined;
    const read = (body as { readonly controls: unknown }).controls;
    const column = (
      isSingle(deflection.component) ? read : (read as Record<string, unknown>)[deflection.field]
    ) as Scalar;
    return column.mul(deflection.effectiveness);
  };
  return defineLaw({
    name: 'wing',
    formula: 'F = ½ ρ A |w| (C_L (s × w) - C_D w), τ = R p × F',
    source: 'Anderson, Fundamentals of Aerodynamics, sections 1.5 and 5.3.',
    reads: deflection === undefined ? {} : { controls: deflection.component },
    parameters: {
      halfDensityArea: scalar('kg/m', NOT_NEGATIVE),
      incidence: scalar('rad', ANGLE),
      position: vector('m', POSITION_BOUNDS),
      span: suppliedVector(({ dimensions }) => (dimensions === 3 ? span : OUT_OF_PLANE), 'axial'),
      forward: suppliedVector(() => forward),
      wind: windParameter,
    },
    force: (body, parameters) => force(body, parameters, deflected(body)),
    torque: (body, parameters) => body.rotate(parameters.position).cross(force(body, parameters, deflected(body))),
  });
}

/** A component of one field is one symbol; fields named x, y and z are the parts of a vector, which also has them. */
function isSingle({ fields }: ComponentSpec): boolean {
  const names = Object.keys(fields);
  return names.length === 1 && !'xyz'.includes(names[0]);
}

/** Removes the part along the span. */
function across(chord: Vector, span: Vector): Vector {
  const along = chord.x * span.x + chord.y * span.y + chord.z * span.z;
  const { x, y, z } = chord;
  return unit({ x: x - along * span.x, y: y - along * span.y, z: z - along * span.z }, 'wing.forward across the span');
}

function checkDeflection({ deflection }: WingOptions): Required<WingDeflection> | undefined {
  if (deflection === undefined) return undefined;
  checkKeys(deflection, 'wing.deflection', ['component', 'field', 'effectiveness']);
  const { component, field, effectiveness = 1 } = deflection;
  if (!isRecord(component) || !isRecord(component.fields)) {
    throw mustBe('a component, such as one of defineComponent', component, 'wing.deflection.component');
  }
  if (typeof field !== 'string' || !Object.hasOwn(component.fields, field)) {
    throw new PhysicsError('E_UNKNOWN', `wing.deflection.field ${String(field)} is no field of the component.`, {
      field: 'wing.deflection.field',
      value: field,
      hint: `Its fields are ${Object.keys(component.fields).join(', ')}.`,
    });
  }
  return { component, field, effectiveness: checkNumber(effectiveness, 'wing.deflection.effectiveness', DIRECTION) };
}

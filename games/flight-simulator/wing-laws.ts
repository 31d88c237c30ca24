/**
 * The aeroplane's forces as laws: panels of the wing whose flow may separate, and a tail of which a part flies in the wash of
 * the propeller.
 *
 *   F = ½ ρ A |w| (C_L (s × w) − C_D w)        C = C_s + k (C_a − C_s), k = ((1 + √x)² − 1)/3
 *
 *   C_a, C_s  coefficients of attached and of separated flow    x  attached part of the chord, from `Flow`; else as `wing`
 *
 * With C_s = C_a/4 that is Kirchhoff's lift of a plate whose flow separates at x, C_a (1 + √x)²/4 (Thwaites, Incompressible
 * Aerodynamics, 1960; Goman and Khrabrov 1994).
 */
import {
  axial3,
  type CurvePoints,
  defineLaw,
  type Force,
  piecewiseLinear,
  quadraticDrag,
  type ScalarSymbol,
  thrust,
  uniformGravity,
  type VectorSymbol,
  vec3,
  vectorOverTime,
} from '@principia/physics';
import {
  AIR_DENSITY,
  AIRCRAFT,
  ATTACHED_DRAG,
  ATTACHED_LIFT,
  Deflections,
  Flow,
  INCIDENCE,
  PANELS,
  SEPARATED_DRAG,
  SEPARATED_LIFT,
  TAIL_DRAG,
  TAIL_INCIDENCE,
  TAIL_LIFT,
  type Wind,
} from './aircraft.ts';
import type { Axes } from './body-frame.ts';

/** What the laws read of a body. */
interface Body {
  readonly velocity: VectorSymbol;
  readonly angularVelocity: VectorSymbol;
  rotate(vector: VectorSymbol): VectorSymbol;
}

interface Surface {
  readonly area: number;
  readonly position: Readonly<Axes>;
  readonly span: Readonly<Axes>;
  readonly incidence: number;
}

type Coefficient = (alpha: ScalarSymbol) => ScalarSymbol;

const arm = (body: Body, { position: { x, y, z } }: Surface) => body.rotate(vec3(x, y, z));

/**
 * @param deflected change of the angle of attack by a control surface
 * @param wash added to the air from ahead, m/s
 * @param turning rotation relative to the air, rad/s
 */
function liftAndDrag(
  body: Body,
  surface: Surface,
  wind: VectorSymbol,
  deflected: ScalarSymbol,
  [lift, drag]: readonly [Coefficient, Coefficient],
  wash?: ScalarSymbol,
  turning = body.angularVelocity,
): VectorSymbol {
  const s = body.rotate(axial3(surface.span.x, surface.span.y, surface.span.z));
  const f = body.rotate(vec3(1, 0, 0));
  const still = body.velocity.add(turning.cross(arm(body, surface))).sub(wind);
  const u = wash === undefined ? still : still.add(f.mul(wash));
  const w = u.sub(s.mul(s.dot(u)));
  const alpha = w.dot(s.cross(f)).negate().atan2(w.dot(f)).add(surface.incidence).add(deflected);
  const size = w.length().mul(0.5 * AIR_DENSITY * surface.area);
  return s
    .cross(w)
    .mul(lift(alpha))
    .sub(w.mul(drag(alpha)))
    .mul(size);
}

const wind = vectorOverTime('m/s', { default: {} });

function panelLaw(index: 0 | 1 | 2 | 3) {
  const { position, span, aileron } = PANELS[index];
  const surface = { area: AIRCRAFT.wingArea / PANELS.length, position, span, incidence: INCIDENCE };
  const mixed = (share: ScalarSymbol, attached: CurvePoints, separated: CurvePoints): Coefficient => {
    return (alpha) => {
      const apart = piecewiseLinear(alpha, separated);
      return piecewiseLinear(alpha, attached).sub(apart).mul(share).add(apart);
    };
  };
  type Read = Body & { readonly flow: Readonly<Record<`panel${0 | 1 | 2 | 3}` | 'roll', ScalarSymbol>> } & Controls;
  const force = (body: Read, air: VectorSymbol) => {
    const root = body.flow[`panel${index}`].sqrt().add(1);
    const share = root.square().sub(1).div(3);
    const curves = [mixed(share, ATTACHED_LIFT, SEPARATED_LIFT), mixed(share, ATTACHED_DRAG, SEPARATED_DRAG)] as const;
    const turning = body.angularVelocity.sub(body.rotate(axial3(1, 0, 0)).mul(body.flow.roll));
    return liftAndDrag(body, surface, air, body.controls.aileron.mul(aileron), curves, undefined, turning);
  };
  return defineLaw({
    name: `wing panel ${index}`,
    formula: 'F = ½ ρ A |w| (C_L (s × w) - C_D w), C = C_s + k (C_a - C_s)',
    source: 'Goman and Khrabrov, J. Aircraft 31, 1109 (1994).',
    reads: { flow: Flow, controls: Deflections },
    parameters: { wind },
    force: (body, { wind: air }) => force(body, air),
    torque: (body, { wind: air }) => arm(body, surface).cross(force(body, air)),
  });
}

interface Controls {
  readonly controls: { readonly [Name in 'aileron' | 'elevator' | 'rudder']: ScalarSymbol };
}

/** @param size of the surface across the wash, per its radius */
function tailLaw(surface: Surface, control: 'elevator' | 'rudder', effectiveness: number, size: number) {
  const curves = [
    (alpha: ScalarSymbol) => piecewiseLinear(alpha, TAIL_LIFT),
    (alpha: ScalarSymbol) => piecewiseLinear(alpha, TAIL_DRAG),
  ] as const;
  type Read = Body & { readonly flow: Readonly<Record<'wash' | 'washRadius', ScalarSymbol>> } & Controls;
  const force = (body: Read, air: VectorSymbol) => {
    const deflected = body.controls[control].mul(effectiveness);
    const share = body.flow.washRadius.mul(size).min(1);
    const free = liftAndDrag(body, surface, air, deflected, curves);
    const washed = liftAndDrag(body, surface, air, deflected, curves, body.flow.wash);
    return washed.sub(free).mul(share).add(free);
  };
  return defineLaw({
    name: `tail with ${control}`,
    formula: 'F = (1 - η) F(u) + η F(u + 2 v_i f)',
    source: 'Momentum theory: Glauert, in Durand, Aerodynamic Theory IV (1935).',
    reads: { flow: Flow, controls: Deflections },
    parameters: { wind },
    force: (body, { wind: air }) => force(body, air),
    torque: (body, { wind: air }) => arm(body, surface).cross(force(body, air)),
  });
}

const panels = ([0, 1, 2, 3] as const).map(panelLaw);
const tail = tailLaw(
  { area: 3.4, position: { x: -4.6, y: 0.1, z: 0 }, span: { x: 0, y: 0, z: 1 }, incidence: TAIL_INCIDENCE },
  'elevator',
  -0.5,
  2 / AIRCRAFT.tailSpan,
);
// The wash meets its lower part, above the fuselage.
const fin = tailLaw(
  { area: 1.8, position: { x: -4.9, y: 0.6, z: 0 }, span: { x: 0, y: 1, z: 0 }, incidence: 0 },
  'rudder',
  0.5,
  1 / AIRCRAFT.finHeight,
);

export function aircraftForces(air: Wind): Force[] {
  const moving = [...panels, tail, fin].map((law) => law({ wind: air }));
  return [uniformGravity(), thrust({ frame: 'body' }), quadraticDrag(air), ...moving];
}

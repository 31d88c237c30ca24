/** The aeroplane: a light single-engined one with a high wing, and the laws that move it. SI units. */
import { atan2, cos, defineComponent, realField, sin, type VectorOverTime } from '@principia/physics';

const DEGREE = Math.PI / 180;

/**
 * Numbers of a Cessna 172, rounded. Moments of inertia: Roskam, Airplane Flight Dynamics, appendix B. The body's axes are x
 * forwards, y up, z to the right.
 */
export const AIRCRAFT = {
  mass: 1040,
  inertiaTensor: { x: 1285, y: 2667, z: 1825 },
  wingArea: 16.2,
  span: 11,
  /** Efficiency of the wing's shape in plan, for the drag that lift induces. */
  efficiency: 0.8,
  /** Drag of everything but the wings as ½ ρ C_D A, kg/m. */
  parasite: 0.22,
  /** Thrust of the propeller at rest, N, and the speed at which it gives none, m/s. */
  staticThrust: 3800,
  pitchSpeed: 78,
  propellerRadius: 0.95,
  /** Span of the tail and height of the fin, m, for the part that the wash of the propeller meets. */
  tailSpan: 3.7,
  finHeight: 1.6,
  /** Largest deflections, rad. */
  aileron: 20 * DEGREE,
  elevator: 25 * DEGREE,
  rudder: 20 * DEGREE,
} as const;

export const AIR_DENSITY = 1.225;

/** Deflections of the control surfaces, rad: positive rolls to the right, raises the nose, turns to the right. */
export const Deflections = defineComponent({
  fields: { aileron: realField('rad'), elevator: realField('rad'), rudder: realField('rad') },
});

/**
 * The air about the aeroplane: attached parts of the flow along the four panels of the wing, from left to right, the speed of
 * the propeller's wash, m/s, its radius at the tail, m, and the rate at which the air itself rolls, rad/s.
 */
export const Flow = defineComponent({
  fields: {
    panel0: realField('', { initial: 1 }),
    panel1: realField('', { initial: 1 }),
    panel2: realField('', { initial: 1 }),
    panel3: realField('', { initial: 1 }),
    wash: realField('m/s'),
    washRadius: realField('m'),
    roll: realField('rad/s'),
  },
});

/** Lift per radian, and the angle at which the flow separates: an aspect ratio of 7.5. */
export const WING_SLOPE = 4.8;
export const STALL = 16 * DEGREE;
export const MAX_LIFT = WING_SLOPE * STALL;
const PROFILE_DRAG = 0.012;

/**
 * Lift over the whole circle: linear to the stall, a loss of a third within six degrees, then that of a flat plate. Source:
 * the measurements to 180° of Sheldahl and Klimas, SAND80-2114 (1981).
 */
function liftCurve(slope: number, stall: number): [number, number][] {
  const top = slope * stall;
  const half: [number, number][] = [
    [stall, top],
    [stall + 6 * DEGREE, 0.66 * top],
    [45 * DEGREE, 0.95],
    [90 * DEGREE, 0],
    [135 * DEGREE, -0.95],
    [172 * DEGREE, -0.7],
    [180 * DEGREE, 0],
  ];
  return [...half.toReversed().map(([x, y]): [number, number] => [-x, -y]), ...half];
}

/** Profile drag, drag induced by lift, C_L²/(π e Λ), and beyond the stall that of a plate. */
function dragCurve(slope: number, stall: number, aspect: number): [number, number][] {
  const induced = (alpha: number) => (slope * alpha * (slope * alpha)) / (Math.PI * AIRCRAFT.efficiency * aspect);
  const half = [0, 0.25, 0.5, 0.75, 1].map((part): [number, number] => [
    part * stall,
    PROFILE_DRAG + induced(part * stall),
  ]);
  half.push([stall + 6 * DEGREE, 0.28], [45 * DEGREE, 1], [90 * DEGREE, 1.7], [135 * DEGREE, 1], [180 * DEGREE, 0.05]);
  return [
    ...half
      .slice(1)
      .toReversed()
      .map(([x, y]): [number, number] => [-x, y]),
    ...half,
  ];
}

const aspect = (AIRCRAFT.span * AIRCRAFT.span) / AIRCRAFT.wingArea;
/** In steady flow. */
export const WING_LIFT = liftCurve(WING_SLOPE, STALL);
export const WING_DRAG = dragCurve(WING_SLOPE, STALL, aspect);
/** The tail flies in the downwash of the wing, which takes a third of its angle. */
export const TAIL_LIFT = liftCurve(2.6, STALL);
export const TAIL_DRAG = dragCurve(2.6, STALL, 4);

/** Beyond the first angle a part of the flow has separated in steady air; beyond the second all of it, rad. */
const PARTLY = STALL + 6 * DEGREE;
const WHOLLY = 30 * DEGREE;

const across = (points: [number, number][], sign: 1 | -1): [number, number][] => [
  ...points.toReversed().map(([x, y]): [number, number] => [-x, sign * y]),
  ...points,
];
const beyond = (curve: [number, number][], from: number) => curve.filter(([x]) => x > from);

/** Wholly attached flow, without which no lift grows beyond the angle of steady flow's whole separation. */
const attachedDrag = (alpha: number) =>
  PROFILE_DRAG + (WING_SLOPE * alpha * (WING_SLOPE * alpha)) / (Math.PI * AIRCRAFT.efficiency * aspect);
export const ATTACHED_LIFT = across([[WHOLLY, WING_SLOPE * WHOLLY]], -1);
export const ATTACHED_DRAG = across(
  [0.001, 0.25, 0.5, 0.75, 1].map((part): [number, number] => [part * WHOLLY, attachedDrag(part * WHOLLY)]),
  1,
);
/** Wholly separated flow: the steady curves where it is, and a plate's, that rises from zero, before. */
export const SEPARATED_LIFT = across([[WHOLLY, valueAt(WING_LIFT, WHOLLY)], ...beyond(WING_LIFT, WHOLLY)], -1);

/** Share k of the attached coefficients in Kirchhoff's lift, by the attached part of the chord, and its inverse. */
export const shareOf = (attached: number): number => ((1 + Math.sqrt(attached)) ** 2 - 1) / 3;
const attachedOf = (share: number): number => (Math.sqrt(3 * share + 1) - 1) ** 2;

/** The share at the angle where the steady lift is smallest, so that the law has it too. */
const separatedThere = (valueAt(WING_LIFT, WHOLLY) * PARTLY) / WHOLLY;
const PARTLY_SHARE = (valueAt(WING_LIFT, PARTLY) - separatedThere) / (WING_SLOPE * PARTLY - separatedThere);
const PARTLY_ATTACHED = attachedOf(PARTLY_SHARE);

export const SEPARATED_DRAG = across(
  [
    [0.001, 0.05],
    [PARTLY, (valueAt(WING_DRAG, PARTLY) - PARTLY_SHARE * attachedDrag(PARTLY)) / (1 - PARTLY_SHARE)],
    [WHOLLY, valueAt(WING_DRAG, WHOLLY)],
    ...beyond(WING_DRAG, WHOLLY),
  ],
  1,
);

/** Attached part of the chord in steady flow at an angle of attack, rad. */
export function steadyAttachment(attack: number): number {
  const alpha = Math.abs(attack);
  if (alpha <= STALL) return 1;
  if (alpha <= PARTLY) return 1 + ((PARTLY_ATTACHED - 1) * (alpha - STALL)) / (PARTLY - STALL);
  return Math.max(0, (PARTLY_ATTACHED * (WHOLLY - alpha)) / (WHOLLY - PARTLY));
}

function valueAt(curve: readonly (readonly [number, number])[], x: number): number {
  const i = curve.findIndex((point, at) => at > 0 && point[0] >= x);
  const [[left, from], [right, to]] = [curve[i - 1], curve[i]];
  return from + ((to - from) * (x - left)) / (right - left);
}

const DIHEDRAL = 2.5 * DEGREE;
const panel = (z: number, aileron: number) => ({
  /** Aerodynamic centre, m, and axis from the left tip to the right: rows rise by the dihedral. */
  position: { x: 0.22, y: 0.6, z },
  span: { x: 0, y: sin(z > 0 ? DIHEDRAL : -DIHEDRAL), z: cos(DIHEDRAL) },
  /** How much an aileron changes the angle there. */
  aileron,
});
/** Wing panels from left to right. */
export const PANELS = [panel(-4.1, 0.4), panel(-1.4, 0), panel(1.4, 0), panel(4.1, -0.4)] as const;
export const INCIDENCE = 2.5 * DEGREE;
export const TAIL_INCIDENCE = -1.2 * DEGREE;

/** The wind, m/s, as a constant vector or over time. */
export type Wind = VectorOverTime;

/** Thrust of the propeller at a speed, N. */
export function propellerThrust(throttle: number, speed: number): number {
  return throttle * AIRCRAFT.staticThrust * Math.max(0, 1 - speed / AIRCRAFT.pitchSpeed);
}

/** Speed below which the wing cannot carry the weight, √(2 m g/(ρ A C_Lmax)), m/s. */
export function stallSpeed(gravity = 9.80665): number {
  return Math.sqrt((2 * AIRCRAFT.mass * gravity) / (AIR_DENSITY * AIRCRAFT.wingArea * MAX_LIFT));
}

/** Angle of attack of the wing, rad, for a velocity through the air in the body's axes. */
export function angleOfAttack(forwards: number, up: number): number {
  return atan2(-up, forwards) + INCIDENCE;
}

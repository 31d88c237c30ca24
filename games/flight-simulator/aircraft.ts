/** The aeroplane: a light single-engined one with a high wing, and the laws that move it. SI units. */
import {
  atan2,
  cos,
  defineComponent,
  type Force,
  quadraticDrag,
  realField,
  sin,
  thrust,
  uniformGravity,
  type WingOptions,
  wing,
} from '@principia/physics';

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

/** Lift per radian, and the angle at which the flow separates: an aspect ratio of 7.5. */
const WING_SLOPE = 4.8;
const STALL = 16 * DEGREE;
export const MAX_LIFT = WING_SLOPE * STALL;
const PROFILE_DRAG = 0.012;

/**
 * Lift over the whole circle: linear to the stall, a loss of a third within six degrees, then that of a flat plate. Source:
 * the measurements to 180° of Sheldahl and Klimas, SAND80-2114 (1981).
 */
function liftCurve(slope: number, stall: number): WingOptions['lift'] {
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
function dragCurve(slope: number, stall: number, aspect: number): WingOptions['drag'] {
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
export const WING_LIFT = liftCurve(WING_SLOPE, STALL);
export const WING_DRAG = dragCurve(WING_SLOPE, STALL, aspect);
/** The tail flies in the downwash of the wing, which takes a third of its angle. */
const TAIL_LIFT = liftCurve(2.6, STALL);
const TAIL_DRAG = dragCurve(2.6, STALL, 4);

/** Wing panels: distance along the span, m, and how much an aileron changes the angle there. Rows rise by the dihedral. */
const PANELS = [
  { z: -4.1, aileron: 0.4 },
  { z: -1.4, aileron: 0 },
  { z: 1.4, aileron: 0 },
  { z: 4.1, aileron: -0.4 },
] as const;
const DIHEDRAL = 2.5 * DEGREE;
export const INCIDENCE = 2.5 * DEGREE;

/** The wind, m/s, as a constant vector or over time. */
export type Wind = NonNullable<WingOptions['wind']>;

export function aircraftForces(wind: Wind): Force[] {
  const air = { density: AIR_DENSITY, wind };
  const panels = PANELS.map(({ z, aileron }) => {
    const tilt = z > 0 ? DIHEDRAL : -DIHEDRAL;
    return wing({
      ...air,
      area: AIRCRAFT.wingArea / PANELS.length,
      lift: WING_LIFT,
      drag: WING_DRAG,
      position: { x: 0.22, y: 0.6, z },
      span: { y: sin(tilt), z: cos(tilt) },
      incidence: INCIDENCE,
      ...(aileron === 0 ? {} : { deflection: { component: Deflections, field: 'aileron', effectiveness: aileron } }),
    });
  });
  const tail = { ...air, lift: TAIL_LIFT, drag: TAIL_DRAG };
  return [
    uniformGravity(),
    thrust({ frame: 'body' }),
    quadraticDrag(wind),
    ...panels,
    wing({
      ...tail,
      area: 3.4,
      position: { x: -4.6, y: 0.1 },
      incidence: -1.2 * DEGREE,
      deflection: { component: Deflections, field: 'elevator', effectiveness: -0.5 },
    }),
    wing({
      ...tail,
      area: 1.8,
      position: { x: -4.9, y: 0.6 },
      span: { y: 1 },
      deflection: { component: Deflections, field: 'rudder', effectiveness: 0.5 },
    }),
  ];
}

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

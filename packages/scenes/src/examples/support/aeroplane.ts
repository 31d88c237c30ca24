/** The aeroplane of the flight simulator: its numbers, its control surfaces, and its steady flight. */
import {
  atan2,
  axial3,
  cos,
  defineComponent,
  defineLaw,
  type Force,
  piecewiseLinear,
  quadraticDrag,
  realField,
  sin,
  thrust,
  uniformGravity,
  wing,
} from '@principia/physics';
import { rootOf } from './functions.ts';

export const DEGREE = Math.PI / 180;

/** SI units; areas in m². */
export const AEROPLANE = {
  mass: 30_000,
  gravity: 10,
  inertiaTensor: { x: 20_000, y: 160_000, z: 160_000 },
  wingArea: 150,
  elevatorArea: 10,
  rudderArea: 6,
  aileronArea: 10,
  aileronArm: 9,
  tailArm: 35,
  incidence: 10 * DEGREE,
  /** Drag is k v², kg/m. */
  drag: 37.5,
  maxThrust: 500_000,
} as const;

/** Deflections of the control surfaces, rad: positive rolls to the left, raises the nose, turns to the left. */
export const Steering = defineComponent({
  fields: { aileron: realField('rad'), elevator: realField('rad'), rudder: realField('rad') },
});

/** Five per radian up to 20°, and 1.2 beyond the stall. */
const SLOPE = 5;
const STALL = 20 * DEGREE;
/** Width of the step at the stall, rad: a curve has no vertical lines. */
const STEP = 1e-6;
const LIFT = [
  [-STALL - STEP, -1.2],
  [-STALL, -SLOPE * STALL],
  [STALL, SLOPE * STALL],
  [STALL + STEP, 1.2],
] as const;
const NO_DRAG = [
  [-1, 0],
  [1, 0],
] as const;

/**
 * Ailerons roll by a pure couple, and the elevator pitches by a force on the tail; neither feels the angle of attack, so
 * that the attitude is what the pilot makes it.
 */
const controlSurfaces = defineLaw({
  name: 'control surfaces',
  formula: 'F = ½ ρ A C_L(δ) |w| (s × w) at the tail; τ = d ρ A C_L(δ) |w|² about the axis of roll',
  reads: { steering: Steering },
  force: ({ velocity, rotate, steering }) => elevatorForce(velocity, rotate(axial3(0, 0, 1)), steering.elevator),
  torque({ velocity, rotate, steering }) {
    const forwards = rotate(axial3(1, 0, 0));
    const tail = forwards.mul(-AEROPLANE.tailArm);
    const pitch = tail.cross(elevatorForce(velocity, rotate(axial3(0, 0, 1)), steering.elevator));
    const couple = piecewiseLinear(steering.aileron, LIFT).mul(AEROPLANE.aileronArm * AEROPLANE.aileronArea);
    return pitch.sub(forwards.mul(couple.mul(velocity.lengthSquared())));
  },
});

type Symbols = Parameters<NonNullable<Parameters<typeof defineLaw>[0]['force']>>[0];

/** A raised elevator pushes the tail down. */
function elevatorForce(velocity: Symbols['velocity'], span: Symbols['velocity'], angle: Symbols['mass']) {
  const w = velocity.sub(span.mul(span.dot(velocity)));
  const size = piecewiseLinear(angle, LIFT).mul(-AEROPLANE.elevatorArea / 2);
  return span.cross(w).mul(w.length().mul(size));
}

/** Damping of rotation at a rate of its own, 1/s, as the book's program multiplies the spin by 0.2 sixty times a second. */
export const DAMPING = 240;

const spinDamping = defineLaw({
  name: 'damping of rotation',
  formula: 'τ = -k I ω',
  torque({ angularVelocity, rotate }) {
    const { x, y, z } = AEROPLANE.inertiaTensor;
    const about = (axis: ReturnType<typeof axial3>, moment: number) =>
      axis.mul(axis.dot(angularVelocity).mul(-DAMPING * moment));
    return about(rotate(axial3(1, 0, 0)), x)
      .add(about(rotate(axial3(0, 1, 0)), y))
      .add(about(rotate(axial3(0, 0, 1)), z));
  },
});

export function aeroplaneForces(): Force[] {
  const { wingArea: area, rudderArea, incidence, tailArm, gravity } = AEROPLANE;
  const air = { density: 1, lift: LIFT, drag: NO_DRAG };
  return [
    uniformGravity({ y: -gravity }),
    thrust({ frame: 'body' }),
    quadraticDrag(),
    wing({ ...air, area, incidence }),
    wing({
      ...air,
      area: rudderArea,
      position: { x: -tailArm },
      span: { y: 1 },
      deflection: { component: Steering, field: 'rudder' },
    }),
    controlSurfaces(),
    spinDamping(),
  ];
}

/** Steady straight flight in level attitude: speed along the ground and climb, m/s. */
export function steadyFlight(push: number): { readonly forwards: number; readonly climb: number } {
  const { mass, gravity, wingArea, incidence, drag } = AEROPLANE;
  const weight = mass * gravity;
  // Along and across the level body: T = V² (k cos γ + l sin γ), m g = V² (l cos γ - k sin γ), with the path at γ.
  const isStalled = (path: number) => incidence - path > STALL;
  const lift = (path: number) => ((isStalled(path) ? 1.2 : SLOPE * (incidence - path)) * wingArea) / 2;
  const speed2 = (path: number) => weight / (lift(path) * cos(path) - drag * sin(path));
  const excess = (path: number) => push - speed2(path) * (drag * cos(path) + lift(path) * sin(path));
  const stalling = incidence - STALL;
  // With little thrust it sinks so steeply that the wing stalls.
  const path =
    excess(stalling) < 0 ? rootOf(excess, -60 * DEGREE, stalling - 1e-9) : rootOf(excess, stalling, 0.9 * incidence);
  const speed = Math.sqrt(speed2(path));
  return { forwards: speed * cos(path), climb: speed * sin(path) };
}

/** Thrust and speed at which the aeroplane in level attitude neither climbs nor sinks. */
export function levelFlight(): { readonly thrust: number; readonly speed: number } {
  const { mass, gravity, wingArea, incidence, drag } = AEROPLANE;
  const speed = Math.sqrt((2 * mass * gravity) / (wingArea * SLOPE * incidence));
  return { thrust: drag * speed * speed, speed };
}

/** Angles of the attitude, rad: heading to the left of +x, pitch upwards. */
export function headingAndPitch(forwards: { readonly x: number; readonly y: number; readonly z: number }) {
  const { x, y, z } = forwards;
  return { heading: atan2(-z, x), pitch: atan2(y, Math.sqrt(x * x + z * z)) };
}

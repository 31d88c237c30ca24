/** The landing gear: three wheels on damped springs that roll, brake and hold their track. */
import { defineForce, type Force, type PhysicsWorld } from '@principia/physics';
import { type Axes, alongAxes, pointVelocity, rotated } from './body-frame.ts';
import { groundHeight, isOnRunway } from './terrain.ts';

/** A wheel: the lowest point of its tyre in the body's axes when no load is on it, m. */
export interface Wheel {
  readonly at: Axes;
  /** N/m and N s/m. */
  readonly stiffness: number;
  readonly damping: number;
  readonly hasBrake: boolean;
  /** It turns with the rudder. */
  readonly steers: boolean;
}

export const WHEELS: readonly Wheel[] = [
  { at: { x: 1.3, y: -1.3, z: 0 }, stiffness: 30_000, damping: 3000, hasBrake: false, steers: true },
  { at: { x: -0.45, y: -1.3, z: -1.3 }, stiffness: 48_000, damping: 5000, hasBrake: true, steers: false },
  { at: { x: -0.45, y: -1.3, z: 1.3 }, stiffness: 48_000, damping: 5000, hasBrake: true, steers: false },
];

/** Coefficients of friction: along a free wheel on tarmac and on grass, of a brake, and sideways. */
export const ROLLING = { tarmac: 0.02, grass: 0.07, brake: 0.45, sideways: 0.8 } as const;

/** Speed below which friction fades, m/s: a wheel at rest feels none. */
const SLIP = 0.15;
/** Angle by which the nose wheel turns with a full rudder, as a ratio of the angles. */
const STEERING = 0.5;

/** What the gear reads of the aeroplane's controls. */
export interface GearState {
  /** 0 to 1. */
  brake: number;
  /** Deflection of the rudder, rad. */
  rudder: number;
}

/** The force of the ground on the wheels of one body. */
export function landingGear(plane: number, state: GearState): Force {
  return defineForce({
    name: 'landing gear',
    equation: 'N = k d + c ḋ ≥ 0, F = -μ N u/√(u² + ε²) along and across the wheel',
    reads: ['Position', 'Velocity', 'Orientation', 'AngularVelocity'],
    local: false,
    appliesTorque: true,
    accumulate(world) {
      if (world.components.Position.y[plane] > groundHeightBelow(world, plane) + 4) return;
      for (let w = 0; w < WHEELS.length; w++) addWheel(world, plane, WHEELS[w], state);
    },
  });
}

function groundHeightBelow({ components: { Position } }: PhysicsWorld, plane: number): number {
  return groundHeight(Position.x[plane], Position.z[plane]);
}

const arm = { x: 0, y: 0, z: 0 };
const velocity = { x: 0, y: 0, z: 0 };
const forwards = { x: 0, y: 0, z: 0 };

/** Compression of a wheel's spring, m; negative above the ground. */
export function compression(world: PhysicsWorld, plane: number, wheel: Wheel): number {
  rotated(world, plane, wheel.at, arm);
  const { x, y, z } = world.components.Position;
  return groundHeight(x[plane] + arm.x, z[plane] + arm.z) - (y[plane] + arm.y);
}

function addWheel(world: PhysicsWorld, plane: number, wheel: Wheel, { brake, rudder }: GearState): void {
  const depth = compression(world, plane, wheel);
  if (depth <= 0) return;
  pointVelocity(world, plane, arm, velocity);
  const normal = Math.max(0, wheel.stiffness * depth - wheel.damping * velocity.y);
  const turn = wheel.steers ? STEERING * rudder : 0;
  alongAxes(world, plane, turn, forwards);
  // Along and across the wheel on level ground; right of (fx, fz) is (-fz, fx).
  const along = velocity.x * forwards.x + velocity.z * forwards.z;
  const across = -velocity.x * forwards.z + velocity.z * forwards.x;
  const { Position } = world.components;
  const isTarmac = isOnRunway(Position.x[plane] + arm.x, Position.z[plane] + arm.z);
  const rolling = (isTarmac ? ROLLING.tarmac : ROLLING.grass) + (wheel.hasBrake ? brake * ROLLING.brake : 0);
  const push = -rolling * normal * faded(along);
  const hold = -ROLLING.sideways * normal * faded(across);
  const fx = push * forwards.x - hold * forwards.z;
  const fz = push * forwards.z + hold * forwards.x;
  const { force, torque } = world.scratch;
  force.x[plane] += fx;
  force.y[plane] += normal;
  force.z[plane] += fz;
  torque.x[plane] += arm.y * fz - arm.z * normal;
  torque.y[plane] += arm.z * fx - arm.x * fz;
  torque.z[plane] += arm.x * normal - arm.y * fx;
}

/** The sign of a speed, faded below the slip speed so that friction does not rattle. */
function faded(speed: number): number {
  return speed / Math.sqrt(speed * speed + SLIP * SLIP);
}

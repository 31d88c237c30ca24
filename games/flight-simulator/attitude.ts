/** What the instruments show: attitude, path and speeds of the aeroplane. */
import { atan2, type PhysicsWorld } from '@principia/physics';
import { angleOfAttack } from './aircraft.ts';
import { type Axes, rotated } from './body-frame.ts';

/** SI units; angles in rad. */
export interface Attitude {
  /** Nose above the horizon. */
  pitch: number;
  /** Right wing down. */
  bank: number;
  /** From north, which is -z, clockwise: the runway has 90°. */
  heading: number;
  /** Rates about the body's axes, rad/s: right wing down, nose up, nose right. */
  rollRate: number;
  pitchRate: number;
  yawRate: number;
  /** Speed through the air, m/s. */
  airspeed: number;
  /** Angle of attack of the wing. */
  attack: number;
  /** Angle of the air from the right. */
  sideslip: number;
}

const X = { x: 1, y: 0, z: 0 };
const Y = { x: 0, y: 1, z: 0 };
const Z = { x: 0, y: 0, z: 1 };

/** Reads the attitude of a body in a wind, m/s, into a record. */
export function readAttitude(world: PhysicsWorld, body: number, wind: Readonly<Axes>, out: Attitude): Attitude {
  const { Velocity: v, AngularVelocity: w } = world.components;
  rotated(world, body, X, f);
  rotated(world, body, Y, u);
  rotated(world, body, Z, r);
  const [ax, ay, az] = [v.x[body] - wind.x, v.y[body] - wind.y, v.z[body] - wind.z];
  const forwards = ax * f.x + ay * f.y + az * f.z;
  const up = ax * u.x + ay * u.y + az * u.z;
  const right = ax * r.x + ay * r.y + az * r.z;
  out.pitch = atan2(f.y, Math.sqrt(f.x * f.x + f.z * f.z));
  out.bank = atan2(-r.y, u.y);
  const heading = atan2(f.x, -f.z);
  out.heading = heading < 0 ? heading + 2 * Math.PI : heading;
  out.rollRate = w.x[body] * f.x + w.y[body] * f.y + w.z[body] * f.z;
  out.yawRate = -(w.x[body] * u.x + w.y[body] * u.y + w.z[body] * u.z);
  out.pitchRate = w.x[body] * r.x + w.y[body] * r.y + w.z[body] * r.z;
  out.airspeed = Math.sqrt(ax * ax + ay * ay + az * az);
  const isMoving = out.airspeed > 2;
  out.attack = isMoving ? angleOfAttack(forwards, up) : 0;
  out.sideslip = isMoving ? atan2(right, Math.abs(forwards)) : 0;
  return out;
}

const f: Axes = { x: 0, y: 0, z: 0 };
const u: Axes = { x: 0, y: 0, z: 0 };
const r: Axes = { x: 0, y: 0, z: 0 };

export function createAttitude(): Attitude {
  return {
    pitch: 0,
    bank: 0,
    heading: 0,
    rollRate: 0,
    pitchRate: 0,
    yawRate: 0,
    airspeed: 0,
    attack: 0,
    sideslip: 0,
  };
}

/** Vectors of the aeroplane's own axes in the world, without an object for each. */
import { cos, type PhysicsWorld, sin } from '@principia/physics';

export interface Axes {
  x: number;
  y: number;
  z: number;
}

/** Rotates a vector of the body's axes to the world's. */
export function rotated(
  { components: { Orientation: q } }: PhysicsWorld,
  body: number,
  v: Readonly<Axes>,
  out: Axes,
): Axes {
  const [a, b, c, w] = [q.x[body], q.y[body], q.z[body], q.w[body]];
  const { x, y, z } = v;
  const tx = b * z - c * y + w * x;
  const ty = c * x - a * z + w * y;
  const tz = a * y - b * x + w * z;
  out.x = x + 2 * (b * tz - c * ty);
  out.y = y + 2 * (c * tx - a * tz);
  out.z = z + 2 * (a * ty - b * tx);
  return out;
}

/** Velocity of a point of the body, given by its arm in the world's axes, m/s. */
export function pointVelocity(
  { components: { Velocity: v, AngularVelocity: w } }: PhysicsWorld,
  body: number,
  arm: Readonly<Axes>,
  out: Axes,
): Axes {
  out.x = v.x[body] + w.y[body] * arm.z - w.z[body] * arm.y;
  out.y = v.y[body] + w.z[body] * arm.x - w.x[body] * arm.z;
  out.z = v.z[body] + w.x[body] * arm.y - w.y[body] * arm.x;
  return out;
}

/** The level unit vector in which a wheel rolls that is turned to the right by an angle, rad. */
export function alongAxes(world: PhysicsWorld, body: number, right: number, out: Axes): Axes {
  heading.x = cos(right);
  heading.z = sin(right);
  rotated(world, body, heading, out);
  const length = Math.sqrt(out.x * out.x + out.z * out.z);
  const scale = length > 1e-6 ? 1 / length : 0;
  out.x *= scale;
  out.y = 0;
  out.z *= scale;
  return out;
}

const heading = { x: 1, y: 0, z: 0 };

/** Measurements of orbits. */
import { type PhysicsWorld, step } from '@principia/physics';

export interface Turn {
  /** Minimum and maximum distance. */
  readonly near: number;
  readonly far: number;
  /** Time between two minima of the distance, s; NaN if there is only one. */
  readonly period: number;
  /** Angle about the centre in that time, rad. */
  readonly angle: number;
}

/** Measures the distance of a body from a point; extremes are interpolated by a parabola. */
export function measureOrbit(
  world: PhysicsWorld,
  eid: number,
  centre: { x: number; y: number },
  seconds: number,
  dt: number,
): Turn {
  const { x, y } = world.components.Position;
  const minima: { time: number; angle: number }[] = [];
  let [near, far] = [Infinity, 0];
  let angle = 0;
  let heading = Math.atan2(y[eid] - centre.y, x[eid] - centre.x);
  let before: { r: number; angle: number } | undefined;
  let here = { r: Math.hypot(x[eid] - centre.x, y[eid] - centre.y), angle: 0 };
  for (let time = 0; time < seconds; time += dt) {
    step(world, dt);
    const next = Math.atan2(y[eid] - centre.y, x[eid] - centre.x);
    angle += Math.atan2(Math.sin(next - heading), Math.cos(next - heading));
    heading = next;
    const after = { r: Math.hypot(x[eid] - centre.x, y[eid] - centre.y), angle };
    near = Math.min(near, after.r);
    far = Math.max(far, after.r);
    if (before !== undefined && (here.r - before.r) * (after.r - here.r) <= 0) {
      const bend = before.r - 2 * here.r + after.r;
      // A circle has no extremes.
      const at = bend === 0 ? 0 : (before.r - after.r) / (2 * bend);
      const extreme = bend === 0 ? here.r : here.r - (after.r - before.r) ** 2 / 8 / bend;
      near = Math.min(near, extreme);
      far = Math.max(far, extreme);
      if (bend > 0) minima.push({ time: time + at * dt, angle: here.angle + (at * (after.angle - before.angle)) / 2 });
    }
    before = here;
    here = after;
  }
  const [first, second] = minima;
  return {
    near,
    far,
    period: minima.length > 1 ? second.time - first.time : Number.NaN,
    angle: minima.length > 1 ? second.angle - first.angle : Number.NaN,
  };
}

/** Returns the times at which a coordinate of a body crosses a value upwards, by linear interpolation. */
export function crossings(
  world: PhysicsWorld,
  coordinate: () => number,
  value: number,
  seconds: number,
  dt: number,
): number[] {
  const times: number[] = [];
  let last = coordinate() - value;
  for (let time = 0; time < seconds; time += dt) {
    step(world, dt);
    const now = coordinate() - value;
    if (last < 0 && now >= 0) times.push(time + (dt * last) / (last - now));
    last = now;
  }
  return times;
}

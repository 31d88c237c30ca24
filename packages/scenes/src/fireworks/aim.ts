// Computes the launch velocity with which a shell reaches the apex of its trajectory at a given point.
// |
// | x'' = -(k/m) |x' - w| (x' - w) - g
// |
// Straight up in still air: v0² = (m g/k) (e^(2 k h/m) - 1), t = √(m/k g) atan(v0 √(k/m g)) (Parker, American Journal
// of Physics 45, 606, 1977). With wind or at an angle there is no closed form: the launch velocity is corrected
// iteratively.
import { atan2, exp, type Vector } from '@principia/physics';

/** The medium of a shell's flight. */
export interface Air {
  /** k/m, 1/m. */
  readonly drag: number;
  /** m/s². */
  readonly gravity: number;
  /** Velocity along x, m/s. */
  readonly wind: number;
}

/** Launch velocity, m/s, and time to the apex, s. */
export interface Throw {
  readonly velocity: Vector;
  readonly fuse: number;
}

/** Launch speed and time to height `h` for a vertical launch in still air. */
export function verticalThrow(h: number, { drag, gravity }: Air): { speed: number; fuse: number } {
  const speed = Math.sqrt((gravity / drag) * (exp(2 * drag * h) - 1));
  return { speed, fuse: atan2(speed * Math.sqrt(drag / gravity), 1) / Math.sqrt(drag * gravity) };
}

const ITERATIONS = 8;

/** @param way vector from the mortar to the target, m; `y` is positive @param dt time step of the world, s */
export function aim(way: Vector, air: Air, dt: number): Throw {
  const first = verticalThrow(way.y, air);
  let [x, y, z] = [way.x / first.fuse, first.speed, way.z / first.fuse];
  let fuse = first.fuse;
  for (let trial = 0; trial < ITERATIONS; trial++) {
    const top = flyToTop(x, y, z, air, dt);
    fuse = top.time;
    x += (way.x - top.x) / fuse;
    z += (way.z - top.z) / fuse;
    // Height grows with the square of the speed.
    y *= Math.sqrt(way.y / top.y);
  }
  return { velocity: { x, y, z }, fuse };
}

/** Integrates as the world does: half a drift, kick, half a drift. */
function flyToTop(vx: number, vy: number, vz: number, { drag, gravity, wind }: Air, dt: number) {
  let [x, y, z, time] = [0, 0, 0, 0];
  for (;;) {
    const still = vy - gravity * dt;
    x += 0.5 * vx * dt;
    y += 0.5 * vy * dt;
    z += 0.5 * vz * dt;
    const rx = vx - wind;
    const k = drag * Math.sqrt(rx * rx + vy * vy + vz * vz) * dt;
    vx -= k * rx;
    vy = still - k * vy;
    vz -= k * vz;
    x += 0.5 * vx * dt;
    y += 0.5 * vy * dt;
    z += 0.5 * vz * dt;
    time += dt;
    if (vy <= 0) return { x, y, z, time };
  }
}

import { bodies } from '@principia/physics';
import type { Particles } from '@principia/scenes';

/** The state of a `particles` world as dense arrays of its precision, with its constants. */
export function particleColumns({ world, dt, gravity, side, restitution }: Particles) {
  const { ids, count } = bodies(world);
  const Real = world.precision === 'f32' ? Float32Array : Float64Array;
  const dense = (column: Column): Column => {
    const values = new Real(count);
    for (let i = 0; i < count; i++) values[i] = column[ids[i] as number] as number;
    return values;
  };
  const { Position, Velocity, Mass, QuadraticDrag, Collider } = world.components;
  return {
    count,
    dt,
    gravity,
    side,
    wall: restitution,
    x: dense(Position.x),
    y: dense(Position.y),
    z: dense(Position.z),
    vx: dense(Velocity.x),
    vy: dense(Velocity.y),
    vz: dense(Velocity.z),
    mass: dense(Mass.value),
    drag: dense(QuadraticDrag.coefficient),
    radius: dense(Collider.radius),
  };
}

export type ParticleColumns = ReturnType<typeof particleColumns>;
export type Column = Float32Array | Float64Array;

/**
 * Brings body `i`, beyond the wall at `plane` whose inside is towards `side`, back in: the instant of impact inside the
 * step, as in kernels/walls. Velocities of semi-implicit Euler lag its positions by half a step.
 */
export function rebound(
  x: Column,
  v: Column,
  i: number,
  start: number,
  plane: number,
  side: number,
  e: number,
  dt: number,
): void {
  const depth = side * (plane - x[i]);
  const pull = (side * (start - v[i])) / dt;
  const speed = 0.5 * pull * dt - side * v[i];
  if (!(speed > 0)) {
    x[i] = plane;
    return;
  }
  const then = Math.sqrt(Math.max(speed * speed - 2 * pull * depth, 0));
  const since = Math.min((2 * depth) / (then + speed), dt);
  const impact = Math.max(speed - pull * since, 0);
  const out = since * (e * impact - 0.5 * pull * since);
  const flies = out > 0 && impact > 0;
  x[i] = flies ? plane + side * out : plane;
  v[i] = flies ? side * (e * impact - pull * (since - 0.5 * dt)) : 0;
}

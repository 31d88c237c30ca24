/** Problems with exact solutions, to measure integrators. */
import {
  attractors,
  createPhysicsWorld,
  defineForce,
  type Force,
  type Integrator,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  spawn,
  step,
} from '@principia/physics';

/** A body in 2D, and its world. */
export interface Single {
  readonly world: PhysicsWorld;
  readonly body: number;
}

/** x, y, vx, vy. */
export type State = readonly [number, number, number, number];

export function stateOf({ world, body }: Single): State {
  const { Position, Velocity } = world.components;
  return [Position.x[body], Position.y[body], Velocity.x[body], Velocity.y[body]];
}

export function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(...a.map((value, i) => value - b[i]));
}

export function advance({ world }: Single, time: number, steps: number): void {
  for (let i = 0; i < steps; i++) step(world, time / steps);
}

/** A planet with semi-major axis 1 about a fixed centre of μ = 1, at its periapsis; its period is 2π. */
export function kepler(integrator: Integrator, e: number, options: PhysicsWorldOptions = {}): Single {
  const world = createPhysicsWorld({ capacity: 10, integrator, forces: [attractors()], ...options });
  spawn(world, { position: {}, attractor: 1 });
  const velocity = { y: Math.sqrt((1 + e) / (1 - e)) };
  return { world, body: spawn(world, { position: { x: 1 - e }, velocity, mass: 1 }) };
}

/** Returns its position after `time`, by Kepler's equation. */
export function keplerExact(e: number, time: number): State {
  let anomaly = time;
  for (let i = 0; i < 100; i++) anomaly -= (anomaly - e * Math.sin(anomaly) - time) / (1 - e * Math.cos(anomaly));
  const [cos, sin, b] = [Math.cos(anomaly), Math.sin(anomaly), Math.sqrt(1 - e * e)];
  const r = 1 - e * cos;
  return [cos - e, b * sin, -sin / r, (b * cos) / r];
}

/** F = -m ω² x - m γ v along x. */
function springAndDamper(stiffness: number, damping: number): Force {
  return defineForce({
    name: 'spring and damper',
    reads: ['Position', 'Velocity', 'Mass'],
    accumulate({ components: { Position, Velocity, Mass }, scratch }, first, last) {
      for (let i = first; i < last; i++) {
        scratch.force.x[i] -= Mass.value[i] * (stiffness * Position.x[i] + damping * Velocity.x[i]);
      }
    },
    potential({ components: { Position, Mass }, lastId }) {
      let sum = 0;
      for (let i = 1; i <= lastId; i++) sum += (Mass.value[i] * stiffness * Position.x[i] ** 2) / 2;
      return sum;
    },
  });
}

/** A damped oscillator with x = 1, v = 0.3 at the start. */
export function oscillator(
  integrator: Integrator,
  stiffness: number,
  damping: number,
  options: PhysicsWorldOptions = {},
): Single {
  const world = createPhysicsWorld({
    capacity: 10,
    integrator,
    forces: [springAndDamper(stiffness, damping)],
    ...options,
  });
  return { world, body: spawn(world, { position: { x: 1 }, velocity: { x: 0.3 }, mass: 1 }) };
}

export function oscillatorExact(stiffness: number, damping: number, time: number): State {
  const g = damping / 2;
  const w = Math.sqrt(stiffness - g * g);
  const b = (0.3 + g) / w;
  const [cos, sin, fade] = [Math.cos(w * time), Math.sin(w * time), Math.exp(-g * time)];
  const x = fade * (cos + b * sin);
  return [x, 0, fade * w * (b * cos - sin) - g * x, 0];
}

/** Returns the order of convergence from three step lengths, each half the previous one. */
export function orders(error: (steps: number) => number, steps: number): number[] {
  const [a, b, c] = [error(steps), error(2 * steps), error(4 * steps)];
  return [Math.log2(a / b), Math.log2(b / c)];
}

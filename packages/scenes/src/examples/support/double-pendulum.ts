/** Double pendulums: two equal bobs on two equal rods without mass. */
import { cos, defineForce, type Force, type PhysicsWorld, sin, spawn } from '@principia/physics';

export interface DoublePendulum {
  /** The bob at the end of the first rod, which hangs at the origin. */
  readonly inner: number;
  readonly outer: number;
}

/**
 * A double pendulum at rest, with rods of 1 m and bobs of 1 kg.
 * @param angles of the rods from straight down, rad
 */
export function addDoublePendulum(
  world: PhysicsWorld,
  angles: readonly [number, number],
  color: number,
): DoublePendulum {
  const [a, b] = angles;
  const bob = { velocity: {}, mass: 1 };
  const knee = { x: sin(a), y: -cos(a) };
  return {
    inner: spawn(world, { ...bob, position: knee, appearance: { size: 0.02, color } }),
    outer: spawn(world, {
      ...bob,
      position: { x: knee.x + sin(b), y: knee.y - cos(b) },
      appearance: { size: 0.05, color },
    }),
  };
}

/**
 * The tensions T₁ and T₂ of both rods, which keep their lengths: n₁·a₁ = −v₁²/r₁ and n₂·(a₂ − a₁) = −(v₂ − v₁)²/r₂. The
 * acceleration is exactly that of rigid rods, so lengths and energy are as good as the integrator. Goldstein, Classical
 * Mechanics, section 1.3.
 * @param gravity downwards, m/s², the only other force
 */
export function rodTensions(pendulums: readonly DoublePendulum[], gravity: number): Force {
  return defineForce({
    name: 'tension of two rods',
    equation: 'n₁·a₁ = −v₁²/r₁, n₂·(a₂ − a₁) = −(v₂ − v₁)²/r₂',
    reads: ['Position', 'Velocity', 'Mass'],
    local: false,
    accumulate({ components: { Position: p, Velocity: v, Mass }, scratch: { force } }) {
      for (let i = 0; i < pendulums.length; i++) {
        const { inner: a, outer: b } = pendulums[i];
        const m = Mass.value[a];
        const [x1, y1, x2, y2] = [p.x[a], p.y[a], p.x[b] - p.x[a], p.y[b] - p.y[a]];
        const [r1, r2] = [Math.sqrt(x1 * x1 + y1 * y1), Math.sqrt(x2 * x2 + y2 * y2)];
        const [ux, uy] = [v.x[b] - v.x[a], v.y[b] - v.y[a]];
        const c = (x1 * x2 + y1 * y2) / (r1 * r2);
        const first = (m * (v.x[a] * v.x[a] + v.y[a] * v.y[a] - gravity * y1)) / r1;
        const second = (m * (ux * ux + uy * uy)) / r2;
        const t1 = (2 * first + c * second) / (2 - c * c) / r1;
        const t2 = (second + c * t1 * r1) / 2 / r2;
        force.x[a] += t2 * x2 - t1 * x1;
        force.y[a] += t2 * y2 - t1 * y1;
        force.x[b] -= t2 * x2;
        force.y[b] -= t2 * y2;
      }
    },
  });
}

// Turns bodies at their angular velocity: the angle in 2D, the quaternion in 3D. Nothing to do while no body spins.
import type { LocalSystem } from '../schedule/phases';
import type { PhysicsWorld } from '../world';

export const turn: LocalSystem = {
  name: 'turn',
  run(world, spans, dt) {
    if (world.internal.counts.AngularVelocity === 0) return;
    for (let r = 0; r < spans.count; r++) {
      turnRun(world, spans.bounds[2 * r] as number, spans.bounds[2 * r + 1] as number, dt);
    }
  },
};

function turnRun(world: PhysicsWorld, first: number, last: number, dt: number): void {
  const { kernels, addresses } = world;
  const { AngularVelocity: w, Orientation: q, Rotation } = addresses;
  if (world.dimensions === 2) kernels.driftAxis(Rotation.angle, w.z, dt, first, last);
  else kernels.turnQuaternion(q.x, q.y, q.z, q.w, w.x, w.y, w.z, dt, first, last);
}

// The inertia of a body that is pulled hard at its ends. A force f at the arm r turns the body back when it turns, as a spring
// of k = r · f per radian does; with the inertia I it swings with the frequency √(k/I), which in a taut chain of light
// links is more than sub-steps of h seconds can follow. Joints then see the inertia h² k, which swings with the rate of the
// sub-steps: the chain is stable, and nothing changes where h² k is below I.
// Sources: Tournier et al., Stable Constrained Dynamics (SIGGRAPH 2015); Andrews et al., Geometric Stiffness for Real-time
// Constrained Multibody Dynamics (Eurographics 2017).
import { articulated } from './articulated-body';
import { JointTable, impulsesOf } from './joint-table';
import { JointWork, isHinge, rowOf } from './joint-work';

// Adds h k of both bodies, by the impulses of the last sub-step, which are forces times h, and the anchors from the centres.
export function addStiffness(t: JointTable, work: JointWork): void {
  let x = work.impulseX;
  let y = work.impulseY;
  if (!isHinge(work)) {
    const impulses = impulsesOf(t, work.id);
    const r0 = rowOf(work, 0);
    const r1 = rowOf(work, 1);
    const r2 = rowOf(work, 2);
    x = impulses.lock0 * r0.x + impulses.lock1 * r1.x + impulses.lock2 * r2.x;
    y = impulses.lock0 * r0.y + impulses.lock1 * r1.y + impulses.lock2 * r2.y;
  }
  articulated(t, work.a).stiffness -= x * work.rax + y * work.ray;
  articulated(t, work.b).stiffness += x * work.rbx + y * work.rby;
}

// The inverse of the inertia that joints see; `least` is h² k.
// @ts-ignore: decorator
@inline export function braced(inverseInertia: f64, least: f64): f64 {
  return inverseInertia * least > 1 ? 1 / least : inverseInertia;
}

// The inertia of a body that is pulled hard at its ends. A force f at the arm r turns the body back when it turns, as a spring
// of k = r · f per radian does; with the inertia I it swings with the frequency √(k/I), which in a taut chain of light
// links is more than sub-steps of h seconds can follow. Joints then see the inertia h² k, which swings with the rate of the
// sub-steps: the chain is stable, and nothing changes where h² k is below I.
// Sources: Tournier et al., Stable Constrained Dynamics (SIGGRAPH 2015); Andrews et al., Geometric Stiffness for Real-time
// Constrained Multibody Dynamics (Eurographics 2017).
import { poseOf } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { articulated } from './articulated-body';
import { JointTable, impulsesOf } from './joint-table';
import { JointWork, rowOf, workAt } from './joint-work';

// Sets the inertias for the forces of the last sub-step.
export function braceJoints(t: JointTable): void {
  const rigid = changetype<RigidTable>(t.rigid);
  for (let i = 0; i < t.workCount; i++) {
    articulated(t, workAt(t, i).a).fw = 0;
    articulated(t, workAt(t, i).b).fw = 0;
  }
  for (let i = 0; i < t.workCount; i++) addStiffness(t, workAt(t, i));
  for (let i = 0; i < t.workCount; i++) {
    const work = workAt(t, i);
    work.inertiaA = braced(<f64>poseOf(rigid, work.rowA).inverseInertia, rigid.h * articulated(t, work.a).fw);
    work.inertiaB = braced(<f64>poseOf(rigid, work.rowB).inverseInertia, rigid.h * articulated(t, work.b).fw);
  }
}

// Adds h k of both bodies: impulses are forces times h.
function addStiffness(t: JointTable, work: JointWork): void {
  const impulses = changetype<usize>(impulsesOf(t, work.id));
  let x: f64 = 0;
  let y: f64 = 0;
  for (let p = 0; p < work.locks; p++) {
    const impulse = load<f64>(impulses + ((<usize>p) << 3));
    x += impulse * rowOf(work, p).x;
    y += impulse * rowOf(work, p).y;
  }
  articulated(t, work.a).fw -= x * work.rax + y * work.ray;
  articulated(t, work.b).fw += x * work.rbx + y * work.rby;
}

// @ts-ignore: decorator
@inline function braced(inverseInertia: f64, least: f64): f64 {
  return inverseInertia * least > 1 ? 1 / least : inverseInertia;
}

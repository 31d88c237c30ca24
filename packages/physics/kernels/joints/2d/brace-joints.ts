// The inertia of a body that is pulled hard at its ends. A force f at the arm r turns the body back when it turns, as a spring
// of k = r · f per radian does; with the inertia I it swings with the frequency √(k/I), which in a taut chain of light
// links is more than sub-steps of h seconds can follow. Joints and contacts then see the inertia h² k, which swings with the
// rate of the sub-steps: the chain is stable, and nothing changes where h² k is below I. Contacts have to see what joints see:
// with the true inertia, what a contact gives would weigh h² k/I times as much to the joints, and a loaded chain about a peg
// would burst.
// Sources: Tournier et al., Stable Constrained Dynamics (SIGGRAPH 2015); Andrews et al., Geometric Stiffness for Real-time
// Constrained Multibody Dynamics (Eurographics 2017).
import { poseOf, stateOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { openAxes } from '../../solver/2d/motion-locks';
import { articulated } from './articulated-body';
import { JointTable } from './joint-table';

// A body as its joints see it, by row.
@unmanaged
export class JointedBody {
  // The inverse of its moment of inertia, 0 for a body that may not turn.
  inverseInertia: f64;
  // Torque by which pulling joints turn the body back, times the length of a sub-step, for each radian, N m s.
  stiffness: f64;
  // Number of joints that hold it.
  joints: f64;
  // Half of a sub-step, s, for its chords (chords.ts); 0 for a body that is held at two ends and whose inertia was raised.
  halfStep: f64;
  // Velocity at the end of the last sub-step; kept up to date for joints with rows.
  vx: f64;
  vy: f64;
  w: f64;
  // The same as `stiffness` by rods and ropes of trees in this sub-step (brace-rods.ts).
  rodStiffness: f64;
}

export const JOINTED_BODY_SIZE: usize = offsetof<JointedBody>();

// @ts-ignore: decorator
@inline export function jointed(t: JointTable, row: i32): JointedBody {
  return changetype<JointedBody>(t.jointed + <usize>row * JOINTED_BODY_SIZE);
}

// Begins a step for a body.
// @ts-ignore: decorator
@inline export function startJointed(t: JointTable, rigid: RigidTable, row: i32): void {
  const body = jointed(t, row);
  body.inverseInertia = <f64>poseOf(rigid, row).inverseInertia;
  body.stiffness = 0;
  body.joints = 0;
  body.halfStep = 0.5 * rigid.h;
}

// @ts-ignore: decorator
@inline export function keepVelocity(t: JointTable, rigid: RigidTable, row: i32): void {
  const body = jointed(t, row);
  const state = stateOf(rigid, row);
  body.vx = <f64>state.vx;
  body.vy = <f64>state.vy;
  body.w = <f64>state.w;
}

// Adds h k of a body by an impulse of the last sub-step, which is a force times h, at an arm from its centre.
// @ts-ignore: decorator
@inline export function stiffen(t: JointTable, row: i32, x: f64, y: f64, armX: f64, armY: f64): void {
  const body = jointed(t, row);
  body.stiffness += x * armX + y * armY;
  body.joints += 1;
}

// A body that may not turn has this many times its mass as inertia, kg m²: enough digits are left.
const LOCKED_INERTIA: f64 = 1e8;

// The masses of all bodies of trees, and their inertias for this step; `least` is h² |k|. A body whose centre is held keeps its
// own: joints that cannot close would pull ever harder at an inertia that grows with their pull. Returns whether a body that
// several joints hold got more.
export function braceBodies(t: JointTable, rigid: RigidTable): bool {
  let any = false;
  for (let i = 0; i < t.bodyCount; i++) {
    const row = word(t.bodyRows, i);
    if (row == 0) continue;
    const body = articulated(t, i);
    const seen = jointed(t, row);
    body.mass = 1 / <f64>poseOf(rigid, row).inverseMass;
    body.inertia = seen.inverseInertia > 0 ? 1 / seen.inverseInertia : LOCKED_INERTIA * body.mass;
    const least = rigid.h * abs<f64>(seen.stiffness);
    if (seen.inverseInertia == 0 || openAxes(rigid, row) == 0 || !(least > body.inertia)) continue;
    body.inertia = least;
    seen.inverseInertia = 1 / least;
    poseOf(rigid, row).inverseInertia = <real>seen.inverseInertia;
    if (seen.joints < 2) continue;
    seen.halfStep = 0;
    any = true;
  }
  return any;
}

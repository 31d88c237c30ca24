// The two locked directions of a hinge in a tree, x and y of its point, without rows: most joints are hinges; these are the
// inner loops of chains, bridges and ragdolls.
//
// About its hinge, whose point moves by u, a body that turns by ω has with all that hangs below it the momentum
//
//   (A  b) (u)   (g)                          K = A - b bᵀ/d        ω = (τ - b · u)/d
//   (bᵀ d) (ω) - (τ)       so that            F = K u - g + b τ/d
//
// F is the impulse at the hinge: the body weighs K on its parent, of which u is the motion at this point. So a joint takes
// one division. With the arm r of a body from its centre, the centre moves by u + ω s, s = (r_y, -r_x).
// Source: Featherstone, Rigid Body Dynamics Algorithms (2008), section 7.3, with velocities in place of accelerations.
import { BodyState, stateOf } from '../../solver/2d/body';
import { inverseMassX, inverseMassY } from '../../solver/2d/motion-locks';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { ArticulatedBody, ArticulatedMass, massBeside } from './articulated-body';
import { jointed } from './brace-joints';
import { bend, partOfChord } from './chords';
import { JointTable } from './joint-table';
import { HingeStart, JointPlace } from './joint-work';
import { finite } from './joint-rows';

// A joint to what joints do not move is softer than rigid by this part, so that what is held from two sides has a solution. A
// straight bridge of a hundred planks needs it: with less, blows of its load make it swing ever more.
export const COMPLIANCE: f64 = 1e-4;

// The anchors where the bodies are now; `softness` is that of joints.
// @ts-ignore: decorator
@inline export function measureHinge(rigid: RigidTable, at: JointPlace, start: HingeStart): void {
  const p = stateOf(rigid, at.parentRow);
  const c = stateOf(rigid, at.childRow);
  const px = <f64>p.dc * start.parentX - <f64>p.ds * start.parentY;
  const py = <f64>p.ds * start.parentX + <f64>p.dc * start.parentY;
  const cx = <f64>c.dc * start.childX - <f64>c.ds * start.childY;
  const cy = <f64>c.ds * start.childX + <f64>c.dc * start.childY;
  at.parentX = px;
  at.parentY = py;
  at.childX = cx;
  at.childY = cy;
  measureChord(at, c, start);
  const rate = softness.biasRate;
  start.wantedX = at.chordX + rate * (start.x + (<f64>c.dx - <f64>p.dx) + cx - px);
  start.wantedY = at.chordY + rate * (start.y + (<f64>c.dy - <f64>p.dy) + cy - py);
}

// @ts-ignore: decorator
@inline function measureChord(at: JointPlace, child: BodyState, start: HingeStart): void {
  const above = changetype<ArticulatedBody>(at.above);
  let vx = <f64>child.vx;
  let vy = <f64>child.vy;
  let w = <f64>child.w;
  if (at.below != 0) {
    const below = changetype<ArticulatedBody>(at.below);
    vx = below.vx;
    vy = below.vy;
    w = below.w;
  }
  const bendParent = bend(above.w, start.halfStepParent);
  const bendChild = bend(w, start.halfStepChild);
  const x = bendParent * at.parentX - bendChild * at.childX;
  const y = bendParent * at.parentY - bendChild * at.childY;
  const ux = vx - w * at.childY - (above.vx - above.w * at.parentY);
  const uy = vy + w * at.childX - (above.vy + above.w * at.parentX);
  const part = partOfChord(x, y, ux, uy);
  at.chordX = part * x;
  at.chordY = part * y;
}

// From the ends of the tree: what the parent bears. With `factor`, also the matrices.
// @ts-ignore: decorator
@inline export function gatherHinge(
  t: JointTable,
  rigid: RigidTable,
  at: JointPlace,
  start: HingeStart,
  soft: bool,
  factor: bool,
): void {
  if (at.below != 0) gatherChild(t, rigid, at, factor);
  else gatherEnd(rigid, at, factor);
  const to = changetype<ArticulatedBody>(at.above);
  const x = -at.parentY;
  const y = at.parentX;
  const ux = soft ? start.wantedX : at.chordX;
  const uy = soft ? start.wantedY : at.chordY;
  if (factor) {
    const wx = at.k00 * x + at.k01 * y;
    const wy = at.k01 * x + at.k11 * y;
    const mass = massBeside(t, at.above);
    mass.m00 += at.k00;
    mass.m01 += at.k01;
    mass.m11 += at.k11;
    mass.m02 += wx;
    mass.m12 += wy;
    mass.m22 += x * wx + y * wy;
  }
  const gx = at.valueX + (at.k00 * ux + at.k01 * uy);
  const gy = at.valueY + (at.k01 * ux + at.k11 * uy);
  to.gx += gx;
  to.gy += gy;
  to.gw += x * gx + y * gy;
}

// @ts-ignore: decorator
@inline function gatherChild(t: JointTable, rigid: RigidTable, at: JointPlace, factor: bool): void {
  const from = changetype<ArticulatedBody>(at.below);
  const state = stateOf(rigid, at.childRow);
  const sx = at.childY;
  const sy = -at.childX;
  if (factor) factorChild(from, massBeside(t, at.below), at, sx, sy);
  const gx = from.gx + from.mass * <f64>state.vx;
  const gy = from.gy + from.mass * <f64>state.vy;
  const torque = from.gw + from.inertia * <f64>state.w + sx * gx + sy * gy;
  from.gx = 0;
  from.gy = 0;
  from.gw = 0;
  at.turn = torque * at.inverse;
  at.valueX = gx - torque * at.ratioX;
  at.valueY = gy - torque * at.ratioY;
}

// @ts-ignore: decorator
@inline function factorChild(body: ArticulatedBody, mass: ArticulatedMass, at: JointPlace, sx: f64, sy: f64): void {
  const a00 = mass.m00 + body.mass;
  const a01 = mass.m01;
  const a11 = mass.m11 + body.mass;
  const m02 = mass.m02;
  const m12 = mass.m12;
  const bx = m02 + a00 * sx + a01 * sy;
  const by = m12 + a01 * sx + a11 * sy;
  const d = mass.m22 + body.inertia + sx * (m02 + bx) + sy * (m12 + by);
  mass.m00 = 0;
  mass.m01 = 0;
  mass.m02 = 0;
  mass.m11 = 0;
  mass.m12 = 0;
  mass.m22 = 0;
  const inverse = 1 / d;
  const ratioX = bx * inverse;
  const ratioY = by * inverse;
  at.inverse = inverse;
  at.ratioX = ratioX;
  at.ratioY = ratioY;
  at.k00 = a00 - bx * ratioX;
  at.k01 = a01 - bx * ratioY;
  at.k11 = a11 - by * ratioY;
}

// @ts-ignore: decorator
@inline function gatherEnd(rigid: RigidTable, at: JointPlace, factor: bool): void {
  const state = stateOf(rigid, at.childRow);
  if (factor) {
    const body = changetype<ArticulatedBody>(at.above);
    const mass = COMPLIANCE / body.mass;
    const inertia = COMPLIANCE / body.inertia;
    const xx = mass + inertia * at.parentY * at.parentY;
    const xy = -inertia * at.parentX * at.parentY;
    const yy = mass + inertia * at.parentX * at.parentX;
    const k = 1 / (xx * yy - xy * xy);
    at.k00 = yy * k;
    at.k01 = -xy * k;
    at.k11 = xx * k;
  }
  const ux = <f64>state.vx - <f64>state.w * at.childY;
  const uy = <f64>state.vy + <f64>state.w * at.childX;
  at.valueX = at.k00 * ux + at.k01 * uy;
  at.valueY = at.k01 * ux + at.k11 * uy;
}

// From the root: the impulse of the hinge, and the velocity of the child.
// @ts-ignore: decorator
@inline export function exertHinge(rigid: RigidTable, at: JointPlace, start: HingeStart, soft: bool): void {
  const from = changetype<ArticulatedBody>(at.above);
  const ux = from.vx - from.w * at.parentY - (soft ? start.wantedX : at.chordX);
  const uy = from.vy + from.w * at.parentX - (soft ? start.wantedY : at.chordY);
  const x = finite(at.k00 * ux + at.k01 * uy - at.valueX);
  const y = finite(at.k01 * ux + at.k11 * uy - at.valueY);
  at.impulseX = soft ? softness.massScale * x : at.impulseX + x;
  at.impulseY = soft ? softness.massScale * y : at.impulseY + y;
  if (at.below == 0) return;
  const body = changetype<ArticulatedBody>(at.below);
  const w = at.turn - at.ratioX * ux - at.ratioY * uy;
  body.w = w;
  body.vx = ux + w * at.childY;
  body.vy = uy - w * at.childX;
  follow(stateOf(rigid, at.childRow), body, at.turns != 0);
}

// Brings a body to the velocity that its tree gives it, or, softly, most of the way.
// @ts-ignore: decorator
@inline export function follow(state: BodyState, body: ArticulatedBody, turns: bool): void {
  const scale = softness.massScale;
  state.vx = <real>(<f64>state.vx + scale * finite(body.vx - <f64>state.vx));
  state.vy = <real>(<f64>state.vy + scale * finite(body.vy - <f64>state.vy));
  if (turns) state.w = <real>(<f64>state.w + scale * finite(body.w - <f64>state.w));
}

// Ends a sub-step.
// @ts-ignore: decorator
@inline export function watchHinge(at: JointPlace): void {
  const x = at.impulseX;
  const y = at.impulseY;
  at.largest = max<f64>(at.largest, x * x + y * y);
}

// Applies an impulse to the child, and its opposite to the parent.
export function applyAtHinge(t: JointTable, rigid: RigidTable, at: JointPlace, x: f64, y: f64): void {
  push(t, rigid, at.childRow, x, y, at.childX, at.childY);
  push(t, rigid, at.parentRow, -x, -y, at.parentX, at.parentY);
}

// @ts-ignore: decorator
@inline function push(t: JointTable, rigid: RigidTable, row: i32, x: f64, y: f64, armX: f64, armY: f64): void {
  const state = stateOf(rigid, row);
  state.vx = <real>(<f64>state.vx + <f64>inverseMassX(rigid, row) * x);
  state.vy = <real>(<f64>state.vy + <f64>inverseMassY(rigid, row) * y);
  state.w = <real>(<f64>state.w + jointed(t, row).inverseInertia * (armX * y - armY * x));
}

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
import { dot2, minus, plus, times, turnedBy, turnedLeft, turnedRight, xOf, yOf } from '../../math/vector-2d';
import { BodyState, stateOf } from '../../solver/2d/body';
import { inverseMassX, inverseMassY } from '../../solver/2d/motion-locks';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { ArticulatedBody, ArticulatedMass, massBeside } from './articulated-body';
import { jointed } from './brace-joints';
import { bend, partOfLength } from './chords';
import { JointTable } from './joint-table';
import {
  childArm,
  chordOf,
  impulseOf,
  momentumBelow,
  movementOf,
  parentArm,
  ratioOf,
  setChildArm,
  setChord,
  setImpulse,
  setMomentumBelow,
  setParentArm,
  setValue,
  setVelocity,
  setVelocityIn,
  setWanted,
  startBetween,
  startOfChild,
  startOfParent,
  turnOf,
  valueOf,
  velocityIn,
  velocityOf,
  wantedOf,
  weigh,
} from './hinge-vectors';
import { HingeStart, JointPlace } from './joint-work';
import { boundedVector, finite, finiteVector } from './joint-rows';
import { COMPLIANCE } from './soft-impulse';
import { TORN, isTorn } from './torn-trees';

// The velocity that the anchor of the child is to have from that of the parent.
// @ts-ignore: decorator
@inline function wanted(at: JointPlace, start: HingeStart, soft: bool): v128 {
  return soft ? wantedOf(start) : chordOf(at);
}

// The anchors where the bodies are now; `softness` is that of joints.
// @ts-ignore: decorator
@inline export function measureHinge(t: JointTable, rigid: RigidTable, at: JointPlace, start: HingeStart): void {
  const p = stateOf(rigid, at.parentRow);
  const c = stateOf(rigid, at.childRow);
  const parent = turnedBy(turnOf(p), startOfParent(start));
  const child = turnedBy(turnOf(c), startOfChild(start));
  setParentArm(at, parent);
  setChildArm(at, child);
  const chord = measureChord(at, c, start, parent, child);
  setChord(at, chord);
  const between = plus(startBetween(start), minus(movementOf(c), movementOf(p)));
  const gap = minus(plus(between, child), parent);
  const pull = dot2(gap, gap) > TORN && isTorn(t, at) ? f64x2.splat(0) : boundedVector(gap);
  setWanted(start, plus(chord, times(softness.biasRate, pull)));
}

// @ts-ignore: decorator
@inline function measureChord(
  at: JointPlace,
  state: BodyState,
  start: HingeStart,
  parent: v128,
  child: v128,
): v128 {
  const above = changetype<ArticulatedBody>(at.above);
  let velocity = velocityOf(state);
  let w = <f64>state.w;
  if (at.below != 0) {
    const below = changetype<ArticulatedBody>(at.below);
    velocity = velocityIn(below);
    w = below.w;
  }
  const bendParent = bend(above.w, start.halfStepParent);
  const bendChild = bend(w, start.halfStepChild);
  const chord = minus(times(bendParent, parent), times(bendChild, child));
  const speed = minus(plus(velocity, times(w, turnedLeft(child))), velocityAt(above, parent));
  return times(partOfLength(dot2(chord, chord), dot2(chord, speed)), chord);
}

// The velocity of a point of a body.
// @ts-ignore: decorator
@inline function velocityAt(body: ArticulatedBody, arm: v128): v128 {
  return plus(velocityIn(body), times(body.w, turnedLeft(arm)));
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
  const lever = turnedLeft(parentArm(at));
  if (factor) {
    const weight = weigh(at, lever);
    const mass = massBeside(t, at.above);
    mass.m00 += at.k00;
    mass.m01 += at.k01;
    mass.m11 += at.k11;
    mass.m02 += xOf(weight);
    mass.m12 += yOf(weight);
    mass.m22 += dot2(lever, weight);
  }
  const momentum = plus(valueOf(at), weigh(at, wanted(at, start, soft)));
  setMomentumBelow(to, plus(momentumBelow(to), momentum));
  to.gw += dot2(lever, momentum);
}

// @ts-ignore: decorator
@inline function gatherChild(t: JointTable, rigid: RigidTable, at: JointPlace, factor: bool): void {
  const from = changetype<ArticulatedBody>(at.below);
  const state = stateOf(rigid, at.childRow);
  const lever = turnedRight(childArm(at));
  if (factor) factorChild(from, massBeside(t, at.below), at, xOf(lever), yOf(lever));
  const momentum = plus(momentumBelow(from), times(from.mass, velocityOf(state)));
  const parts = f64x2.mul(lever, momentum);
  const torque = from.gw + from.inertia * <f64>state.w + xOf(parts) + yOf(parts);
  setMomentumBelow(from, f64x2.splat(0));
  from.gw = 0;
  at.turn = torque * at.inverse;
  setValue(at, minus(momentum, times(torque, ratioOf(at))));
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
  setValue(at, weigh(at, plus(velocityOf(state), times(<f64>state.w, turnedLeft(childArm(at))))));
}

// From the root: the impulse of the hinge, and the velocity of the child.
// @ts-ignore: decorator
@inline export function exertHinge(rigid: RigidTable, at: JointPlace, start: HingeStart, soft: bool): void {
  const from = changetype<ArticulatedBody>(at.above);
  const u = minus(velocityAt(from, parentArm(at)), wanted(at, start, soft));
  const change = finiteVector(minus(weigh(at, u), valueOf(at)));
  setImpulse(at, soft ? times(softness.massScale, change) : plus(impulseOf(at), change));
  moveChild(rigid, at, u);
}

// The velocity of the child alone, of which the hinge moves by u.
// @ts-ignore: decorator
@inline function moveChild(rigid: RigidTable, at: JointPlace, u: v128): void {
  if (at.below == 0) return;
  const body = changetype<ArticulatedBody>(at.below);
  turnChild(body, at, u);
  follow(stateOf(rigid, at.childRow), body, at.turns != 0);
}

// @ts-ignore: decorator
@inline function turnChild(body: ArticulatedBody, at: JointPlace, u: v128): void {
  const w = at.turn - at.ratioX * xOf(u) - at.ratioY * yOf(u);
  body.w = w;
  setVelocityIn(body, plus(u, times(w, turnedRight(childArm(at)))));
}

// The same as `gatherHinge` and `passHinge` for a tree at rest, on whose bodies impulses act.
// @ts-ignore: decorator
@inline export function gatherHingeResponse(at: JointPlace): void {
  if (at.below == 0) return;
  const from = changetype<ArticulatedBody>(at.below);
  const momentum = momentumBelow(from);
  const torque = from.gw + dot2(turnedRight(childArm(at)), momentum);
  at.turn = torque * at.inverse;
  setMomentumBelow(from, f64x2.splat(0));
  from.gw = 0;
  const to = changetype<ArticulatedBody>(at.above);
  const passed = minus(momentum, times(torque, ratioOf(at)));
  setMomentumBelow(to, plus(momentumBelow(to), passed));
  to.gw += dot2(turnedLeft(parentArm(at)), passed);
}

// @ts-ignore: decorator
@inline export function passHingeResponse(at: JointPlace): void {
  if (at.below == 0) return;
  turnChild(
    changetype<ArticulatedBody>(at.below),
    at,
    velocityAt(changetype<ArticulatedBody>(at.above), parentArm(at)),
  );
}

// As `exertHinge`, without noting the impulse of the hinge.
// @ts-ignore: decorator
@inline export function passHinge(rigid: RigidTable, at: JointPlace, start: HingeStart, soft: bool): void {
  const from = changetype<ArticulatedBody>(at.above);
  moveChild(rigid, at, minus(velocityAt(from, parentArm(at)), wanted(at, start, soft)));
}

// Brings a body to the velocity that its tree gives it, or, softly, most of the way.
// @ts-ignore: decorator
@inline export function follow(state: BodyState, body: ArticulatedBody, turns: bool): void {
  const scale = softness.massScale;
  const velocity = velocityOf(state);
  setVelocity(state, plus(velocity, times(scale, finiteVector(minus(velocityIn(body), velocity)))));
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

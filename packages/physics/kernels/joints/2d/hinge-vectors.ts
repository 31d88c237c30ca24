// The fields x and y of the records of hinges, and of the bodies that they join, as vectors.
import { loadReals, storeReals, transformed } from '../../math/vector-2d';
import { BodyState } from '../../solver/2d/body';
import { ArticulatedBody } from './articulated-body';
import { HingeStart, JointPlace } from './joint-work';

// @ts-ignore: decorator
@inline export function parentArm(at: JointPlace): v128 {
  return v128.load(changetype<usize>(at), offsetof<JointPlace>('parentX'));
}

// @ts-ignore: decorator
@inline export function setParentArm(at: JointPlace, arm: v128): void {
  v128.store(changetype<usize>(at), arm, offsetof<JointPlace>('parentX'));
}

// @ts-ignore: decorator
@inline export function childArm(at: JointPlace): v128 {
  return v128.load(changetype<usize>(at), offsetof<JointPlace>('childX'));
}

// @ts-ignore: decorator
@inline export function setChildArm(at: JointPlace, arm: v128): void {
  v128.store(changetype<usize>(at), arm, offsetof<JointPlace>('childX'));
}

// @ts-ignore: decorator
@inline export function chordOf(at: JointPlace): v128 {
  return v128.load(changetype<usize>(at), offsetof<JointPlace>('chordX'));
}

// @ts-ignore: decorator
@inline export function setChord(at: JointPlace, chord: v128): void {
  v128.store(changetype<usize>(at), chord, offsetof<JointPlace>('chordX'));
}

// @ts-ignore: decorator
@inline export function valueOf(at: JointPlace): v128 {
  return v128.load(changetype<usize>(at), offsetof<JointPlace>('valueX'));
}

// @ts-ignore: decorator
@inline export function setValue(at: JointPlace, value: v128): void {
  v128.store(changetype<usize>(at), value, offsetof<JointPlace>('valueX'));
}

// @ts-ignore: decorator
@inline export function impulseOf(at: JointPlace): v128 {
  return v128.load(changetype<usize>(at), offsetof<JointPlace>('impulseX'));
}

// @ts-ignore: decorator
@inline export function setImpulse(at: JointPlace, impulse: v128): void {
  v128.store(changetype<usize>(at), impulse, offsetof<JointPlace>('impulseX'));
}

// @ts-ignore: decorator
@inline export function ratioOf(at: JointPlace): v128 {
  return v128.load(changetype<usize>(at), offsetof<JointPlace>('ratioX'));
}

// The matrix K of a hinge times a vector.
// @ts-ignore: decorator
@inline export function weigh(at: JointPlace, u: v128): v128 {
  const first = v128.load(changetype<usize>(at), offsetof<JointPlace>('k00'));
  return transformed(first, v128.load(changetype<usize>(at), offsetof<JointPlace>('k01')), u);
}

// @ts-ignore: decorator
@inline export function startOfParent(start: HingeStart): v128 {
  return v128.load(changetype<usize>(start), offsetof<HingeStart>('parentX'));
}

// @ts-ignore: decorator
@inline export function startOfChild(start: HingeStart): v128 {
  return v128.load(changetype<usize>(start), offsetof<HingeStart>('childX'));
}

// @ts-ignore: decorator
@inline export function startBetween(start: HingeStart): v128 {
  return v128.load(changetype<usize>(start), offsetof<HingeStart>('x'));
}

// @ts-ignore: decorator
@inline export function wantedOf(start: HingeStart): v128 {
  return v128.load(changetype<usize>(start), offsetof<HingeStart>('wantedX'));
}

// @ts-ignore: decorator
@inline export function setWanted(start: HingeStart, speed: v128): void {
  v128.store(changetype<usize>(start), speed, offsetof<HingeStart>('wantedX'));
}

// @ts-ignore: decorator
@inline export function momentumBelow(body: ArticulatedBody): v128 {
  return v128.load(changetype<usize>(body), offsetof<ArticulatedBody>('gx'));
}

// @ts-ignore: decorator
@inline export function setMomentumBelow(body: ArticulatedBody, momentum: v128): void {
  v128.store(changetype<usize>(body), momentum, offsetof<ArticulatedBody>('gx'));
}

// @ts-ignore: decorator
@inline export function velocityIn(body: ArticulatedBody): v128 {
  return v128.load(changetype<usize>(body), offsetof<ArticulatedBody>('vx'));
}

// @ts-ignore: decorator
@inline export function setVelocityIn(body: ArticulatedBody, velocity: v128): void {
  v128.store(changetype<usize>(body), velocity, offsetof<ArticulatedBody>('vx'));
}

// @ts-ignore: decorator
@inline export function velocityOf(state: BodyState): v128 {
  return loadReals(changetype<usize>(state) + offsetof<BodyState>('vx'));
}

// @ts-ignore: decorator
@inline export function setVelocity(state: BodyState, velocity: v128): void {
  storeReals(changetype<usize>(state) + offsetof<BodyState>('vx'), velocity);
}

// How far a body has moved since the step began.
// @ts-ignore: decorator
@inline export function movementOf(state: BodyState): v128 {
  return loadReals(changetype<usize>(state) + offsetof<BodyState>('dx'));
}

// Cosine and sine of the angle by which it has turned.
// @ts-ignore: decorator
@inline export function turnOf(state: BodyState): v128 {
  return loadReals(changetype<usize>(state) + offsetof<BodyState>('dc'));
}

// A body as the solver sees it. Both records are indexed by row. Row 0 belongs to no entity: it stands for every body that
// does not move.
import { RigidTable } from './rigid-table';

// What changes from sub-step to sub-step: in f32 it is 32 bytes, two vectors, which four contacts gather at once.
@unmanaged
export class BodyState {
  vx: real;
  vy: real;
  // Angular velocity, rad/s.
  w: real;
  // Angle turned since the step began, rad.
  turned: real;
  // Distance moved since the step began, m, and cosine and sine of the angle sineCosine.
  dx: real;
  dy: real;
  dc: real;
  ds: real;
}

// What holds for a whole step: the pose at its start, cosine and sine of the angle, the inverses of mass and moment of
// inertia (0 for what does not move), and the extents of the shape.
@unmanaged
export class BodyPose {
  x: real;
  y: real;
  c: real;
  s: real;
  inverseMass: real;
  inverseInertia: real;
  extent: real;
  minExtent: real;
}

// Bits of a row's flags. A body is one of the first three, or none when it takes no part.
export const DYNAMIC: u32 = 1;
export const KINEMATIC: u32 = 2;
export const STATIC: u32 = 4;
export const ASLEEP: u32 = 8;
// Its fat box changed in this step.
export const ENLARGED: u32 = 16;
// It has a shape that collides, and so a box.
export const COLLIDES: u32 = 32;
// In the last step it moved so far that it may have passed through something thin.
export const FAST: u32 = 64;

// It sleeps and must wake in the next step.
export const WAKES: u32 = 128;
// It does not move, but was moved between two steps.
export const SHIFTED: u32 = 256;

// It is a disc, which looks the same however it turns.
export const ROUND: u32 = 512;

// It is a part of a compound body (parts.ts): the kind and the state of motion are those of its body.
export const PART: u32 = 1024;
// It is a body that has parts.
export const COMPOUND: u32 = 2048;
// It does not fall asleep.
export const SLEEPLESS: u32 = 4096;
// Some of its motion is locked (motion-locks.ts).
export const LOCKED: u32 = 8192;
// Its collider is a sensor, is solid on one side only, is in a group (collider-flags.ts).
export const SENSOR: u32 = 16384;
export const ONE_WAY: u32 = 32768;
export const GROUPED: u32 = 65536;
// It is a wall, and no body (walls.ts).
export const WALL: u32 = 131072;
// It asks for another rule by which friction or restitution combine.
export const COMBINES: u32 = 262144;
// A joint drives it in this step: with a motor or a spring, or as a pulley or a gear.
export const DRIVEN: u32 = 524288;
// Its island is put to sleep at the end of this step.
export const TO_SLEEP: u32 = 1048576;
// A joint holds it in this step.
export const JOINED: u32 = 2097152;
// It is at an end of a joint that closes a loop.
export const LOOPED: u32 = 4194304;

// It is kinematic and stands where it stood in the last step.
export const STANDS: u32 = 8388608;

// It has become solid on one side only since the last step.
export const NEWLY_ONE_WAY: u32 = 16777216;

// It is static, but has a velocity, which is 0 in this step.
export const MAY_MOVE: u32 = 33554432;

// It is moved by forces now, or no longer, or it touches such a body; it has less mass than in the last step (forget-impulses.ts).
export const CHANGED_KIND: u32 = 67108864;
export const LIGHTER: u32 = 134217728;

// In this step the row holds another body than in the last one, or one that collides otherwise.
export const CHANGED: u32 = 268435456;

export const MOVES: u32 = DYNAMIC | KINEMATIC;

// @ts-ignore: decorator
@inline export function stateOf(t: RigidTable, row: i32): BodyState {
  return changetype<BodyState>(t.states + <usize>row * (8 * sizeof<real>()));
}

// @ts-ignore: decorator
@inline export function poseOf(t: RigidTable, row: i32): BodyPose {
  return changetype<BodyPose>(t.poses + <usize>row * (8 * sizeof<real>()));
}

// @ts-ignore: decorator
@inline export function word(list: usize, i: i32): i32 {
  return load<i32>(list + ((<usize>i) << 2));
}

// @ts-ignore: decorator
@inline export function putWord(list: usize, i: i32, value: i32): void {
  store<i32>(list + ((<usize>i) << 2), value);
}

// @ts-ignore: decorator
@inline export function flagsOf(t: RigidTable, row: i32): u32 {
  return load<u32>(t.flags + ((<usize>row) << 2));
}

// Whether a body with these flags may have moved since the last step.
// @ts-ignore: decorator
@inline export function isActive(flags: u32): bool {
  return ((flags & MOVES) != 0 && (flags & (ASLEEP | STANDS)) == 0) || (flags & SHIFTED) != 0;
}

// Whether contacts and joints move a body with these flags.
// @ts-ignore: decorator
@inline export function isPushed(flags: u32): bool {
  return (flags & (DYNAMIC | ASLEEP)) == DYNAMIC;
}

// @ts-ignore: decorator
@inline export function putFlags(t: RigidTable, row: i32, flags: u32): void {
  store<u32>(t.flags + ((<usize>row) << 2), flags);
}

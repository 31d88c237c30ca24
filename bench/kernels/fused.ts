// The reference that the composed systems of the scene `particles` are measured against: one loop that does all their
// work on a body while it is in registers, as fast as it could be made by hand. It saves the pose, adds gravity and
// quadratic drag, divides by the mass, moves by semi-implicit Euler, bounces in the box and sees that all is in range.
//
//   v' = v (1 - k |v| dt/m) + g dt        x' = x + v' dt
//
// To see what is in range costs next to nothing. The square of the speed, which drag needs, says whether velocities were
// when the step began. A body within the box is in range, and beyond the limit of speeds only if it came from so far
// outside that the next step will tell. What is outside, or no number, is listed and looked at. Two vectors in turns
// need one branch between them.
// Nothing is shared with the kernels of the engine on purpose: a change there must not change what it is compared with.
import {
  DRAG,
  HITS_X,
  HITS_Y,
  HITS_Z,
  MASS,
  PREVIOUS_X,
  PREVIOUS_Y,
  PREVIOUS_Z,
  RADIUS,
  TILE,
  VX,
  VY,
  VZ,
  X,
  Y,
  Z,
  add,
  areBelow,
  isAll,
  largest,
  magnitude,
  mul,
  splat,
  sub,
} from './layout';
import { noteHit, rebound } from './rebound';
import { dt, gravity, high, low, maxSpeed } from './setting';

export { columnAt, reserve } from './layout';
export { configure } from './setting';

// @ts-ignore: decorator
@inline function solidOf(o: usize): v128 {
  return v128.gt<real>(v128.load(o, MASS), splat(0));
}

// The part of the velocity that drag takes: k |v| dt/m.
// @ts-ignore: decorator
@inline function braked(o: usize, square: v128, solid: v128, h: v128): v128 {
  const perMass = v128.and(v128.div<real>(h, v128.load(o, MASS)), solid);
  return mul(mul(v128.load(o, DRAG), v128.sqrt<real>(square)), perMass);
}

// Saves and moves one axis, and returns how far from the middle of the box the bodies then are.
// @ts-ignore: decorator
@inline function move(o: usize, x: usize, v: usize, previous: usize, after: v128, h: v128, middle: v128): v128 {
  const position = v128.load(o + x);
  const there = add(position, mul(after, h));
  v128.store(o + previous, position);
  v128.store(o + x, there);
  v128.store(o + v, after);
  return magnitude(sub(there, middle));
}

// The lanes in which both distances are at most `room`, which no NaN is. In f32 the larger one says it.
// @ts-ignore: decorator
@inline function bothWithin(a: v128, b: v128, room: v128): v128 {
  if (sizeof<real>() == 4) return v128.le<real>(v128.max<u32>(a, b), room);
  return v128.and(v128.le<real>(a, room), v128.le<real>(b, room));
}

// @ts-ignore: decorator
@inline function allWithin(a: v128, b: v128, c: v128, room: v128): v128 {
  if (sizeof<real>() == 4) return v128.le<real>(v128.max<u32>(v128.max<u32>(a, b), c), room);
  return v128.and(bothWithin(a, b, room), v128.le<real>(c, room));
}

// Moves a vector in the plane; returns the lanes that are inside the box.
// @ts-ignore: decorator
@inline function advance2d(
  o: usize,
  vx: v128,
  vy: v128,
  square: v128,
  h: v128,
  fall: v128,
  middle: v128,
  half: v128,
): v128 {
  const solid = solidOf(o);
  const part = braked(o, square, solid, h);
  const room = sub(half, v128.load(o, RADIUS));
  const dx = move(o, X, VX, PREVIOUS_X, sub(vx, mul(part, vx)), h, middle);
  const dy = move(o, Y, VY, PREVIOUS_Y, add(sub(vy, mul(part, vy)), v128.and(fall, solid)), h, middle);
  return bothWithin(dx, dy, room);
}

// The same in space.
// @ts-ignore: decorator
@inline function advance3d(
  o: usize,
  vx: v128,
  vy: v128,
  vz: v128,
  square: v128,
  h: v128,
  fall: v128,
  middle: v128,
  half: v128,
): v128 {
  const solid = solidOf(o);
  const part = braked(o, square, solid, h);
  const room = sub(half, v128.load(o, RADIUS));
  const dx = move(o, X, VX, PREVIOUS_X, sub(vx, mul(part, vx)), h, middle);
  const dy = move(o, Y, VY, PREVIOUS_Y, add(sub(vy, mul(part, vy)), v128.and(fall, solid)), h, middle);
  const dz = move(o, Z, VZ, PREVIOUS_Z, sub(vz, mul(part, vz)), h, middle);
  return allWithin(dx, dy, dz, room);
}

// One step of rows [first, last), a multiple of 16, in the plane; 1 when every value was and is in range.
export function fused2d(first: i32, last: i32): i32 {
  const h = splat(dt);
  const fall = splat(-gravity * dt);
  const middle = splat(<real>0.5 * (low + high));
  const half = splat(<real>0.5 * (high - low));
  let squares = i32x4.splat(0);
  let good = 1;
  const end = <usize>last * sizeof<real>();
  for (let o = <usize>first * sizeof<real>(); o < end; ) {
    const stop = min<usize>(end, o + 16 * TILE);
    let hitsX = HITS_X;
    let hitsY = HITS_Y;
    for (; o < stop; o += 32) {
      const vx = v128.load(o, VX);
      const vy = v128.load(o, VY);
      const ux = v128.load(o, VX + 16);
      const uy = v128.load(o, VY + 16);
      const square = add(mul(vx, vx), mul(vy, vy));
      const other = add(mul(ux, ux), mul(uy, uy));
      squares = largest(largest(squares, square), other);
      const inside = advance2d(o, vx, vy, square, h, fall, middle, half);
      if (isAll(v128.and(inside, advance2d(o + 16, ux, uy, other, h, fall, middle, half)))) continue;
      const room = sub(half, v128.load(o, RADIUS));
      const space = sub(half, v128.load(o, RADIUS + 16));
      hitsX = noteHit(hitsX, o, X, vx, room, middle);
      hitsX = noteHit(hitsX, o + 16, X, ux, space, middle);
      hitsY = noteHit(hitsY, o, Y, vy, room, middle);
      hitsY = noteHit(hitsY, o + 16, Y, uy, space, middle);
    }
    good &= rebound(HITS_X, hitsX, X, VX) & rebound(HITS_Y, hitsY, Y, VY);
  }
  return good & i32(areBelow(squares, splat(maxSpeed * maxSpeed)));
}

// The same in space.
export function fused3d(first: i32, last: i32): i32 {
  const h = splat(dt);
  const fall = splat(-gravity * dt);
  const middle = splat(<real>0.5 * (low + high));
  const half = splat(<real>0.5 * (high - low));
  let squares = i32x4.splat(0);
  let good = 1;
  const end = <usize>last * sizeof<real>();
  for (let o = <usize>first * sizeof<real>(); o < end; ) {
    const stop = min<usize>(end, o + 16 * TILE);
    let hitsX = HITS_X;
    let hitsY = HITS_Y;
    let hitsZ = HITS_Z;
    for (; o < stop; o += 32) {
      const vx = v128.load(o, VX);
      const vy = v128.load(o, VY);
      const vz = v128.load(o, VZ);
      const ux = v128.load(o, VX + 16);
      const uy = v128.load(o, VY + 16);
      const uz = v128.load(o, VZ + 16);
      const square = add(add(mul(vx, vx), mul(vy, vy)), mul(vz, vz));
      const other = add(add(mul(ux, ux), mul(uy, uy)), mul(uz, uz));
      squares = largest(largest(squares, square), other);
      const inside = advance3d(o, vx, vy, vz, square, h, fall, middle, half);
      if (isAll(v128.and(inside, advance3d(o + 16, ux, uy, uz, other, h, fall, middle, half)))) continue;
      const room = sub(half, v128.load(o, RADIUS));
      const space = sub(half, v128.load(o, RADIUS + 16));
      hitsX = noteHit(hitsX, o, X, vx, room, middle);
      hitsX = noteHit(hitsX, o + 16, X, ux, space, middle);
      hitsY = noteHit(hitsY, o, Y, vy, room, middle);
      hitsY = noteHit(hitsY, o + 16, Y, uy, space, middle);
      hitsZ = noteHit(hitsZ, o, Z, vz, room, middle);
      hitsZ = noteHit(hitsZ, o + 16, Z, uz, space, middle);
    }
    good &= rebound(HITS_X, hitsX, X, VX) & rebound(HITS_Y, hitsY, Y, VY) & rebound(HITS_Z, hitsZ, Z, VZ);
  }
  return good & i32(areBelow(squares, splat(maxSpeed * maxSpeed)));
}

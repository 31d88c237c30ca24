// Faces of networks: edges or triangles between bodies, as src/networks/faces.ts puts them into the memory: the ids of all
// first corners, of all second ones and so on, then as many lives.
//
// Triangles are read LANES at a time. Those of a cloth follow each other, corner by corner: then a corner of all is one
// vector of each column. Others are picked body by body.
import { Columns, columns, get, put } from '../columns';
import { LANES, add, at, laneOf, sub } from '../lanes';
import { word } from './table';

// Of LANES triangles: the ways from the first corner to the two others, and the sum of the corners' velocities.
@unmanaged
class Triangles {
  bx: v128;
  by: v128;
  bz: v128;
  dx: v128;
  dy: v128;
  dz: v128;
  vx: v128;
  vy: v128;
  vz: v128;
}

export const triangles = changetype<Triangles>(memory.data(144, 16));

// Corner `k` of a face, or, from the number of corners on, the life it had.
// @ts-ignore: decorator
@inline export function corner(faces: usize, count: i32, face: i32, k: i32): u32 {
  return word(faces, k * count + face);
}

// Whether corner k of LANES faces is a run of bodies that all live.
// @ts-ignore: decorator
@inline function isRun(faces: usize, count: i32, face: i32, k: i32, generations: usize): bool {
  const ids = faces + ((<usize>(k * count + face)) << 2);
  const lives = ids + ((<usize>count * 3) << 2);
  const first = load<u32>(ids);
  if (sizeof<real>() == 8) {
    return load<u32>(ids, 4) == first + 1 && load<u64>(lives) == load<u64>(generations + ((<usize>first) << 2));
  }
  const expected = i32x4.add(i32x4.splat(first), i32x4(0, 1, 2, 3));
  if (!i32x4.all_true(i32x4.eq(v128.load(ids), expected))) return false;
  return i32x4.all_true(i32x4.eq(v128.load(lives), v128.load(generations + ((<usize>first) << 2))));
}

// Reads LANES triangles from `face` on into `triangles`; those that lost a corner, and what is behind the last one, have
// no extent. Returns whether each corner of them is a run.
export function readTriangles(faces: usize, count: i32, face: i32, generations: usize): bool {
  if (
    face + LANES > count ||
    !isRun(faces, count, face, 0, generations) ||
    !isRun(faces, count, face, 1, generations) ||
    !isRun(faces, count, face, 2, generations)
  ) {
    for (let lane = 0; lane < LANES; lane++) readOne(faces, count, face + lane, generations, lane);
    return false;
  }
  const c = columns();
  const t = triangles;
  const a = at(corner(faces, count, face, 0));
  const b = at(corner(faces, count, face, 1));
  const d = at(corner(faces, count, face, 2));
  const x = v128.load(c.positionX + a);
  const y = v128.load(c.positionY + a);
  const z = v128.load(c.positionZ + a);
  t.bx = sub(v128.load(c.positionX + b), x);
  t.by = sub(v128.load(c.positionY + b), y);
  t.bz = sub(v128.load(c.positionZ + b), z);
  t.dx = sub(v128.load(c.positionX + d), x);
  t.dy = sub(v128.load(c.positionY + d), y);
  t.dz = sub(v128.load(c.positionZ + d), z);
  t.vx = sum(c.velocityX, a, b, d);
  t.vy = sum(c.velocityY, a, b, d);
  t.vz = sum(c.velocityZ, a, b, d);
  return true;
}

// @ts-ignore: decorator
@inline function sum(column: usize, a: usize, b: usize, d: usize): v128 {
  return add(add(v128.load(column + a), v128.load(column + b)), v128.load(column + d));
}

function readOne(faces: usize, count: i32, face: i32, generations: usize, lane: i32): void {
  const c = columns();
  const to = changetype<usize>(triangles) + at(lane);
  const isThere = face < count && isWhole(faces, count, face, 3, generations);
  const a = isThere ? corner(faces, count, face, 0) : 0;
  const b = isThere ? corner(faces, count, face, 1) : 0;
  const d = isThere ? corner(faces, count, face, 2) : 0;
  for (let axis = 0; axis < 3; axis++) {
    const position = load<usize>(changetype<usize>(c) + ((<usize>axis) << 2), offsetof<Columns>('positionX'));
    const velocity = load<usize>(changetype<usize>(c) + ((<usize>axis) << 2), offsetof<Columns>('velocityX'));
    store<real>(to + ((<usize>axis) << 4), get(position, b) - get(position, a));
    store<real>(to + ((<usize>(axis + 3)) << 4), get(position, d) - get(position, a));
    store<real>(to + ((<usize>(axis + 6)) << 4), get(velocity, a) + get(velocity, b) + get(velocity, d));
  }
}

// Whether all corners of a face still live.
export function isWhole(faces: usize, count: i32, face: i32, corners: i32, generations: usize): bool {
  for (let k = 0; k < corners; k++) {
    const life = word(generations, corner(faces, count, face, k));
    if (life != corner(faces, count, face, k + corners)) return false;
  }
  return true;
}

// Adds a force to each corner of LANES triangles from `face` on.
// @ts-ignore: decorator
@inline export function pushTriangles(
  faces: usize,
  count: i32,
  face: i32,
  isRuns: bool,
  forces: usize,
  by: v128,
): void {
  if (!isRuns) {
    pushEach(faces, count, face, forces, by);
    return;
  }
  for (let k = 0; k < 3; k++) {
    const p = forces + at(corner(faces, count, face, k));
    v128.store(p, add(v128.load(p), by));
  }
}

function pushEach(faces: usize, count: i32, face: i32, forces: usize, by: v128): void {
  for (let lane = 0; lane < LANES && face + lane < count; lane++) {
    for (let k = 0; k < 3; k++) {
      const body = corner(faces, count, face + lane, k);
      put(forces, body, get(forces, body) + laneOf(by, lane));
    }
  }
}

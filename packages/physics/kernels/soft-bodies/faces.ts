// Faces of networks: edges or triangles between bodies, as src/soft-bodies/faces.ts puts them into the memory: the ids of all
// first corners, of all second ones and so on, then as many lives.
//
// Triangles are read LANES at a time. Those of a cloth follow each other, corner by corner: then a corner of all is one
// vector of each column. Others are picked body by body.
import { columns, get, put } from '../memory/columns';
import { LANES, add, at, sub } from '../memory/lanes';
import { word } from '../xpbd/table';

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

// Bits where corner k of LANES faces is no run of bodies that all live.
// @ts-ignore: decorator
@inline function strays(faces: usize, count: i32, face: i32, k: i32, generations: usize): v128 {
  const ids = faces + ((<usize>(k * count + face)) << 2);
  const lives = ids + ((<usize>count * 3) << 2);
  const first = load<u32>(ids);
  const now = generations + ((<usize>first) << 2);
  if (sizeof<real>() == 8) {
    const expected = i32x4.add(i32x4.splat(first), i32x4(0, 1, 0, 0));
    return v128.or(
      v128.xor(v128.load64_zero(ids), v128.and(expected, i32x4(-1, -1, 0, 0))),
      v128.xor(v128.load64_zero(lives), v128.load64_zero(now)),
    );
  }
  const expected = i32x4.add(i32x4.splat(first), i32x4(0, 1, 2, 3));
  return v128.or(v128.xor(v128.load(ids), expected), v128.xor(v128.load(lives), v128.load(now)));
}

// Reads LANES triangles from `face` on into `triangles`; those that lost a corner, and those from `end` on, have no
// extent. Returns whether each corner of them is a run.
export function readTriangles(faces: usize, count: i32, face: i32, end: i32, generations: usize): bool {
  if (
    face + LANES > end ||
    v128.any_true(
      v128.or(
        strays(faces, count, face, 0, generations),
        v128.or(strays(faces, count, face, 1, generations), strays(faces, count, face, 2, generations)),
      ),
    )
  ) {
    for (let lane = 0; lane < LANES; lane++) readOne(faces, count, face + lane, end, generations, lane);
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

function readOne(faces: usize, count: i32, face: i32, end: i32, generations: usize, lane: i32): void {
  const c = columns();
  const to = changetype<usize>(triangles) + at(lane);
  const isThere = face < end && isWhole(faces, count, face, 3, generations);
  const a = isThere ? corner(faces, count, face, 0) : 0;
  const b = isThere ? corner(faces, count, face, 1) : 0;
  const d = isThere ? corner(faces, count, face, 2) : 0;
  readAxis(to, c.positionX, c.velocityX, a, b, d);
  readAxis(to + 16, c.positionY, c.velocityY, a, b, d);
  readAxis(to + 32, c.positionZ, c.velocityZ, a, b, d);
}

// @ts-ignore: decorator
@inline function readAxis(to: usize, position: usize, velocity: usize, a: u32, b: u32, d: u32): void {
  const from = get(position, a);
  store<real>(to, get(position, b) - from);
  store<real>(to, get(position, d) - from, 48);
  store<real>(to, get(velocity, a) + get(velocity, b) + get(velocity, d), 96);
}

// Whether all corners of a face still live.
export function isWhole(faces: usize, count: i32, face: i32, corners: i32, generations: usize): bool {
  for (let k = 0; k < corners; k++) {
    const life = word(generations, corner(faces, count, face, k));
    if (life != corner(faces, count, face, k + corners)) return false;
  }
  return true;
}

// Faces whose forces are found before any is added: what was just written cannot be read at once in other fours.
export const CHUNK: i32 = 32 * LANES;

// Where the forces of a chunk stand, behind the lives: x, then y, then z.
// @ts-ignore: decorator
@inline export function chunkOf(faces: usize, count: i32): usize {
  return faces + ((<usize>count * 24 + 15) & ~15);
}

// Adds the forces of a chunk to each corner of its faces; a bit of `runs` is set where LANES faces have runs of corners.
export function pushChunk(
  faces: usize,
  count: i32,
  first: i32,
  last: i32,
  runs: u32,
  fx: usize,
  fy: usize,
  fz: usize,
): void {
  for (let k = 0; k < 3; k++) {
    let by = chunkOf(faces, count);
    let bits = runs;
    for (let face = first; face < last; face += LANES) {
      if ((bits & 1) != 0) {
        const body = at(corner(faces, count, face, k));
        push(fx + body, by);
        push(fy + body, by + at(CHUNK));
        push(fz + body, by + at(2 * CHUNK));
      } else pushEach(faces, count, face, last, k, by, fx, fy, fz);
      by += 16;
      bits >>= 1;
    }
  }
}

// @ts-ignore: decorator
@inline function push(force: usize, by: usize): void {
  v128.store(force, add(v128.load(force), v128.load(by)));
}

function pushEach(
  faces: usize,
  count: i32,
  face: i32,
  last: i32,
  k: i32,
  by: usize,
  fx: usize,
  fy: usize,
  fz: usize,
): void {
  const lanes = min<i32>(LANES, last - face);
  for (let lane = 0; lane < lanes; lane++) {
    const body = corner(faces, count, face + lane, k);
    put(fx, body, get(fx, body) + get(by, lane));
    put(fy, body, get(fy, body) + get(by, lane + CHUNK));
    put(fz, body, get(fz, body) + get(by, lane + 2 * CHUNK));
  }
}

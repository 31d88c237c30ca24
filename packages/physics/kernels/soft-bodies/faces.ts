// Faces of soft bodies: edges or triangles between bodies, as src/soft-bodies/faces.ts lays them out: the ids of all
// first corners, of all second corners and so on, then the generations of the corners in the same order.
//
// LANES triangles are read at a time. The corners of a cloth's triangles have consecutive ids, so that one corner of
// LANES triangles is one vector of each column. Other triangles are gathered body by body.
import { columns, get, put } from '../memory/columns';
import { LANES, add, at, sub } from '../memory/lanes';
import { word } from '../xpbd/table';

// LANES triangles: the vectors from the first corner to the two others, and the sum of the corners' velocities.
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

// Id of corner `k` of a face, or, if `k` is at least the number of corners, the generation of corner `k` minus that
// number.
// @ts-ignore: decorator
@inline export function corner(faces: usize, count: i32, face: i32, k: i32): u32 {
  return word(faces, k * count + face);
}

// Sets bits where corner k of LANES faces is not a run of consecutive, living bodies.
// @ts-ignore: decorator
@inline function findStrays(faces: usize, count: i32, face: i32, k: i32, generations: usize): v128 {
  const ids = faces + ((<usize>(k * count + face)) << 2);
  const expectedGenerations = ids + ((<usize>count * 3) << 2);
  const first = load<u32>(ids);
  const now = generations + ((<usize>first) << 2);
  if (sizeof<real>() == 8) {
    const expected = i32x4.add(i32x4.splat(first), i32x4(0, 1, 0, 0));
    return v128.or(
      v128.xor(v128.load64_zero(ids), v128.and(expected, i32x4(-1, -1, 0, 0))),
      v128.xor(v128.load64_zero(expectedGenerations), v128.load64_zero(now)),
    );
  }
  const expected = i32x4.add(i32x4.splat(first), i32x4(0, 1, 2, 3));
  return v128.or(v128.xor(v128.load(ids), expected), v128.xor(v128.load(expectedGenerations), v128.load(now)));
}

// Reads LANES triangles from `face` on into `triangles`. Triangles with a removed corner, and those from `end` on,
// read as degenerate. Returns whether each corner is a run of consecutive bodies.
export function readTriangles(faces: usize, count: i32, face: i32, end: i32, generations: usize): bool {
  if (
    face + LANES > end ||
    v128.any_true(
      v128.or(
        findStrays(faces, count, face, 0, generations),
        v128.or(findStrays(faces, count, face, 1, generations), findStrays(faces, count, face, 2, generations)),
      ),
    )
  ) {
    for (let lane = 0; lane < LANES; lane++) readTriangle(faces, count, face + lane, end, generations, lane);
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

function readTriangle(faces: usize, count: i32, face: i32, end: i32, generations: usize, lane: i32): void {
  const c = columns();
  const to = changetype<usize>(triangles) + at(lane);
  const exists = face < end && isFaceAlive(faces, count, face, 3, generations);
  const a = exists ? corner(faces, count, face, 0) : 0;
  const b = exists ? corner(faces, count, face, 1) : 0;
  const d = exists ? corner(faces, count, face, 2) : 0;
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

// Tests whether all corners of a face still live.
export function isFaceAlive(faces: usize, count: i32, face: i32, corners: i32, generations: usize): bool {
  for (let k = 0; k < corners; k++) {
    const generation = word(generations, corner(faces, count, face, k));
    if (generation != corner(faces, count, face, k + corners)) return false;
  }
  return true;
}

// Faces per chunk: their forces are computed before any is added, since a vector load that overlaps a recent store
// stalls.
export const CHUNK: i32 = 32 * LANES;

// Address of the forces of a chunk, behind the generations: x, then y, then z.
// @ts-ignore: decorator
@inline export function chunkAddress(faces: usize, count: i32): usize {
  return faces + ((<usize>count * 24 + 15) & ~15);
}

// Adds the forces of a chunk to each corner of its faces; a set bit of `runs` marks LANES faces whose corners are
// runs.
export function addChunkForces(
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
    let by = chunkAddress(faces, count);
    let bits = runs;
    for (let face = first; face < last; face += LANES) {
      if ((bits & 1) != 0) {
        const body = at(corner(faces, count, face, k));
        addForce(fx + body, by);
        addForce(fy + body, by + at(CHUNK));
        addForce(fz + body, by + at(2 * CHUNK));
      } else addForcesEach(faces, count, face, last, k, by, fx, fy, fz);
      by += 16;
      bits >>= 1;
    }
  }
}

// @ts-ignore: decorator
@inline function addForce(force: usize, by: usize): void {
  v128.store(force, add(v128.load(force), v128.load(by)));
}

function addForcesEach(
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

// Wind on a sheet of triangles.
import { LANES, add, at, div, dot, mul, splat, sub } from '../lanes';
import { CHUNK, chunkOf, pushChunk, readTriangles, triangles } from './faces';

// One that lost a corner feels nothing.
//
//   F = rho A |u| (c_n (u.n) n + c_t (u - (u.n) n)) / 2, a third on each corner, u: wind minus mean velocity
export function blowTriangles(
  faces: usize,
  count: i32,
  generations: usize,
  fx: usize,
  fy: usize,
  fz: usize,
  windX: f64,
  windY: f64,
  windZ: f64,
  density: f64,
  normal: f64,
  tangential: f64,
): void {
  const to = chunkOf(faces, count);
  for (let first = 0; first < count; first += CHUNK) {
    const last = min<i32>(first + CHUNK, count);
    let runs: u32 = 0;
    let place = to;
    for (let face = first, bit: u32 = 1; face < last; face += LANES, bit <<= 1) {
      if (readTriangles(faces, count, face, generations)) runs |= bit;
      blow(place, <real>windX, <real>windY, <real>windZ, <real>(density / 12), <real>normal, <real>tangential);
      place += 16;
    }
    pushChunk(faces, count, first, runs, fx, fy, fz);
  }
}

// The force on each corner of the triangles that were read.
// @ts-ignore: decorator
@inline function blow(
  place: usize,
  windX: real,
  windY: real,
  windZ: real,
  strength: real,
  normal: real,
  tangential: real,
): void {
  const t = triangles;
  const third = splat(<real>(1.0 / 3));
  // The normal, as long as twice the area.
  const nx = sub(mul(t.by, t.dz), mul(t.bz, t.dy));
  const ny = sub(mul(t.bz, t.dx), mul(t.bx, t.dz));
  const nz = sub(mul(t.bx, t.dy), mul(t.by, t.dx));
  const square = dot(nx, ny, nz, nx, ny, nz);
  const ux = sub(splat(windX), mul(t.vx, third));
  const uy = sub(splat(windY), mul(t.vy, third));
  const uz = sub(splat(windZ), mul(t.vz, third));
  const scale = mul(splat(strength), v128.sqrt<real>(mul(square, dot(ux, uy, uz, ux, uy, uz))));
  const push = v128.and(scale, v128.gt<real>(square, splat(0)));
  const across = mul(splat(normal - tangential), dot(ux, uy, uz, nx, ny, nz));
  const part = mul(push, div(across, v128.max<real>(square, splat(LEAST))));
  const along = mul(push, splat(tangential));
  v128.store(place, add(mul(part, nx), mul(along, ux)));
  v128.store(place + at(CHUNK), add(mul(part, ny), mul(along, uy)));
  v128.store(place + at(2 * CHUNK), add(mul(part, nz), mul(along, uz)));
}

// A square of twice an area that is as good as none, m^4: what it divides is smaller still.
const LEAST: real = 1e-36;

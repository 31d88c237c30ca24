// Gas in a closed ring of edges (2D, per metre of depth) or a closed surface of triangles (3D).
import { columns, get, put } from '../memory/columns';
import { LANES, at, mul, splat, sub } from '../memory/lanes';
import { CHUNK, addChunkForces, chunkAddress, corner, isFaceAlive, readTriangles, triangles } from './faces';

// Area of a ring or volume of a surface, relative to its first corner so that distant bodies lose no digits; 0 if a
// corner was removed.
export function enclosed(faces: usize, count: i32, corners: i32, generations: usize): f64 {
  for (let i = 0; i < count; i++) if (!isFaceAlive(faces, count, i, corners, generations)) return 0;
  const c = columns();
  const first = corner(faces, count, 0, 0);
  const ox = <f64>get(c.positionX, first);
  const oy = <f64>get(c.positionY, first);
  const oz = <f64>get(c.positionZ, first);
  let sum: f64 = 0;
  for (let i = 0; i < count; i++) {
    const a = corner(faces, count, i, 0);
    const b = corner(faces, count, i, 1);
    const ax = <f64>get(c.positionX, a) - ox;
    const ay = <f64>get(c.positionY, a) - oy;
    const bx = <f64>get(c.positionX, b) - ox;
    const by = <f64>get(c.positionY, b) - oy;
    if (corners == 2) {
      sum += (ax * by - ay * bx) / 2;
      continue;
    }
    const az = <f64>get(c.positionZ, a) - oz;
    const bz = <f64>get(c.positionZ, b) - oz;
    const d = corner(faces, count, i, 2);
    const dx = <f64>get(c.positionX, d) - ox;
    const dy = <f64>get(c.positionY, d) - oy;
    const dz = <f64>get(c.positionZ, d) - oz;
    sum += (ax * (by * dz - bz * dy) + ay * (bz * dx - bx * dz) + az * (bx * dy - by * dx)) / 6;
  }
  return sum;
}

// Adds pressure times the gradient of the enclosed area.
export function inflateEdges(edges: usize, count: i32, fx: usize, fy: usize, pressure: f64): void {
  const c = columns();
  for (let i = 0; i < count; i++) {
    const a = corner(edges, count, i, 0);
    const b = corner(edges, count, i, 1);
    const x = (pressure * (<f64>get(c.positionY, b) - <f64>get(c.positionY, a))) / 2;
    const y = (pressure * (<f64>get(c.positionX, a) - <f64>get(c.positionX, b))) / 2;
    addForce(fx, a, x);
    addForce(fx, b, x);
    addForce(fy, a, y);
    addForce(fy, b, y);
  }
}

// Adds pressure times area, a third to each corner: in a closed surface this is the gradient of the volume.
export function inflateTriangles(
  faces: usize,
  count: i32,
  generations: usize,
  fx: usize,
  fy: usize,
  fz: usize,
  pressure: f64,
): void {
  const t = triangles;
  const sixth = splat(<real>(pressure / 6));
  const to = chunkAddress(faces, count);
  for (let first = 0; first < count; first += CHUNK) {
    const last = min<i32>(first + CHUNK, count);
    let runs: u32 = 0;
    let address = to;
    for (let face = first, bit: u32 = 1; face < last; face += LANES, bit <<= 1) {
      if (readTriangles(faces, count, face, count, generations)) runs |= bit;
      v128.store(address, mul(sixth, sub(mul(t.by, t.dz), mul(t.bz, t.dy))));
      v128.store(address + at(CHUNK), mul(sixth, sub(mul(t.bz, t.dx), mul(t.bx, t.dz))));
      v128.store(address + at(2 * CHUNK), mul(sixth, sub(mul(t.bx, t.dy), mul(t.by, t.dx))));
      address += 16;
    }
    addChunkForces(faces, count, first, last, runs, fx, fy, fz);
  }
}

// @ts-ignore: decorator
@inline function addForce(force: usize, body: u32, by: f64): void {
  put(force, body, <real>(<f64>get(force, body) + by));
}

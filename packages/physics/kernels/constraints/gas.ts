// Gas in a closed ring of edges (2D, per metre of depth) or a closed surface of triangles (3D).
import { columns, get, put } from '../columns';
import { word } from './table';

// Whether all corners live: `corners` bodies and as many lives.
function isWhole(faces: usize, count: i32, corners: i32, generations: usize): bool {
  for (let i = 0; i < count; i++) {
    const p = faces + <usize>(i * corners) * 8;
    for (let k = 0; k < corners; k++) {
      const body = load<u32>(p + ((<usize>k) << 2));
      if (word(generations, body) != load<u32>(p + ((<usize>(k + corners)) << 2))) return false;
    }
  }
  return true;
}

// Area of a ring or volume of a surface, seen from its first corner so that far-off bodies lose no digits; 0 when a
// corner is gone.
export function enclosed(faces: usize, count: i32, corners: i32, generations: usize): f64 {
  if (!isWhole(faces, count, corners, generations)) return 0;
  const c = columns();
  const first = load<u32>(faces);
  const ox = <f64>get(c.positionX, first);
  const oy = <f64>get(c.positionY, first);
  const oz = <f64>get(c.positionZ, first);
  let sum: f64 = 0;
  for (let i = 0; i < count; i++) {
    const p = faces + <usize>(i * corners) * 8;
    const a = load<u32>(p);
    const b = load<u32>(p, 4);
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
    const d = load<u32>(p, 8);
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
    const p = edges + ((<usize>i) << 4);
    const a = load<u32>(p);
    const b = load<u32>(p, 4);
    const x = (pressure * (<f64>get(c.positionY, b) - <f64>get(c.positionY, a))) / 2;
    const y = (pressure * (<f64>get(c.positionX, a) - <f64>get(c.positionX, b))) / 2;
    add(fx, a, x);
    add(fx, b, x);
    add(fy, a, y);
    add(fy, b, y);
  }
}

// Adds pressure times area, a third on each corner: in a closed surface that is the gradient of the volume.
export function inflateTriangles(triangles: usize, count: i32, fx: usize, fy: usize, fz: usize, pressure: f64): void {
  const c = columns();
  for (let i = 0; i < count; i++) {
    const p = triangles + <usize>i * 24;
    const a = load<u32>(p);
    const b = load<u32>(p, 4);
    const d = load<u32>(p, 8);
    const x = <f64>get(c.positionX, a);
    const y = <f64>get(c.positionY, a);
    const z = <f64>get(c.positionZ, a);
    const bx = <f64>get(c.positionX, b) - x;
    const by = <f64>get(c.positionY, b) - y;
    const bz = <f64>get(c.positionZ, b) - z;
    const dx = <f64>get(c.positionX, d) - x;
    const dy = <f64>get(c.positionY, d) - y;
    const dz = <f64>get(c.positionZ, d) - z;
    const sixth = pressure / 6;
    add3(fx, a, b, d, sixth * (by * dz - bz * dy));
    add3(fy, a, b, d, sixth * (bz * dx - bx * dz));
    add3(fz, a, b, d, sixth * (bx * dy - by * dx));
  }
}

// @ts-ignore: decorator
@inline function add(force: usize, body: u32, by: f64): void {
  put(force, body, <real>(<f64>get(force, body) + by));
}

// @ts-ignore: decorator
@inline function add3(force: usize, a: u32, b: u32, d: u32, by: f64): void {
  add(force, a, by);
  add(force, b, by);
  add(force, d, by);
}

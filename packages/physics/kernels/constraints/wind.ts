// Wind on a sheet of triangles.
import { columns, get, put } from '../columns';
import { word } from './table';

// Triangles are six words: the bodies at the corners, and their lives; one that lost a corner feels nothing.
//
//   F = rho A |u| (c_n (u.n) n + c_t (u - (u.n) n)) / 2, a third on each corner, u: wind minus mean velocity
export function blowTriangles(
  triangles: usize,
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
  const c = columns();
  for (let i = 0; i < count; i++) {
    const p = triangles + <usize>i * 24;
    const a = load<u32>(p);
    const b = load<u32>(p, 4);
    const d = load<u32>(p, 8);
    if (word(generations, a) != load<u32>(p, 12)) continue;
    if (word(generations, b) != load<u32>(p, 16) || word(generations, d) != load<u32>(p, 20)) continue;
    const x = <f64>get(c.positionX, a);
    const y = <f64>get(c.positionY, a);
    const z = <f64>get(c.positionZ, a);
    const bx = <f64>get(c.positionX, b) - x;
    const by = <f64>get(c.positionY, b) - y;
    const bz = <f64>get(c.positionZ, b) - z;
    const dx = <f64>get(c.positionX, d) - x;
    const dy = <f64>get(c.positionY, d) - y;
    const dz = <f64>get(c.positionZ, d) - z;
    // The normal, as long as twice the area.
    const nx = by * dz - bz * dy;
    const ny = bz * dx - bx * dz;
    const nz = bx * dy - by * dx;
    const twice = sqrt<f64>(nx * nx + ny * ny + nz * nz);
    if (!(twice > 0)) continue;
    const ux = windX - mean(c.velocityX, a, b, d);
    const uy = windY - mean(c.velocityY, a, b, d);
    const uz = windZ - mean(c.velocityZ, a, b, d);
    const speed = sqrt<f64>(ux * ux + uy * uy + uz * uz);
    const third = (density * twice * speed) / 12;
    const along = ((normal - tangential) * (ux * nx + uy * ny + uz * nz)) / (twice * twice);
    push(fx, a, b, d, third * (along * nx + tangential * ux));
    push(fy, a, b, d, third * (along * ny + tangential * uy));
    push(fz, a, b, d, third * (along * nz + tangential * uz));
  }
}

// @ts-ignore: decorator
@inline function mean(column: usize, a: u32, b: u32, d: u32): f64 {
  return (<f64>get(column, a) + <f64>get(column, b) + <f64>get(column, d)) / 3;
}

// @ts-ignore: decorator
@inline function push(force: usize, a: u32, b: u32, d: u32, by: f64): void {
  put(force, a, <real>(<f64>get(force, a) + by));
  put(force, b, <real>(<f64>get(force, b) + by));
  put(force, d, <real>(<f64>get(force, d) + by));
}

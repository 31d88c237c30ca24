// Wind on a sheet of triangles.
import { LANES, add, div, mul, splat, sub } from '../lanes';
import { pushTriangles, readTriangles, triangles } from './faces';

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
  const t = triangles;
  const third = splat(<real>(1.0 / 3));
  const across = splat(<real>(normal - tangential));
  const along = splat(<real>tangential);
  for (let face = 0; face < count; face += LANES) {
    const isRuns = readTriangles(faces, count, face, generations);
    // The normal, as long as twice the area.
    const nx = sub(mul(t.by, t.dz), mul(t.bz, t.dy));
    const ny = sub(mul(t.bz, t.dx), mul(t.bx, t.dz));
    const nz = sub(mul(t.bx, t.dy), mul(t.by, t.dx));
    const square = dot(nx, ny, nz, nx, ny, nz);
    const ux = sub(splat(<real>windX), mul(t.vx, third));
    const uy = sub(splat(<real>windY), mul(t.vy, third));
    const uz = sub(splat(<real>windZ), mul(t.vz, third));
    const speed = v128.sqrt<real>(dot(ux, uy, uz, ux, uy, uz));
    const scale = mul(mul(splat(<real>(density / 12)), v128.sqrt<real>(square)), speed);
    const push = v128.and(scale, v128.gt<real>(square, splat(0)));
    const part = div(mul(across, dot(ux, uy, uz, nx, ny, nz)), v128.max<real>(square, splat(LEAST)));
    pushTriangles(faces, count, face, isRuns, fx, mul(push, add(mul(part, nx), mul(along, ux))));
    pushTriangles(faces, count, face, isRuns, fy, mul(push, add(mul(part, ny), mul(along, uy))));
    pushTriangles(faces, count, face, isRuns, fz, mul(push, add(mul(part, nz), mul(along, uz))));
  }
}

// A square of twice an area that is as good as none, m^4: what it divides is smaller still.
const LEAST: real = 1e-36;

// @ts-ignore: decorator
@inline function dot(ax: v128, ay: v128, az: v128, bx: v128, by: v128, bz: v128): v128 {
  return add(add(mul(ax, bx), mul(ay, by)), mul(az, bz));
}

// The acceleration of a group from its interaction lists in 3D for the law 1/r²: bodies of the group in lanes, sources
// broadcast.
//
// With d from the target to the source, u = d² + ε², S' = 3S and T' = tr S'/2:
//   body  a = s d u^(-3/2)
//   cell  a = d (M u^(-3/2) - T' u^(-5/2) + 5/2 (d·S'd) u^(-7/2)) - S'd u^(-5/2)      + dipole D u^(-3/2) - 3 d (D·d) u^(-5/2)
// which is the gradient of the softened potential's expansion to second order (Hernquist, ApJS 64, 715, 1987, with the
// trace kept). Cost per target: 50 operations per cell, 18 per body.
import { LANES, add, at, div, mul, splat, sub } from '../memory/lanes';
import { NBody, REAL } from './workspace';

// The partial sums of the acceleration of the current LANES bodies.
@unmanaged
class Acceleration {
  x: v128;
  y: v128;
  z: v128;
}

const sum = changetype<Acceleration>(memory.data(48, 16));

// @ts-ignore: decorator
@inline function addCells(w: NBody, x: v128, y: v128, z: v128, dipole: bool): void {
  const soft = splat(<real>w.softening2);
  const one = splat(1);
  const three = splat(3);
  const half5 = splat(2.5);
  const cells = w.cells;
  const cellsEnd = cells + ((<usize>w.cellCount) << 2);
  let ax = sum.x;
  let ay = sum.y;
  let az = sum.z;
  for (let cell = cells; cell < cellsEnd; cell += 4) {
    const p = <usize>load<u32>(cell);
    const dx = sub(v128.load_splat<real>(p), x);
    const dy = sub(v128.load_splat<real>(p + REAL), y);
    const dz = sub(v128.load_splat<real>(p + 2 * REAL), z);
    const u = add(add(mul(dx, dx), mul(dy, dy)), add(mul(dz, dz), soft));
    const r1 = div(one, v128.sqrt<real>(u));
    const r2 = mul(r1, r1);
    const r3 = mul(r1, r2);
    const r5 = mul(r3, r2);
    const xy = v128.load_splat<real>(p + 5 * REAL);
    const xz = v128.load_splat<real>(p + 6 * REAL);
    const yz = v128.load_splat<real>(p + 8 * REAL);
    const sx = add(add(mul(v128.load_splat<real>(p + 4 * REAL), dx), mul(xy, dy)), mul(xz, dz));
    const sy = add(add(mul(xy, dx), mul(v128.load_splat<real>(p + 7 * REAL), dy)), mul(yz, dz));
    const sz = add(add(mul(xz, dx), mul(yz, dy)), mul(v128.load_splat<real>(p + 9 * REAL), dz));
    const ds = add(add(mul(dx, sx), mul(dy, sy)), mul(dz, sz));
    let k = sub(mul(mul(half5, ds), r2), v128.load_splat<real>(p + 10 * REAL));
    if (dipole) {
      const gx = v128.load_splat<real>(p + 11 * REAL);
      const gy = v128.load_splat<real>(p + 12 * REAL);
      const gz = v128.load_splat<real>(p + 13 * REAL);
      k = sub(k, mul(three, add(add(mul(gx, dx), mul(gy, dy)), mul(gz, dz))));
      ax = add(ax, mul(gx, r3));
      ay = add(ay, mul(gy, r3));
      az = add(az, mul(gz, r3));
    }
    k = add(mul(v128.load_splat<real>(p + 3 * REAL), r3), mul(k, r5));
    ax = add(ax, sub(mul(dx, k), mul(sx, r5)));
    ay = add(ay, sub(mul(dy, k), mul(sy, r5)));
    az = add(az, sub(mul(dz, k), mul(sz, r5)));
  }
  sum.x = ax;
  sum.y = ay;
  sum.z = az;
}

// @ts-ignore: decorator
@inline function addPoints(w: NBody, x: v128, y: v128, z: v128): void {
  const soft = splat(<real>w.softening2);
  const points = w.points;
  const pointsEnd = points + ((<usize>w.pointCount) << 2);
  let ax = sum.x;
  let ay = sum.y;
  let az = sum.z;
  for (let point = points; point < pointsEnd; point += 4) {
    const p = <usize>load<u32>(point);
    const dx = sub(v128.load_splat<real>(p), x);
    const dy = sub(v128.load_splat<real>(p + REAL), y);
    const dz = sub(v128.load_splat<real>(p + 2 * REAL), z);
    const u = add(add(mul(dx, dx), mul(dy, dy)), add(mul(dz, dz), soft));
    const k = div(v128.load_splat<real>(p + 3 * REAL), mul(u, v128.sqrt<real>(u)));
    ax = add(ax, mul(dx, k));
    ay = add(ay, mul(dy, k));
    az = add(az, mul(dz, k));
  }
  sum.x = ax;
  sum.y = ay;
  sum.z = az;
}

// @ts-ignore: decorator
@inline function addRanges(w: NBody, x: v128, y: v128, z: v128): void {
  const soft = splat(<real>w.softening2);
  const ranges = w.ranges;
  const rangesEnd = ranges + ((<usize>w.rangeCount) << 3);
  let ax = sum.x;
  let ay = sum.y;
  let az = sum.z;
  for (let range = ranges; range < rangesEnd; range += 8) {
    const end = at(load<i32>(range, 4));
    for (let o = at(load<i32>(range)); o < end; o += REAL) {
      const dx = sub(v128.load_splat<real>(w.px + o), x);
      const dy = sub(v128.load_splat<real>(w.py + o), y);
      const dz = sub(v128.load_splat<real>(w.pz + o), z);
      const u = add(add(mul(dx, dx), mul(dy, dy)), add(mul(dz, dz), soft));
      const k = div(v128.load_splat<real>(w.ps + o), mul(u, v128.sqrt<real>(u)));
      ax = add(ax, mul(dx, k));
      ay = add(ay, mul(dy, k));
      az = add(az, mul(dz, k));
    }
  }
  sum.x = ax;
  sum.y = ay;
  sum.z = az;
}

// @ts-ignore: decorator
@inline function evaluate(w: NBody, first: i32, last: i32, dipole: bool): void {
  for (let t = first; t < last; t += LANES) {
    const x = v128.load(w.px + at(t));
    const y = v128.load(w.py + at(t));
    const z = v128.load(w.pz + at(t));
    sum.x = splat(0);
    sum.y = splat(0);
    sum.z = splat(0);
    addCells(w, x, y, z, dipole);
    addPoints(w, x, y, z);
    addRanges(w, x, y, z);
    // The last vector may extend into the next group, which is written afterwards.
    v128.store(w.ax + at(t), sum.x);
    v128.store(w.ay + at(t), sum.y);
    v128.store(w.az + at(t), sum.z);
  }
}

export function evaluate3d(w: NBody, first: i32, last: i32, dipole: bool): void {
  if (dipole) evaluate(w, first, last, true);
  else evaluate(w, first, last, false);
}

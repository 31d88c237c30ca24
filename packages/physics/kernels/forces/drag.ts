import { LANES, add, at, mul, splat, sub } from '../lanes';

// F -= c (v - w) along one axis, with the medium moving at w.
export function linearDragAxis(force: usize, v: usize, coefficient: usize, medium: real, first: i32, last: i32): void {
  const w = splat(medium);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const relative = sub(v128.load(v + o), w);
    v128.store(force + o, sub(v128.load(force + o), mul(v128.load(coefficient + o), relative)));
  }
}

// F -= k |v - w| (v - w) in the plane, with the medium moving at w.
export function quadraticDrag2d(
  fx: usize,
  fy: usize,
  vx: usize,
  vy: usize,
  coefficient: usize,
  wx: real,
  wy: real,
  first: i32,
  last: i32,
): void {
  const mediumX = splat(wx);
  const mediumY = splat(wy);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const x = sub(v128.load(vx + o), mediumX);
    const y = sub(v128.load(vy + o), mediumY);
    const speed = v128.sqrt<real>(add(mul(x, x), mul(y, y)));
    const k = mul(v128.load(coefficient + o), speed);
    v128.store(fx + o, sub(v128.load(fx + o), mul(k, x)));
    v128.store(fy + o, sub(v128.load(fy + o), mul(k, y)));
  }
}

// F -= k |v - w| (v - w) in space, with the medium moving at w.
export function quadraticDrag3d(
  fx: usize,
  fy: usize,
  fz: usize,
  vx: usize,
  vy: usize,
  vz: usize,
  coefficient: usize,
  wx: real,
  wy: real,
  wz: real,
  first: i32,
  last: i32,
): void {
  const mediumX = splat(wx);
  const mediumY = splat(wy);
  const mediumZ = splat(wz);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const x = sub(v128.load(vx + o), mediumX);
    const y = sub(v128.load(vy + o), mediumY);
    const z = sub(v128.load(vz + o), mediumZ);
    const speed = v128.sqrt<real>(add(add(mul(x, x), mul(y, y)), mul(z, z)));
    const k = mul(v128.load(coefficient + o), speed);
    v128.store(fx + o, sub(v128.load(fx + o), mul(k, x)));
    v128.store(fy + o, sub(v128.load(fy + o), mul(k, y)));
    v128.store(fz + o, sub(v128.load(fz + o), mul(k, z)));
  }
}

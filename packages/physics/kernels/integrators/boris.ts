// The magnetic half of Boris's scheme: velocities turn about the field without changing their length.
import { add, at, div, LANES, mul, splat, sub } from '../lanes';

// Turns by Boris's angle 2 atan(q B dt / 2m) in the plane; `field` points out of it.
export function borisTurn2d(
  vx: usize,
  vy: usize,
  charge: usize,
  mass: usize,
  field: usize,
  uniform: real,
  dt: real,
  first: i32,
  last: i32,
): void {
  const half = splat(<real>0.5 * dt);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const t = mul(gyration(charge + o, mass + o, half), component(field, o, uniform));
    const s = div(add(t, t), add(splat(1), mul(t, t)));
    const x = v128.load(vx + o);
    const y = v128.load(vy + o);
    const x1 = add(x, mul(y, t));
    const y1 = sub(y, mul(x, t));
    v128.store(vx + o, add(x, mul(y1, s)));
    v128.store(vy + o, sub(y, mul(x1, s)));
  }
}

export function borisTurn3d(
  vx: usize,
  vy: usize,
  vz: usize,
  charge: usize,
  mass: usize,
  fieldX: usize,
  fieldY: usize,
  fieldZ: usize,
  uniformX: real,
  uniformY: real,
  uniformZ: real,
  dt: real,
  first: i32,
  last: i32,
): void {
  const half = splat(<real>0.5 * dt);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const k = gyration(charge + o, mass + o, half);
    const tx = mul(k, component(fieldX, o, uniformX));
    const ty = mul(k, component(fieldY, o, uniformY));
    const tz = mul(k, component(fieldZ, o, uniformZ));
    const scale = div(splat(2), add(splat(1), add(add(mul(tx, tx), mul(ty, ty)), mul(tz, tz))));
    const x = v128.load(vx + o);
    const y = v128.load(vy + o);
    const z = v128.load(vz + o);
    const x1 = add(x, sub(mul(y, tz), mul(z, ty)));
    const y1 = add(y, sub(mul(z, tx), mul(x, tz)));
    const z1 = add(z, sub(mul(x, ty), mul(y, tx)));
    v128.store(vx + o, add(x, mul(scale, sub(mul(y1, tz), mul(z1, ty)))));
    v128.store(vy + o, add(y, mul(scale, sub(mul(z1, tx), mul(x1, tz)))));
    v128.store(vz + o, add(z, mul(scale, sub(mul(x1, ty), mul(y1, tx)))));
  }
}

// q dt / 2m, zero for a body without mass.
// @ts-ignore: decorator
@inline function gyration(charge: usize, mass: usize, half: v128): v128 {
  const m = v128.load(mass);
  return v128.and(mul(div(v128.load(charge), m), half), v128.gt<real>(m, splat(0)));
}

// The field at a row: a column of values, or the same everywhere where there is no column.
// @ts-ignore: decorator
@inline function component(field: usize, o: usize, uniform: real): v128 {
  return field == 0 ? splat(uniform) : v128.load(field + o);
}

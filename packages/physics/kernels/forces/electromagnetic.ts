// Charges in fields: the Lorentz force of a uniform magnetic field, and the Coulomb force of fixed charges.
import { columns, get } from '../columns';
import { LANES, add, at, div, mul, splat, sub } from '../lanes';

// F += q v x B in the plane, B along z.
export function magneticForce2d(fx: usize, fy: usize, charge: usize, b: real, first: i32, last: i32): void {
  const c = columns();
  const field = splat(b);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const k = mul(v128.load(charge + o), field);
    v128.store(fx + o, add(v128.load(fx + o), mul(k, v128.load(c.velocityY + o))));
    v128.store(fy + o, sub(v128.load(fy + o), mul(k, v128.load(c.velocityX + o))));
  }
}

// F += q v x B in space.
export function magneticForce3d(
  fx: usize,
  fy: usize,
  fz: usize,
  charge: usize,
  bx: real,
  by: real,
  bz: real,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const q = v128.load(charge + o);
    const x = mul(q, v128.load(c.velocityX + o));
    const y = mul(q, v128.load(c.velocityY + o));
    const z = mul(q, v128.load(c.velocityZ + o));
    v128.store(fx + o, add(v128.load(fx + o), sub(mul(y, splat(bz)), mul(z, splat(by)))));
    v128.store(fy + o, add(v128.load(fy + o), sub(mul(z, splat(bx)), mul(x, splat(bz)))));
    v128.store(fz + o, add(v128.load(fz + o), sub(mul(x, splat(by)), mul(y, splat(bx)))));
  }
}

// A source as it was when the step began: position, k Q, and the radius inside which it does not act. f64.
const SOURCE_BYTES: usize = 40;

// Copies the bodies of `ids` that have no mass to `sources` and returns their number, or -1 - n when a charge was not
// finite and stayed out.
export function gatherCharges(ids: usize, count: i32, charge: usize, constant: f64, sources: usize): i32 {
  const c = columns();
  let kept = 0;
  let bad = false;
  for (let i = 0; i < count; i++) {
    const row = load<i32>(ids + ((<usize>i) << 2));
    const q = <f64>get(charge, row);
    // Only who has no mass is a source: one whose mass is not a number stays out.
    if (get(c.mass, row) != 0 || q == 0) continue;
    if (q - q != 0) {
      bad = true;
      continue;
    }
    const source = sources + <usize>kept * SOURCE_BYTES;
    store<f64>(source, get(c.positionX, row));
    store<f64>(source, get(c.positionY, row), 8);
    store<f64>(source, get(c.positionZ, row), 16);
    store<f64>(source, q * constant, 24);
    store<f64>(source, get(c.radius, row), 32);
    kept++;
  }
  return bad ? -1 - kept : kept;
}

// F += q kQ r/r^3 from every source, outside its radius. Sources themselves have no mass, so nothing moves them.
export function coulombForce(
  fx: usize,
  fy: usize,
  fz: usize,
  charge: usize,
  sources: usize,
  count: i32,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let i = 0; i < count; i++) {
    const source = sources + <usize>i * SOURCE_BYTES;
    const cx = splat(<real>load<f64>(source));
    const cy = splat(<real>load<f64>(source, 8));
    const cz = splat(<real>load<f64>(source, 16));
    const strength = splat(<real>load<f64>(source, 24));
    const inner = splat(<real>load<f64>(source, 32));
    for (let row = first; row < last; row += LANES) {
      const o = at(row);
      const x = sub(v128.load(c.positionX + o), cx);
      const y = sub(v128.load(c.positionY + o), cy);
      const z = sub(v128.load(c.positionZ + o), cz);
      const r = v128.sqrt<real>(add(add(mul(x, x), mul(y, y)), mul(z, z)));
      const outside = v128.and(v128.gt<real>(r, inner), v128.gt<real>(r, splat(0)));
      const inverse = v128.and(div(splat(1), r), outside);
      const push = mul(mul(v128.load(charge + o), mul(mul(strength, inverse), inverse)), inverse);
      v128.store(fx + o, add(v128.load(fx + o), mul(x, push)));
      v128.store(fy + o, add(v128.load(fy + o), mul(y, push)));
      v128.store(fz + o, add(v128.load(fz + o), mul(z, push)));
    }
  }
}

// Sum of q kQ / r over bodies with mass in rows [0, rows) and all sources; inside a source its value at the surface.
export function coulombPotential(charge: usize, sources: usize, count: i32, rows: i32): f64 {
  const c = columns();
  let total: f64 = 0;
  for (let row = 0; row < rows; row++) {
    const q = <f64>get(charge, row);
    if (q == 0 || !(get(c.mass, row) > 0)) continue;
    for (let i = 0; i < count; i++) {
      const source = sources + <usize>i * SOURCE_BYTES;
      const x = <f64>get(c.positionX, row) - load<f64>(source);
      const y = <f64>get(c.positionY, row) - load<f64>(source, 8);
      const z = <f64>get(c.positionZ, row) - load<f64>(source, 16);
      const r = max<f64>(sqrt<f64>(x * x + y * y + z * z), load<f64>(source, 32));
      if (r > 0) total += (q * load<f64>(source, 24)) / r;
    }
  }
  return total;
}

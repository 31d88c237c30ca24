// Weighted sums of columns, for multi-stage schemes: the columns lie `stride` bytes apart in one block, and their
// coefficients, reals, are consecutive in memory.
import { LANES, accelerationOf, add, at, mul, splat, sub } from '../memory/lanes';

// to = base + sum of coefficient[k] column[k], for k < count. The base, which is much larger than the terms, is added last: each sum
// with it is rounded to its last digit, always to the same side where a term changes slowly.
export function combineAxis(
  to: usize,
  base: usize,
  columns: usize,
  stride: usize,
  coefficients: usize,
  count: i32,
  first: i32,
  last: i32,
): void {
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    let sum = mul(v128.load(columns + o), v128.load_splat<real>(coefficients));
    let column = columns + stride + o;
    let coefficient = coefficients + sizeof<real>();
    for (let k = 1; k < count; k++) {
      sum = add(sum, mul(v128.load(column), v128.load_splat<real>(coefficient)));
      column += stride;
      coefficient += sizeof<real>();
    }
    v128.store(to + o, add(v128.load(base + o), sum));
  }
}

// to = F/m.
export function accelerationAxis(to: usize, force: usize, mass: usize, first: i32, last: i32): void {
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    v128.store(to + o, accelerationOf(v128.load(force + o), v128.load(mass + o)));
  }
}

// to = a + factor b.
export function addScaledColumn(to: usize, a: usize, b: usize, factor: real, first: i32, last: i32): void {
  const k = splat(factor);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    v128.store(to + o, add(v128.load(a + o), mul(v128.load(b + o), k)));
  }
}

// residual = v - start - dt F/m: zero if v is the velocity of implicit Euler.
export function implicitResidualAxis(
  residual: usize,
  v: usize,
  start: usize,
  force: usize,
  mass: usize,
  dt: real,
  first: i32,
  last: i32,
): void {
  const h = splat(dt);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const a = accelerationOf(v128.load(force + o), v128.load(mass + o));
    v128.store(residual + o, sub(sub(v128.load(v + o), v128.load(start + o)), mul(a, h)));
  }
}

// to = factor a.
export function scaleColumn(to: usize, a: usize, factor: real, first: i32, last: i32): void {
  const k = splat(factor);
  for (let row = first; row < last; row += LANES) {
    v128.store(to + at(row), mul(v128.load(a + at(row)), k));
  }
}

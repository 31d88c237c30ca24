// Sums over bodies in f64 and ascending id, so that diagnostics are as deterministic as the state.
import { Columns, columns } from '../memory/columns';

// @ts-ignore: decorator
@inline function get(column: usize, row: i32): f64 {
  return <f64>load<real>(column + <usize>row * sizeof<real>());
}

// Sum of m v^2 / 2 along one axis, J.
export function kineticAxis(mass: usize, v: usize, first: i32, last: i32): f64 {
  let sum: f64 = 0;
  for (let row = first; row < last; row++) {
    const speed = get(v, row);
    sum += 0.5 * get(mass, row) * speed * speed;
  }
  return sum;
}

// Sum of a(row) b(row): momentum along an axis with a = mass, b = velocity; first moment with b = position.
export function dotColumns(a: usize, b: usize, first: i32, last: i32): f64 {
  let sum: f64 = 0;
  for (let row = first; row < last; row++) sum += get(a, row) * get(b, row);
  return sum;
}

// Sum of m (p vq - q vp), p and q the two axes after `axis` (0, 1, 2): angular momentum about that axis through the
// point (p0, q0), kg m^2/s.
export function angularMomentumAxis(axis: usize, p0: f64, q0: f64, first: i32, last: i32): f64 {
  const c = columns();
  const mass = c.mass;
  const nextAxis: usize = (axis + 1) % 3;
  const lastAxis: usize = (axis + 2) % 3;
  const p = load<usize>(changetype<usize>(c) + (nextAxis << 2), offsetof<Columns>('positionX'));
  const q = load<usize>(changetype<usize>(c) + (lastAxis << 2), offsetof<Columns>('positionX'));
  const vp = load<usize>(changetype<usize>(c) + (nextAxis << 2), offsetof<Columns>('velocityX'));
  const vq = load<usize>(changetype<usize>(c) + (lastAxis << 2), offsetof<Columns>('velocityX'));
  let sum: f64 = 0;
  for (let row = first; row < last; row++) {
    sum += get(mass, row) * ((get(p, row) - p0) * get(vq, row) - (get(q, row) - q0) * get(vp, row));
  }
  return sum;
}

export function sumColumn(column: usize, first: i32, last: i32): f64 {
  let sum: f64 = 0;
  for (let row = first; row < last; row++) sum += get(column, row);
  return sum;
}

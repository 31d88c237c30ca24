// Pull of fixed or uniformly moving centres: F = -m mu r / (r^2 + eps^2)^(3/2), and of black holes among them:
// F = -m mu r / (s (s - rs)^2), s = (r^2 + eps^2)^(1/2), rs = mu times `horizonPerMu`; nothing at rs and inside.
//
// Centres outside, bodies inside: a pass reads and writes the forces of a tile that is in the cache, and the square
// root and the division cost more than that (measured: the other nesting is no faster from 1 to 16 centres).
import { columns, get } from '../columns';
import { LANES, add, at, div, mul, splat, sub } from '../lanes';

// A centre as it was when the step began. All f64, whatever the columns are.
@unmanaged
class Centre {
  x: f64;
  y: f64;
  z: f64;
  vx: f64;
  vy: f64;
  vz: f64;
  mu: f64;
  softening: f64;
  horizon: f64;
  row: i32;
  unused: i32;
}

const CENTRE_BYTES: usize = offsetof<Centre>();

// Copies the attractors with the given ids: the pull of a step must not depend on which tile their rows are moved in.
// One whose values are not finite pulls nothing, lest it take every body along; returns how many there are.
export function gatherAttractors(
  ids: usize,
  count: i32,
  mu: usize,
  softening: usize,
  horizonPerMu: f64,
  centres: usize,
): i32 {
  const c = columns();
  let bad = 0;
  for (let i = 0; i < count; i++) {
    const row = load<i32>(ids + ((<usize>i) << 2));
    const centre = changetype<Centre>(centres + <usize>i * CENTRE_BYTES);
    centre.x = get(c.positionX, row);
    centre.y = get(c.positionY, row);
    centre.z = get(c.positionZ, row);
    centre.vx = get(c.velocityX, row);
    centre.vy = get(c.velocityY, row);
    centre.vz = get(c.velocityZ, row);
    centre.mu = get(mu, row);
    centre.softening = get(softening, row);
    centre.horizon = max<f64>(0, centre.mu * horizonPerMu);
    centre.row = row;
    const sum = centre.x + centre.y + centre.z + centre.vx + centre.vy + centre.vz + centre.mu + centre.softening;
    if (sum - sum == 0) continue;
    memory.fill(changetype<usize>(centre), 0, offsetof<Centre>('row'));
    bad++;
  }
  return bad;
}

// Adds the pull of all centres to rows [first, last), `lead` seconds after they were gathered. Field mu/s^2 and
// direction r/s apart keep every product within f32 from millimetres to light-years.
export function attract2d(fx: usize, fy: usize, centres: usize, count: i32, lead: f64, first: i32, last: i32): void {
  const c = columns();
  for (let i = 0; i < count; i++) {
    const centre = changetype<Centre>(centres + <usize>i * CENTRE_BYTES);
    const cx = splat(<real>(centre.x + centre.vx * lead));
    const cy = splat(<real>(centre.y + centre.vy * lead));
    const mu = splat(<real>centre.mu);
    const soft = splat(<real>(centre.softening * centre.softening));
    const horizon = <real>centre.horizon;
    for (let row = first; row < last; row += LANES) {
      const o = at(row);
      const x = sub(cx, v128.load(c.positionX + o));
      const y = sub(cy, v128.load(c.positionY + o));
      const square = add(add(mul(x, x), mul(y, y)), soft);
      const pull = pullOf(square, mu, horizon, v128.load(c.mass + o), row, centre.row);
      v128.store(fx + o, add(v128.load(fx + o), mul(x, pull)));
      v128.store(fy + o, add(v128.load(fy + o), mul(y, pull)));
    }
  }
}

export function attract3d(
  fx: usize,
  fy: usize,
  fz: usize,
  centres: usize,
  count: i32,
  lead: f64,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let i = 0; i < count; i++) {
    const centre = changetype<Centre>(centres + <usize>i * CENTRE_BYTES);
    const cx = splat(<real>(centre.x + centre.vx * lead));
    const cy = splat(<real>(centre.y + centre.vy * lead));
    const cz = splat(<real>(centre.z + centre.vz * lead));
    const mu = splat(<real>centre.mu);
    const soft = splat(<real>(centre.softening * centre.softening));
    const horizon = <real>centre.horizon;
    for (let row = first; row < last; row += LANES) {
      const o = at(row);
      const x = sub(cx, v128.load(c.positionX + o));
      const y = sub(cy, v128.load(c.positionY + o));
      const z = sub(cz, v128.load(c.positionZ + o));
      const square = add(add(add(mul(x, x), mul(y, y)), mul(z, z)), soft);
      const pull = pullOf(square, mu, horizon, v128.load(c.mass + o), row, centre.row);
      v128.store(fx + o, add(v128.load(fx + o), mul(x, pull)));
      v128.store(fy + o, add(v128.load(fy + o), mul(y, pull)));
      v128.store(fz + o, add(v128.load(fz + o), mul(z, pull)));
    }
  }
}

// m mu / (s (s - rs)^2) for s^2 = `square`; nothing within a horizon, in the centre itself (s = 0), or on its own row.
// @ts-ignore: decorator
@inline function pullOf(square: v128, mu: v128, horizon: real, mass: v128, row: i32, own: i32): v128 {
  const s = v128.sqrt<real>(square);
  const inverse = v128.and(div(splat(1), s), v128.gt<real>(s, splat(0)));
  let steep = inverse;
  if (horizon > 0) {
    const gap = sub(s, splat(horizon));
    steep = v128.and(div(splat(1), gap), v128.gt<real>(gap, splat(0)));
  }
  const pull = mul(mul(mass, mul(mul(mu, steep), steep)), inverse);
  return (own & -LANES) == row ? v128.andnot(pull, lane(own - row)) : pull;
}

// All bits of one lane.
// @ts-ignore: decorator
@inline function lane(index: i32): v128 {
  if (sizeof<real>() == 4) return i32x4.eq(i32x4.splat(index), i32x4(0, 1, 2, 3));
  return i64x2.eq(i64x2.splat(index), i64x2(0, 1));
}

// Sum of -m mu / (s - rs) over rows [first, last), J; none within a horizon.
export function attractorPotential(centres: usize, count: i32, first: i32, last: i32): f64 {
  const c = columns();
  let sum: f64 = 0;
  for (let row = first; row < last; row++) {
    const mass = <f64>get(c.mass, row);
    if (mass == 0) continue;
    for (let i = 0; i < count; i++) {
      const centre = changetype<Centre>(centres + <usize>i * CENTRE_BYTES);
      const x = centre.x - <f64>get(c.positionX, row);
      const y = centre.y - <f64>get(c.positionY, row);
      const z = centre.z - <f64>get(c.positionZ, row);
      const s = sqrt<f64>(x * x + y * y + z * z + centre.softening * centre.softening) - centre.horizon;
      if (s > 0 && row != centre.row) sum -= (mass * centre.mu) / s;
    }
  }
  return sum;
}

// Forces along the line from a fixed centre: F = q f(r) r/r, with a coupling q (mass or charge) a body.
//
// A law says f(r)/r and the energy per unit of coupling for r > 0; `p`, `q` and `s` are its parameters. At r = 0 there
// is no direction, and no force. All in f64, whatever the columns are: a power of a large distance leaves f32 quickly.
// In 2D every z is zero and the same lines serve.
import { columns, get, put } from '../columns';
import { exponential, logarithm } from '../math/elementary';
import { power } from '../math/power';

// Inside and outside a uniform sphere: p = mu, q = radius.
@unmanaged
class UniformSphere {
  pull(r: f64, p: f64, q: f64, s: f64): f64 {
    const d = max<f64>(r, q);
    return -p / (d * d * d);
  }
  energy(r: f64, p: f64, q: f64, s: f64): f64 {
    return r < q ? (-p * (3 * q * q - r * r)) / (2 * q * q * q) : -p / r;
  }
}

// k r^n: p = k, q = n, s = radius inside which there is no force.
@unmanaged
class PowerLaw {
  pull(r: f64, p: f64, q: f64, s: f64): f64 {
    if (r <= s) return 0;
    if (q == 1) return p;
    if (q == -2) return p / (r * r * r);
    return p * power(r, q - 1);
  }
  energy(r: f64, p: f64, q: f64, s: f64): f64 {
    const d = max<f64>(r, s);
    if (q == -1) return -p * logarithm(d);
    return (-p * power(d, q + 1)) / (q + 1);
  }
}

// Paczynski and Wiita: p = mu, q = Schwarzschild radius. At and inside it: swallowed, no force.
@unmanaged
class PaczynskiWiita {
  pull(r: f64, p: f64, q: f64, s: f64): f64 {
    const d = r - q;
    return d > 0 ? -p / (d * d * r) : 0;
  }
  energy(r: f64, p: f64, q: f64, s: f64): f64 {
    return r > q ? -p / (r - q) : 0;
  }
}

// Screened: p = strength, q = screening length.
@unmanaged
class Yukawa {
  pull(r: f64, p: f64, q: f64, s: f64): f64 {
    return (p * exponential(-r / q) * (1 / r + 1 / q)) / (r * r);
  }
  energy(r: f64, p: f64, q: f64, s: f64): f64 {
    return (p * exponential(-r / q)) / r;
  }
}

// 12-6: p = depth, q = distance of zero energy.
@unmanaged
class LennardJones {
  pull(r: f64, p: f64, q: f64, s: f64): f64 {
    const two = (q * q) / (r * r);
    const six = two * two * two;
    return (24 * p * six * (2 * six - 1)) / (r * r);
  }
  energy(r: f64, p: f64, q: f64, s: f64): f64 {
    const two = (q * q) / (r * r);
    const six = two * two * two;
    return 4 * p * six * (six - 1);
  }
}

// Outward k r up to r0, inward k (r0/r)^4 r beyond: p = k, q = r0.
@unmanaged
class Whirl {
  pull(r: f64, p: f64, q: f64, s: f64): f64 {
    if (r <= q) return p;
    const two = (q * q) / (r * r);
    return -p * two * two;
  }
  energy(r: f64, p: f64, q: f64, s: f64): f64 {
    if (r <= q) return -0.5 * p * r * r;
    return (-0.5 * p * q * q * q * q) / (r * r);
  }
}

// Mass within r, from a table of (radius, mass, potential) per knot: p = G, q = address, s = number of knots. Uniform
// density inside the first knot, mass linear in r between knots, all the mass beyond the last.
@unmanaged
class EnclosedMass {
  pull(r: f64, p: f64, q: f64, s: f64): f64 {
    const table = <usize>q;
    const count = <i32>s;
    const first = load<f64>(table);
    if (r <= first) return (-p * load<f64>(table, 8)) / (first * first * first);
    const knot = knotBeyond(table, count, r);
    return (-p * massAt(table, count, knot, r)) / (r * r * r);
  }
  energy(r: f64, p: f64, q: f64, s: f64): f64 {
    const table = <usize>q;
    const count = <i32>s;
    const first = load<f64>(table);
    if (r <= first) {
      const mass = load<f64>(table, 8);
      return p * (load<f64>(table, 16) - (mass * (first * first - r * r)) / (2 * first * first * first));
    }
    const knot = knotBeyond(table, count, r);
    if (knot == count) return (-p * load<f64>(table + <usize>(count - 1) * 24, 8)) / r;
    const outer = table + <usize>knot * 24;
    const r1 = load<f64>(outer - 24);
    const r2 = load<f64>(outer);
    const slope = (load<f64>(outer, 8) - load<f64>(outer - 24, 8)) / (r2 - r1);
    const rest = load<f64>(outer, 8) - slope * r2;
    return p * (load<f64>(outer, 16) + rest * (1 / r2 - 1 / r) - slope * logarithm(r2 / r));
  }
}

// The first knot with a radius of at least r, or `count`.
function knotBeyond(table: usize, count: i32, r: f64): i32 {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (load<f64>(table + <usize>middle * 24) < r) low = middle + 1;
    else high = middle;
  }
  return low;
}

function massAt(table: usize, count: i32, knot: i32, r: f64): f64 {
  if (knot == count) return load<f64>(table + <usize>(count - 1) * 24, 8);
  const outer = table + <usize>knot * 24;
  const r1 = load<f64>(outer - 24);
  const m1 = load<f64>(outer - 24, 8);
  return m1 + ((load<f64>(outer, 8) - m1) * (r - r1)) / (load<f64>(outer) - r1);
}

function sweep<L>(
  coupling: usize,
  fx: usize,
  fy: usize,
  fz: usize,
  cx: f64,
  cy: f64,
  cz: f64,
  p: f64,
  q: f64,
  s: f64,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const couples = <f64>get(coupling, row);
    if (couples == 0) continue;
    const x = <f64>get(c.positionX, row) - cx;
    const y = <f64>get(c.positionY, row) - cy;
    const z = <f64>get(c.positionZ, row) - cz;
    const r = sqrt<f64>(x * x + y * y + z * z);
    if (!(r > 0)) continue;
    const pull = couples * changetype<L>(0).pull(r, p, q, s);
    put(fx, row, get(fx, row) + <real>(pull * x));
    put(fy, row, get(fy, row) + <real>(pull * y));
    put(fz, row, get(fz, row) + <real>(pull * z));
  }
}

function sum<L>(coupling: usize, cx: f64, cy: f64, cz: f64, p: f64, q: f64, s: f64, rows: i32): f64 {
  const c = columns();
  let total: f64 = 0;
  for (let row = 0; row < rows; row++) {
    const couples = <f64>get(coupling, row);
    if (couples == 0) continue;
    const x = <f64>get(c.positionX, row) - cx;
    const y = <f64>get(c.positionY, row) - cy;
    const z = <f64>get(c.positionZ, row) - cz;
    const r = sqrt<f64>(x * x + y * y + z * z);
    if (r > 0) total += couples * changetype<L>(0).energy(r, p, q, s);
  }
  return total;
}

// Adds the force of law number `law` to rows [first, last); src/forces/central.ts has the numbers.
export function centralForce(
  law: i32,
  coupling: usize,
  fx: usize,
  fy: usize,
  fz: usize,
  cx: f64,
  cy: f64,
  cz: f64,
  p: f64,
  q: f64,
  s: f64,
  first: i32,
  last: i32,
): void {
  if (law == 0) sweep<UniformSphere>(coupling, fx, fy, fz, cx, cy, cz, p, q, s, first, last);
  else if (law == 1) sweep<PowerLaw>(coupling, fx, fy, fz, cx, cy, cz, p, q, s, first, last);
  else if (law == 2) sweep<PaczynskiWiita>(coupling, fx, fy, fz, cx, cy, cz, p, q, s, first, last);
  else if (law == 3) sweep<Yukawa>(coupling, fx, fy, fz, cx, cy, cz, p, q, s, first, last);
  else if (law == 4) sweep<LennardJones>(coupling, fx, fy, fz, cx, cy, cz, p, q, s, first, last);
  else if (law == 5) sweep<Whirl>(coupling, fx, fy, fz, cx, cy, cz, p, q, s, first, last);
  else sweep<EnclosedMass>(coupling, fx, fy, fz, cx, cy, cz, p, q, s, first, last);
}

// The energy of rows [0, rows) under law number `law`, J.
export function centralPotential(
  law: i32,
  coupling: usize,
  cx: f64,
  cy: f64,
  cz: f64,
  p: f64,
  q: f64,
  s: f64,
  rows: i32,
): f64 {
  if (law == 0) return sum<UniformSphere>(coupling, cx, cy, cz, p, q, s, rows);
  if (law == 1) return sum<PowerLaw>(coupling, cx, cy, cz, p, q, s, rows);
  if (law == 2) return sum<PaczynskiWiita>(coupling, cx, cy, cz, p, q, s, rows);
  if (law == 3) return sum<Yukawa>(coupling, cx, cy, cz, p, q, s, rows);
  if (law == 4) return sum<LennardJones>(coupling, cx, cy, cz, p, q, s, rows);
  if (law == 5) return sum<Whirl>(coupling, cx, cy, cz, p, q, s, rows);
  return sum<EnclosedMass>(coupling, cx, cy, cz, p, q, s, rows);
}

// Motion along a Kepler orbit of any kind (ellipse, parabola, hyperbola) by universal variables: with Stumpff's
// functions c0 ... c3 and G_n = s^n c_n(beta s^2), the time equation r0 s + eta G2 + zeta G3 = dt is solved for s.
// Stumpff, Himmelsmechanik I (1959); Danby, Fundamentals of Celestial Mechanics (1988), section 6.9; Rein and Tamayo,
// MNRAS 452, 376 (2015), section 2. Only + - * / sqrt: the same bits everywhere.

let c0: f64 = 0;
let c1: f64 = 0;
let c2: f64 = 0;
let c3: f64 = 0;

// c_n(z) = 1/n! - z/(n+2)! + z^2/(n+4)! - ..., with z divided by 4 until the series is short.
function stumpff(argument: f64): void {
  let z = argument;
  let quarters = 0;
  while (abs<f64>(z) > 0.1 && quarters < 600) {
    z *= 0.25;
    quarters++;
  }
  c3 =
    1.0 / 6 - z * (1.0 / 120 - z * (1.0 / 5040 - z * (1.0 / 362880 - z * (1.0 / 39916800 - z * (1.0 / 6227020800)))));
  c2 =
    0.5 -
    z *
      (1.0 / 24 -
        z * (1.0 / 720 - z * (1.0 / 40320 - z * (1.0 / 3628800 - z * (1.0 / 479001600 - z * (1.0 / 87178291200))))));
  c1 = 1 - z * c3;
  c0 = 1 - z * c2;
  for (; quarters > 0; quarters--) {
    c3 = 0.25 * (c2 + c0 * c3);
    c2 = 0.5 * c1 * c1;
    c1 = c0 * c1;
    c0 = 2 * c0 * c0 - 1;
  }
}

// Largest number of iterations: the bracket halves at worst, and doubles hold 53 halvings and some thousand exponents.
const MOST = 200;

// A body on its orbit about a centre of mu = G M at the origin.
@unmanaged
export class Orbit {
  x: f64;
  y: f64;
  z: f64;
  vx: f64;
  vy: f64;
  vz: f64;
}

// Moves a body on by `dt`; false, and the body unmoved, for one in the centre, or when a value is not finite. Few
// divisions: they are what the time goes into.
export function advanceKepler(o: Orbit, mu: f64, dt: f64): bool {
  const x = o.x;
  const y = o.y;
  const z = o.z;
  const vx = o.vx;
  const vy = o.vy;
  const vz = o.vz;
  const r0 = sqrt<f64>(x * x + y * y + z * z);
  if (!(r0 > 0) || !(r0 < Infinity)) return false;
  const inverse = 1 / r0;
  const beta = 2 * mu * inverse - (vx * vx + vy * vy + vz * vz);
  const eta = x * vx + y * vy + z * vz;
  const zeta = mu - beta * r0;
  if (!solveTime(r0, inverse, beta, eta, zeta, dt)) return false;
  const r = r0 + eta * g1 + zeta * g2;
  if (!(r > 0) || !(r < Infinity)) return false;
  // Lagrange's f - 1, g, f', g' - 1: differences, so that short steps lose nothing.
  const pull = -mu / r;
  const f = -mu * g2 * inverse;
  const g = dt - mu * g3;
  const fd = pull * g1 * inverse;
  const gd = pull * g2;
  o.x = x + (f * x + g * vx);
  o.y = y + (f * y + g * vy);
  o.z = z + (f * z + g * vz);
  o.vx = vx + (fd * x + gd * vx);
  o.vy = vy + (fd * y + gd * vy);
  o.vz = vz + (fd * z + gd * vz);
  return true;
}

// G1, G2, G3 at the root of the time equation.
let g1: f64 = 0;
let g2: f64 = 0;
let g3: f64 = 0;

// Finds s with t(s) = dt; false when there is none in the range of numbers. t grows with s everywhere (dt/ds = r > 0), so
// a bracket and Halley's steps inside it find it.
function solveTime(r0: f64, inverse: f64, beta: f64, eta: f64, zeta: f64, dt: f64): bool {
  // Backwards is forwards with the velocity turned round: eta, G1 and G3 change their signs.
  const sign: f64 = dt < 0 ? -1 : 1;
  const turned = sign * eta;
  const time = abs<f64>(dt);
  let low: f64 = 0;
  let high: f64 = Infinity;
  let s = guess(r0, inverse, beta, turned, zeta, time);
  for (let i = 0; i < MOST; i++) {
    stumpff(beta * s * s);
    const G1 = s * c1;
    const G2 = s * s * c2;
    const G3 = s * s * s * c3;
    const miss = r0 * s + turned * G2 + zeta * G3 - time;
    const r = r0 + turned * G1 + zeta * G2;
    // An s that is far too large overflows to NaN.
    if (miss <= 0) low = s;
    else high = s;
    const bend = miss * (turned * c0 + zeta * G1);
    const slope = 2 * r * r - bend;
    const d = slope > r * r ? (-2 * miss * r) / slope : -miss / r;
    if (abs<f64>(d) <= 2e-6 * s) {
      // Halley's error is the cube of its step, so this is the last; three terms of Taylor carry the functions there.
      const half = 0.5 * d;
      const third = d * (1.0 / 3);
      const G0 = c0;
      const bent = beta * G1;
      g1 = sign * (G1 + d * (G0 - half * (bent + third * beta * G0)));
      g2 = G2 + d * (G1 + half * (G0 - third * bent));
      g3 = sign * (G3 + d * (G2 + half * (G1 + third * G0)));
      return true;
    }
    const next = s + d;
    s = next > low && next < high ? next : high < Infinity ? 0.5 * (low + high) : 2 * s;
  }
  return false;
}

// Four terms of the series of s in dt where the step is short against the orbit, else the mean motion.
// @ts-ignore: decorator
@inline function guess(r0: f64, inverse: f64, beta: f64, eta: f64, zeta: f64, dt: f64): f64 {
  const first = dt * inverse;
  const e = eta * first * inverse;
  const z = zeta * first * first * inverse;
  if (abs<f64>(e) < 0.3 && abs<f64>(z) < 0.3) {
    const b = beta * first * first;
    return first * (1 - 0.5 * e + 0.5 * e * e - z * (1.0 / 6) + e * ((5.0 / 12) * z + b * (1.0 / 24) - 0.625 * e * e));
  }
  return beta > 0 ? (dt * beta) / (zeta + beta * r0) : first;
}

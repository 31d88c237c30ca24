// Motion along a Kepler orbit of any kind (ellipse, parabola, hyperbola) by universal variables: with Stumpff's
// functions c0 ... c3 and G_n = s^n c_n(beta s^2), the time equation r0 s + eta G2 + zeta G3 = dt is solved for s.
// Stumpff, Himmelsmechanik I (1959); Danby, Fundamentals of Celestial Mechanics (1988), section 6.9; Rein and Tamayo,
// MNRAS 452, 376 (2015), section 2. It uses only + - * / sqrt, for the same bits on every machine.

let c0: f64 = 0;
let c1: f64 = 0;
let c2: f64 = 0;
let c3: f64 = 0;

// c_n(z) = 1/n! - z/(n+2)! + z^2/(n+4)! - ..., with z divided by 4 until the series converges fast.
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

// Maximum number of iterations: the bracket halves at worst, and an f64 has 53 bits and about a thousand exponents.
const MAX_ITERATIONS = 200;

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

// Advances a body by `dt`; returns false, without a change, for a body in the centre, or if a value is not finite.
// Divisions dominate the cost, so they are few.
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
  // Lagrange's f - 1, g, f', g' - 1: differences, so that short steps lose no digits.
  const acceleration = -mu / r;
  const f = -mu * g2 * inverse;
  const g = dt - mu * g3;
  const fd = acceleration * g1 * inverse;
  const gd = acceleration * g2;
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

// Solves t(s) = dt for s; returns false if there is no finite solution. t is monotonic (dt/ds = r > 0), so Halley's
// method within a bracket converges.
function solveTime(r0: f64, inverse: f64, beta: f64, eta: f64, zeta: f64, dt: f64): bool {
  // A negative dt is a positive one with reversed velocity: eta, G1 and G3 change their signs.
  const sign: f64 = dt < 0 ? -1 : 1;
  const signedEta = sign * eta;
  const time = abs<f64>(dt);
  let low: f64 = 0;
  let high: f64 = Infinity;
  let s = initialGuess(r0, inverse, beta, signedEta, zeta, time);
  for (let i = 0; i < MAX_ITERATIONS; i++) {
    stumpff(beta * s * s);
    const G1 = s * c1;
    const G2 = s * s * c2;
    const G3 = s * s * s * c3;
    const error = r0 * s + signedEta * G2 + zeta * G3 - time;
    const r = r0 + signedEta * G1 + zeta * G2;
    // A far too large s overflows to NaN, and counts as too large.
    if (error <= 0) low = s;
    else high = s;
    const curvature = error * (signedEta * c0 + zeta * G1);
    const slope = 2 * r * r - curvature;
    const d = slope > r * r ? (-2 * error * r) / slope : -error / r;
    if (abs<f64>(d) <= 2e-6 * s) {
      // The error of Halley's method is cubic in its step, so this step is the last; a Taylor series of three terms
      // updates the functions.
      const half = 0.5 * d;
      const third = d * (1.0 / 3);
      const G0 = c0;
      const betaG1 = beta * G1;
      g1 = sign * (G1 + d * (G0 - half * (betaG1 + third * beta * G0)));
      g2 = G2 + d * (G1 + half * (G0 - third * betaG1));
      g3 = sign * (G3 + d * (G2 + half * (G1 + third * G0)));
      return true;
    }
    const next = s + d;
    s = next > low && next < high ? next : high < Infinity ? 0.5 * (low + high) : 2 * s;
  }
  return false;
}

// Initial guess: four terms of the series of s in dt for a short step, else the mean motion.
// @ts-ignore: decorator
@inline function initialGuess(r0: f64, inverse: f64, beta: f64, eta: f64, zeta: f64, dt: f64): f64 {
  const first = dt * inverse;
  const e = eta * first * inverse;
  const z = zeta * first * first * inverse;
  if (abs<f64>(e) < 0.3 && abs<f64>(z) < 0.3) {
    const b = beta * first * first;
    return first * (1 - 0.5 * e + 0.5 * e * e - z * (1.0 / 6) + e * ((5.0 / 12) * z + b * (1.0 / 24) - 0.625 * e * e));
  }
  return beta > 0 ? (dt * beta) / (zeta + beta * r0) : first;
}

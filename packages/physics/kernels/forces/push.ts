// Forces that come from outside: pushes, noise, engines and motors.
import { columns, get, put } from '../columns';
import { LANES, add, at, splat } from '../lanes';
import { cosine, logarithm, sine } from '../math/elementary';

// F += f along one axis, on bodies with mass (or torque on bodies with inertia).
export function pushAxis(force: usize, mass: usize, f: real, first: i32, last: i32): void {
  const size = splat(f);
  const zero = splat(0);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const pushed = v128.and(size, v128.gt<real>(v128.load(mass + o), zero));
    v128.store(force + o, add(v128.load(force + o), pushed));
  }
}

// Adds to one row.
export function addToRow(column: usize, row: i32, value: real): void {
  put(column, row, get(column, row) + value);
}

// A bijection of 32 bits with good avalanche (Wellons, lowbias32, 2018).
// @ts-ignore: decorator
@inline function mix(value: u32): u32 {
  let z = value;
  z = (z ^ (z >> 16)) * 0x21f0aaad;
  z = (z ^ (z >> 15)) * 0x735a2d97;
  return z ^ (z >> 15);
}

// Uniform in (0, 1) from two words, and never 0.
// @ts-ignore: decorator
@inline function unit(a: u32, b: u32): f64 {
  return (<f64>(a >> 6) * 67108864 + <f64>(b >> 6) + 0.5) * 2.220446049250313e-16;
}

// Adds to bodies with mass a normal force with the given deviations. It depends on the seed, the step and the body's id
// alone: the same in every evaluation of a step, in tiles or not. Box and Muller, Annals of Math. Statistics 29 (1958).
export function noiseForce(
  fx: usize,
  fy: usize,
  fz: usize,
  dx: f64,
  dy: f64,
  dz: f64,
  seed: u32,
  step: u32,
  first: i32,
  last: i32,
): void {
  const c = columns();
  const key = mix(seed ^ mix(step + 0x9e3779b9));
  for (let row = first; row < last; row++) {
    if (!(get(c.mass, row) > 0)) continue;
    const body = mix(key + <u32>row * 0x85ebca6b);
    const radius = sqrt<f64>(-2 * logarithm(unit(mix(body ^ 0x243f6a88), mix(body + 0x85a308d3))));
    const angle = 6.283185307179586 * unit(mix(body ^ 0x13198a2e), mix(body + 0x03707344));
    put(fx, row, get(fx, row) + <real>(dx * radius * cosine(angle)));
    put(fy, row, get(fy, row) + <real>(dy * radius * sine(angle)));
    if (dz == 0) continue;
    const radiusZ = sqrt<f64>(-2 * logarithm(unit(mix(body ^ 0xa4093822), mix(body + 0x299f31d0))));
    const angleZ = 6.283185307179586 * unit(mix(body ^ 0x082efa98), mix(body + 0xec4e6c89));
    put(fz, row, get(fz, row) + <real>(dz * radiusZ * cosine(angleZ)));
  }
}

// F += a, a column of vectors of the body's own frame, turned by its angle.
export function turnedForce2d(fx: usize, fy: usize, x: usize, y: usize, angle: usize, first: i32, last: i32): void {
  for (let row = first; row < last; row++) {
    const ax = <f64>get(x, row);
    const ay = <f64>get(y, row);
    if (ax == 0 && ay == 0) continue;
    const a = <f64>get(angle, row);
    const c = cosine(a);
    const s = sine(a);
    put(fx, row, get(fx, row) + <real>(c * ax - s * ay));
    put(fy, row, get(fy, row) + <real>(s * ax + c * ay));
  }
}

// The same in space, turned by the unit quaternion (u, w): a + 2 u x (u x a + w a).
export function turnedForce3d(
  fx: usize,
  fy: usize,
  fz: usize,
  x: usize,
  y: usize,
  z: usize,
  qx: usize,
  qy: usize,
  qz: usize,
  qw: usize,
  first: i32,
  last: i32,
): void {
  for (let row = first; row < last; row++) {
    const ax = get(x, row);
    const ay = get(y, row);
    const az = get(z, row);
    if (ax == 0 && ay == 0 && az == 0) continue;
    const ux = get(qx, row);
    const uy = get(qy, row);
    const uz = get(qz, row);
    const w = get(qw, row);
    const tx = uy * az - uz * ay + w * ax;
    const ty = uz * ax - ux * az + w * ay;
    const tz = ux * ay - uy * ax + w * az;
    put(fx, row, get(fx, row) + ax + <real>2 * (uy * tz - uz * ty));
    put(fy, row, get(fy, row) + ay + <real>2 * (uz * tx - ux * tz));
    put(fz, row, get(fz, row) + az + <real>2 * (ux * ty - uy * tx));
  }
}

// Burns the fuel of one step: fuel and mass fall by the same amount b, and the engine's thrust becomes the constant
// force that gives the remaining mass exactly the velocity v_e ln(m / (m - b)) in the step (Tsiolkovsky).
export function burnFuel(
  fuel: usize,
  rate: usize,
  throttle: usize,
  exhaust: usize,
  x: usize,
  y: usize,
  z: usize,
  tx: usize,
  ty: usize,
  tz: usize,
  dt: f64,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    if (get(rate, row) == 0 && get(tx, row) == 0 && get(ty, row) == 0 && get(tz, row) == 0) continue;
    const mass = get(c.mass, row);
    const left = get(fuel, row);
    const wanted = <real>(<f64>get(rate, row) * <f64>get(throttle, row) * dt);
    // A rocket of nothing but fuel would end with infinite speed: a millionth of its mass stays, and the fire dies.
    const most = mass * <real>0.999999;
    const asked = max<real>(0, min<real>(wanted, left));
    const burnt = min<real>(asked, most);
    const rest = mass - burnt;
    const gain = rest > 0 ? <f64>get(exhaust, row) * logarithm(<f64>mass / <f64>rest) : 0;
    const size = (<f64>rest * gain) / dt;
    put(fuel, row, asked > most ? 0 : left - burnt);
    if (mass > 0) put(c.mass, row, rest);
    put(tx, row, <real>(size * <f64>get(x, row)));
    put(ty, row, <real>(size * <f64>get(y, row)));
    put(tz, row, <real>(size * <f64>get(z, row)));
  }
}

// F += min(P / |v|, most) along v; at rest along the heading.
export function motorForce(
  fx: usize,
  fy: usize,
  fz: usize,
  powers: usize,
  most: usize,
  hx: real,
  hy: real,
  hz: real,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const watts = get(powers, row);
    if (watts == 0) continue;
    const limit = get(most, row);
    let x = get(c.velocityX, row);
    let y = get(c.velocityY, row);
    let z = get(c.velocityZ, row);
    const speed = sqrt<real>(x * x + y * y + z * z);
    const ratio = watts / speed;
    const size = speed > 0 && abs<real>(ratio) < limit ? ratio : copysign<real>(limit, watts);
    if (speed > 0) {
      x /= speed;
      y /= speed;
      z /= speed;
    } else {
      // A brake has nothing to act against at rest.
      if (watts < 0) continue;
      x = hx;
      y = hy;
      z = hz;
    }
    put(fx, row, get(fx, row) + size * x);
    put(fy, row, get(fy, row) + size * y);
    put(fz, row, get(fz, row) + size * z);
  }
}

// Velocity change of a blast: along r, impulse J (1 - r/R)^fall within R. At the very centre there is no direction.
export function blast(cx: f64, cy: f64, cz: f64, impulse: f64, radius: f64, fall: i32, first: i32, last: i32): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const mass = <f64>get(c.mass, row);
    if (!(mass > 0)) continue;
    const x = <f64>get(c.positionX, row) - cx;
    const y = <f64>get(c.positionY, row) - cy;
    const z = <f64>get(c.positionZ, row) - cz;
    const r = sqrt<f64>(x * x + y * y + z * z);
    if (!(r > 0) || r >= radius) continue;
    let size = impulse / (mass * r);
    for (let i = 0; i < fall; i++) size *= 1 - r / radius;
    put(c.velocityX, row, get(c.velocityX, row) + <real>(size * x));
    put(c.velocityY, row, get(c.velocityY, row) + <real>(size * y));
    put(c.velocityZ, row, get(c.velocityZ, row) + <real>(size * z));
  }
}

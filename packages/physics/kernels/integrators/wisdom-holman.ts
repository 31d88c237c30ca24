// Kepler drifts and interaction kicks in Jacobi coordinates: src/integrators/wisdom-holman.ts. Arithmetic is f64 in
// both precisions.
import { columns, get, put } from '../memory/columns';
import { advanceKepler, Orbit } from './kepler';

// A body: Jacobi position and velocity, mass, the fraction of the total mass up to and including it that is its own (0
// for a test particle), and G times the mass of its Kepler orbit.
@unmanaged
export class Planet {
  x: f64;
  y: f64;
  z: f64;
  vx: f64;
  vy: f64;
  vz: f64;
  mass: f64;
  fraction: f64;
  mu: f64;
  row: i32;
  unused: i32;
}

const PLANET_BYTES: usize = offsetof<Planet>();

// @ts-ignore: decorator
@inline function planet(list: usize, index: i32): Planet {
  return changetype<Planet>(list + <usize>index * PLANET_BYTES);
}

// Lists bodies with mass: `central` first, then the others by ascending id. Those with the test bit exert no force, so
// that their masses do not count in the centres that others move about. Returns their number.
export function gatherPlanets(list: usize, ids: usize, count: i32, central: i32, testBit: u32, G: f64): i32 {
  const c = columns();
  let n = 1;
  let enclosed = <f64>get(c.mass, central);
  const sun = enclosed;
  planet(list, 0).row = central;
  planet(list, 0).mass = sun;
  planet(list, 0).fraction = 1;
  for (let i = 0; i < count; i++) {
    const row = load<i32>(ids + ((<usize>i) << 2));
    const mass = <f64>get(c.mass, row);
    if (row == central || mass <= 0) continue;
    const isTest = (load<u32>(c.members + ((<usize>row) << 2)) & testBit) != 0;
    const source: f64 = isTest ? 0 : mass;
    const p = planet(list, n);
    p.row = row;
    p.mass = mass;
    p.mu = (G * sun * (enclosed + source)) / enclosed;
    enclosed += source;
    p.fraction = source / enclosed;
    n++;
  }
  return n;
}

// Converts the columns to Jacobi coordinates: each body relative to the centre of mass of the bodies before it; the
// first is the centre of mass of all.
export function toJacobi(list: usize, n: i32): void {
  const c = columns();
  let x: f64 = 0;
  let y: f64 = 0;
  let z: f64 = 0;
  let vx: f64 = 0;
  let vy: f64 = 0;
  let vz: f64 = 0;
  for (let i = 0; i < n; i++) {
    const p = planet(list, i);
    p.x = <f64>get(c.positionX, p.row) - x;
    p.y = <f64>get(c.positionY, p.row) - y;
    p.z = <f64>get(c.positionZ, p.row) - z;
    p.vx = <f64>get(c.velocityX, p.row) - vx;
    p.vy = <f64>get(c.velocityY, p.row) - vy;
    p.vz = <f64>get(c.velocityZ, p.row) - vz;
    // Not even a test particle that is not finite reaches the others.
    if (p.fraction == 0) continue;
    const fraction = p.fraction;
    x += fraction * p.x;
    y += fraction * p.y;
    z += fraction * p.z;
    vx += fraction * p.vx;
    vy += fraction * p.vy;
    vz += fraction * p.vz;
  }
  const sun = planet(list, 0);
  sun.x = x;
  sun.y = y;
  sun.z = z;
  sun.vx = vx;
  sun.vy = vy;
  sun.vz = vz;
}

// Converts Jacobi coordinates back to the columns.
export function fromJacobi(list: usize, n: i32): void {
  const c = columns();
  const sun = planet(list, 0);
  let x = sun.x;
  let y = sun.y;
  let z = sun.z;
  let vx = sun.vx;
  let vy = sun.vy;
  let vz = sun.vz;
  for (let i = n - 1; i > 0; i--) {
    const p = planet(list, i);
    const fraction = p.fraction;
    if (fraction != 0) {
      x -= fraction * p.x;
      y -= fraction * p.y;
      z -= fraction * p.z;
      vx -= fraction * p.vx;
      vy -= fraction * p.vy;
      vz -= fraction * p.vz;
    }
    write(p.row, x + p.x, y + p.y, z + p.z, vx + p.vx, vy + p.vy, vz + p.vz);
  }
  write(sun.row, x, y, z, vx, vy, vz);
}

// @ts-ignore: decorator
@inline function write(row: i32, x: f64, y: f64, z: f64, vx: f64, vy: f64, vz: f64): void {
  const c = columns();
  put(c.positionX, row, <real>x);
  put(c.positionY, row, <real>y);
  put(c.positionZ, row, <real>z);
  put(c.velocityX, row, <real>vx);
  put(c.velocityY, row, <real>vy);
  put(c.velocityZ, row, <real>vz);
}

// Drift: every body along its Kepler orbit, the centre of mass along a straight line. Returns the row of a body whose
// orbit failed, which stays in place, or 0.
export function driftKepler(list: usize, n: i32, dt: f64): i32 {
  const sun = planet(list, 0);
  sun.x += sun.vx * dt;
  sun.y += sun.vy * dt;
  sun.z += sun.vz * dt;
  let failedRow = 0;
  for (let i = 1; i < n; i++) {
    const p = planet(list, i);
    if (!advanceKepler(changetype<Orbit>(p), p.mu, dt) && failedRow == 0) failedRow = p.row;
  }
  return failedRow;
}

// Kick: the Jacobi part of all forces, without the attraction of the Kepler drift.
export function kickJacobi(list: usize, n: i32, fx: usize, fy: usize, fz: usize, dt: f64): void {
  let ax: f64 = 0;
  let ay: f64 = 0;
  let az: f64 = 0;
  for (let i = 0; i < n; i++) {
    const p = planet(list, i);
    const x = <f64>get(fx, p.row) / p.mass - ax;
    const y = <f64>get(fy, p.row) / p.mass - ay;
    // In two dimensions there is no column of z-forces.
    const z = fz == 0 ? <f64>0 : <f64>get(fz, p.row) / p.mass - az;
    if (i > 0) {
      const r2 = p.x * p.x + p.y * p.y + p.z * p.z;
      const k = p.mu / (r2 * sqrt<f64>(r2));
      p.vx += dt * (x + k * p.x);
      p.vy += dt * (y + k * p.y);
      p.vz += dt * (z + k * p.z);
    }
    if (p.fraction == 0) continue;
    const fraction = p.fraction;
    ax += fraction * x;
    ay += fraction * y;
    az += fraction * z;
  }
  const sun = planet(list, 0);
  sun.vx += dt * ax;
  sun.vy += dt * ay;
  sun.vz += dt * az;
}

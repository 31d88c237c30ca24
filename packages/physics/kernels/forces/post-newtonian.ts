// First post-Newtonian correction to the gravity of one body on all others.
import { columns, get, put } from '../memory/columns';

// F += m mu/(c^2 r^3) [(4 mu/r - v^2) r + 4 (r.v) v], with r and v relative to row `central`. In 2D fz is 0.
export function postNewtonian(
  fx: usize,
  fy: usize,
  fz: usize,
  central: i32,
  mu: f64,
  speedOfLight: f64,
  first: i32,
  last: i32,
): void {
  const c = columns();
  const x0 = <f64>get(c.positionX, central);
  const y0 = <f64>get(c.positionY, central);
  const z0 = <f64>get(c.positionZ, central);
  const vx0 = <f64>get(c.velocityX, central);
  const vy0 = <f64>get(c.velocityY, central);
  const vz0 = <f64>get(c.velocityZ, central);
  const scale = mu / (speedOfLight * speedOfLight);
  for (let row = first; row < last; row++) {
    const mass = <f64>get(c.mass, row);
    if (mass == 0 || row == central) continue;
    const x = <f64>get(c.positionX, row) - x0;
    const y = <f64>get(c.positionY, row) - y0;
    const z = <f64>get(c.positionZ, row) - z0;
    const vx = <f64>get(c.velocityX, row) - vx0;
    const vy = <f64>get(c.velocityY, row) - vy0;
    const vz = <f64>get(c.velocityZ, row) - vz0;
    const r2 = x * x + y * y + z * z;
    if (r2 == 0) continue;
    const r = sqrt<f64>(r2);
    const k = (mass * scale) / (r2 * r);
    const radial = k * ((4 * mu) / r - (vx * vx + vy * vy + vz * vz));
    const velocityFactor = 4 * k * (x * vx + y * vy + z * vz);
    put(fx, row, get(fx, row) + <real>(radial * x + velocityFactor * vx));
    put(fy, row, get(fy, row) + <real>(radial * y + velocityFactor * vy));
    if (fz != 0) put(fz, row, get(fz, row) + <real>(radial * z + velocityFactor * vz));
  }
}

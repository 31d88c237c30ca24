// Coulomb friction of a round body against something it touches at -radius n, with spin.
//
// The velocity of the contact point is u = v + omega x (-r n). Stopping its tangential part takes a change of the
// centre's velocity of -u_t / (1 + m r^2/I), because the same impulse also turns the body; Coulomb's law limits that
// change to mu times the change of normal velocity. A body whose rotation is locked (I = 0) counts as m r^2/I = 0.
// In 2D n_z = 0 and omega = (0, 0, omega_z), and the same lines serve.
import { Columns, get, put } from '../columns';

export function wallFriction(
  c: Columns, row: i32, nx: real, ny: real, nz: real, friction: real, normalChange: real,
): void {
  const r = get(c.radius, row);
  const inertia = get(c.inertia, row);
  let wx = get(c.angularVelocityX, row);
  let wy = get(c.angularVelocityY, row);
  let wz = get(c.angularVelocityZ, row);
  let vx = get(c.velocityX, row);
  let vy = get(c.velocityY, row);
  let vz = get(c.velocityZ, row);
  const ux = vx - r * (wy * nz - wz * ny);
  const uy = vy - r * (wz * nx - wx * nz);
  const uz = vz - r * (wx * ny - wy * nx);
  const un = ux * nx + uy * ny + uz * nz;
  const tx = ux - un * nx;
  const ty = uy - un * ny;
  const tz = uz - un * nz;
  const slip = sqrt<real>(tx * tx + ty * ty + tz * tz);
  if (slip == 0) return;
  const ratio = inertia > 0 ? (get(c.mass, row) / inertia) * r : <real>0;
  const stick = <real>1 / (<real>1 + ratio * r);
  const scale = -min<real>(stick, (friction * normalChange) / slip);
  const dx = tx * scale;
  const dy = ty * scale;
  const dz = tz * scale;
  put(c.velocityX, row, vx + dx);
  put(c.velocityY, row, vy + dy);
  put(c.velocityZ, row, vz + dz);
  if (ratio == 0) return;
  put(c.angularVelocityX, row, wx - ratio * (ny * dz - nz * dy));
  put(c.angularVelocityY, row, wy - ratio * (nz * dx - nx * dz));
  put(c.angularVelocityZ, row, wz - ratio * (nx * dy - ny * dx));
}

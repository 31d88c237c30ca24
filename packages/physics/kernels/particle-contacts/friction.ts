// Coulomb friction at the contact point of two round bodies, including spin.
//
// With n from a to b, the relative surface velocity is
//     u = v_b - v_a - omega_b x (r_b n) - omega_a x (r_a n).
// The impulse that stops its tangential part u_t is |u_t| / (1/m_a + 1/m_b + r_a^2/I_a + r_b^2/I_b), because it also
// changes the spins. Coulomb's law limits it to mu times the normal impulse. A body with locked rotation has no inertia
// term; a wall is a body with zero 1/m, radius and velocity. In 2D n_z = 0 and omega = (0, 0, omega_z), so the same
// code applies.
import { Columns } from '../memory/columns';
import { Body, wallContactBody, applyVelocityChange, staticBody, loadMotion, storeMotion } from './body';
import { FINITE } from './table';

// Tangential velocity of b's surface relative to a's, and the tangential effective mass (impulse per unit slip speed).
let slipX: real = 0;
let slipY: real = 0;
let slipZ: real = 0;
let tangentMass: real = 0;

function readSlip(a: Body, b: Body, nx: real, ny: real, nz: real): void {
  const sx = a.radius * a.wx + b.radius * b.wx;
  const sy = a.radius * a.wy + b.radius * b.wy;
  const sz = a.radius * a.wz + b.radius * b.wz;
  const ux = b.vx - a.vx - (sy * nz - sz * ny);
  const uy = b.vy - a.vy - (sz * nx - sx * nz);
  const uz = b.vz - a.vz - (sx * ny - sy * nx);
  const un = ux * nx + uy * ny + uz * nz;
  slipX = ux - un * nx;
  slipY = uy - un * ny;
  slipZ = uz - un * nz;
  tangentMass =
    <real>1 / (a.inverseMass + b.inverseMass + a.radiusOverInertia * a.radius + b.radiusOverInertia * b.radius);
}

// Applies the friction impulse of an impact with normal impulse `impulse` that happened `time` ago.
export function applyFriction(
  a: Body,
  b: Body,
  nx: real,
  ny: real,
  nz: real,
  friction: real,
  impulse: real,
  time: real,
): void {
  if (!(friction * impulse > 0)) return;
  readSlip(a, b, nx, ny, nz);
  const slip = sqrt<real>(slipX * slipX + slipY * slipY + slipZ * slipZ);
  const size = min<real>(tangentMass * slip, friction * impulse);
  if (!(size > 0 && size < FINITE && slip < FINITE)) return;
  const scale = -size / slip;
  applyTangentImpulse(a, b, nx, ny, nz, slipX * scale, slipY * scale, slipZ * scale, time);
}

// Updates the friction of a persistent contact. `accumulated` points to the accumulated tangential impulse on b in this
// step (three f32), whose magnitude must not exceed `limit`.
export function solveFriction(
  a: Body,
  b: Body,
  nx: real,
  ny: real,
  nz: real,
  limit: real,
  accumulated: usize,
  time: real,
): void {
  readSlip(a, b, nx, ny, nz);
  const oldX = <real>load<f32>(accumulated);
  const oldY = <real>load<f32>(accumulated, 4);
  const oldZ = <real>load<f32>(accumulated, 8);
  const x = oldX - slipX * tangentMass;
  const y = oldY - slipY * tangentMass;
  const z = oldZ - slipZ * tangentMass;
  const size = sqrt<real>(x * x + y * y + z * z);
  if (!(size < FINITE)) return;
  const scale = size > limit ? limit / size : <real>1;
  store<f32>(accumulated, <f32>(x * scale));
  store<f32>(accumulated, <f32>(y * scale), 4);
  store<f32>(accumulated, <f32>(z * scale), 8);
  // The applied impulse is the difference of the stored f32 values, so that both agree to the bit.
  applyTangentImpulse(
    a,
    b,
    nx,
    ny,
    nz,
    <real>load<f32>(accumulated) - oldX,
    <real>load<f32>(accumulated, 4) - oldY,
    <real>load<f32>(accumulated, 8) - oldZ,
    time,
  );
}

function applyTangentImpulse(
  a: Body,
  b: Body,
  nx: real,
  ny: real,
  nz: real,
  jx: real,
  jy: real,
  jz: real,
  time: real,
): void {
  applyToBody(a, -a.inverseMass, nx, ny, nz, jx, jy, jz, time);
  applyToBody(b, b.inverseMass, nx, ny, nz, jx, jy, jz, time);
}

// Both bodies receive the same angular impulse, because impulse and lever arm are both opposite: omega -= r/I (n x j).
function applyToBody(
  b: Body,
  signedInverseMass: real,
  nx: real,
  ny: real,
  nz: real,
  jx: real,
  jy: real,
  jz: real,
  time: real,
): void {
  applyVelocityChange(b, signedInverseMass * jx, signedInverseMass * jy, signedInverseMass * jz, time);
  const k = b.radiusOverInertia;
  b.wx -= k * (ny * jz - nz * jy);
  b.wy -= k * (nz * jx - nx * jz);
  b.wz -= k * (nx * jy - ny * jx);
}

// Applies wall friction to the velocities of one row. `time` is how long ago it acted, on average. Returns a body whose
// position is the way by which the caller is to move that row since.
export function applyWallFriction(
  c: Columns,
  row: i32,
  nx: real,
  ny: real,
  nz: real,
  friction: real,
  impulse: real,
  time: real,
): Body {
  const b = wallContactBody();
  b.x = b.y = b.z = 0;
  if (!(friction * impulse > 0)) return b;
  loadMotion(c, row, b);
  applyFriction(staticBody(), b, nx, ny, nz, friction, impulse, time);
  storeMotion(c, row, b);
  return b;
}

// Returns how long ago the impulse of a wall acted, on average: it changed the speed across the wall by `change` and the
// distance by `shift` since. Friction, which is limited by it, acted at the same time. Overlap of other origin may
// shift a body by more; then it is the whole step.
// @ts-ignore: decorator
@inline export function timeOfImpulse(shift: real, change: real, dt: real): real {
  return change > 0 ? max<real>(0, min<real>(shift / change, dt)) : <real>0;
}

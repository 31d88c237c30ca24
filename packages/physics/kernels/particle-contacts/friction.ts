// Coulomb friction between two round bodies that touch at a point, with spin.
//
// With n from a to b, the surfaces slip at
//     u = v_b - v_a - omega_b x (r_b n) - omega_a x (r_a n),
// and stopping the tangential part u_t takes an impulse of |u_t| / (1/m_a + 1/m_b + r_a^2/I_a + r_b^2/I_b), because the
// same impulse turns the bodies. Coulomb's law limits it to mu times the normal impulse. A body whose rotation is locked
// has no such term; a wall is a body without mass, radius or motion.
// In 2D n_z = 0 and omega = (0, 0, omega_z), and the same lines serve.
import { Columns } from '../memory/columns';
import { Body, bodyAtWall, kick, nobody, readMotion, writeMotion } from './body';
import { FINITE } from './table';

// The tangential velocity of b's surface past a's, and the impulse per speed that stops it.
let slipX: real = 0;
let slipY: real = 0;
let slipZ: real = 0;
let stop: real = 0;

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
  stop = <real>1 / (a.inverseMass + b.inverseMass + a.turning * a.radius + b.turning * b.radius);
}

// Applies the friction that goes with the normal impulse `impulse` of an impact a time `time` ago.
export function rub(a: Body, b: Body, nx: real, ny: real, nz: real, friction: real, impulse: real, time: real): void {
  if (!(friction * impulse > 0)) return;
  readSlip(a, b, nx, ny, nz);
  const slip = sqrt<real>(slipX * slipX + slipY * slipY + slipZ * slipZ);
  const size = min<real>(stop * slip, friction * impulse);
  if (!(size > 0 && size < FINITE && slip < FINITE)) return;
  const scale = -size / slip;
  apply(a, b, nx, ny, nz, slipX * scale, slipY * scale, slipZ * scale, time);
}

// Brings the friction of a contact that lasts up to date: `sum` holds three f32, the tangential impulse on b so far in
// this step, which may not exceed `limit`.
export function hold(a: Body, b: Body, nx: real, ny: real, nz: real, limit: real, sum: usize, time: real): void {
  readSlip(a, b, nx, ny, nz);
  const oldX = <real>load<f32>(sum);
  const oldY = <real>load<f32>(sum, 4);
  const oldZ = <real>load<f32>(sum, 8);
  const x = oldX - slipX * stop;
  const y = oldY - slipY * stop;
  const z = oldZ - slipZ * stop;
  const size = sqrt<real>(x * x + y * y + z * z);
  if (!(size < FINITE)) return;
  const scale = size > limit ? limit / size : <real>1;
  store<f32>(sum, <f32>(x * scale));
  store<f32>(sum, <f32>(y * scale), 4);
  store<f32>(sum, <f32>(z * scale), 8);
  // What is stored is what has been applied, to the bit.
  apply(
    a,
    b,
    nx,
    ny,
    nz,
    <real>load<f32>(sum) - oldX,
    <real>load<f32>(sum, 4) - oldY,
    <real>load<f32>(sum, 8) - oldZ,
    time,
  );
}

function apply(a: Body, b: Body, nx: real, ny: real, nz: real, jx: real, jy: real, jz: real, time: real): void {
  push(a, -a.inverseMass, nx, ny, nz, jx, jy, jz, time);
  push(b, b.inverseMass, nx, ny, nz, jx, jy, jz, time);
}

// Both bodies turn the same way: the impulse is opposite and so is the arm. omega -= r/I (n x j).
function push(b: Body, w: real, nx: real, ny: real, nz: real, jx: real, jy: real, jz: real, time: real): void {
  kick(b, w * jx, w * jy, w * jz, time);
  const k = b.turning;
  b.wx -= k * (ny * jz - nz * jy);
  b.wy -= k * (nz * jx - nx * jz);
  b.wz -= k * (nx * jy - ny * jx);
}

// Friction of the body of a row at a wall, in the columns; positions stay.
export function rubWall(c: Columns, row: i32, nx: real, ny: real, nz: real, friction: real, impulse: real): void {
  if (!(friction * impulse > 0)) return;
  const b = bodyAtWall();
  readMotion(c, row, b);
  rub(nobody(), b, nx, ny, nz, friction, impulse, 0);
  writeMotion(c, row, b);
}

// Coulomb friction between two round bodies that touch at a point, with spin.
//
// With n from a to b, the surfaces slip at
//     u = v_b - v_a - omega_b x (r_b n) - omega_a x (r_a n),
// and stopping the tangential part u_t takes an impulse of |u_t| / (1/m_a + 1/m_b + r_a^2/I_a + r_b^2/I_b), because the
// same impulse turns the bodies. Coulomb's law limits it to mu times the normal impulse. A body whose rotation is locked
// (I = 0, or no AngularVelocity) has no such term. Row 0 belongs to no body and holds zeros: as `a` it is a wall.
// In 2D n_z = 0 and omega = (0, 0, omega_z), and the same lines serve.
import { Columns, get, put } from '../columns';
import { FINITE } from './table';

// The impulse on b that the last call applied, N s.
export let frictionX: real = 0;
export let frictionY: real = 0;
export let frictionZ: real = 0;

// The tangential velocity of b's surface past a's, and the impulse per speed that stops it.
let slipX: real = 0;
let slipY: real = 0;
let slipZ: real = 0;
let stop: real = 0;

// r/I of a body that contacts can turn, else 0.
// @ts-ignore: decorator
@inline function turning(c: Columns, row: i32): real {
  if ((load<u32>(c.members + (<usize>row << 2)) & c.angularVelocityBit) == 0) return 0;
  const inertia = get(c.inertia, row);
  const ratio = get(c.radius, row) / inertia;
  return inertia > 0 && ratio < FINITE ? ratio : <real>0;
}

// @ts-ignore: decorator
@inline export function inverseMass(c: Columns, row: i32): real {
  const mass = get(c.mass, row);
  return mass > 0 ? <real>1 / mass : <real>0;
}

function readSlip(c: Columns, a: i32, b: i32, nx: real, ny: real, nz: real): void {
  const ra = get(c.radius, a);
  const rb = get(c.radius, b);
  const sx = ra * get(c.angularVelocityX, a) + rb * get(c.angularVelocityX, b);
  const sy = ra * get(c.angularVelocityY, a) + rb * get(c.angularVelocityY, b);
  const sz = ra * get(c.angularVelocityZ, a) + rb * get(c.angularVelocityZ, b);
  const ux = get(c.velocityX, b) - get(c.velocityX, a) - (sy * nz - sz * ny);
  const uy = get(c.velocityY, b) - get(c.velocityY, a) - (sz * nx - sx * nz);
  const uz = get(c.velocityZ, b) - get(c.velocityZ, a) - (sx * ny - sy * nx);
  const un = ux * nx + uy * ny + uz * nz;
  slipX = ux - un * nx;
  slipY = uy - un * ny;
  slipZ = uz - un * nz;
  stop = <real>1 / (inverseMass(c, a) + inverseMass(c, b) + turning(c, a) * ra + turning(c, b) * rb);
}

// Applies the friction that goes with the normal impulse `impulse` of an impact, and returns 1; 0 when there is none.
export function rub(
  c: Columns, a: i32, b: i32, nx: real, ny: real, nz: real, friction: real, impulse: real,
): i32 {
  if (!(friction * impulse > 0)) return 0;
  readSlip(c, a, b, nx, ny, nz);
  const slip = sqrt<real>(slipX * slipX + slipY * slipY + slipZ * slipZ);
  const size = min<real>(stop * slip, friction * impulse);
  if (!(size > 0 && size < FINITE && slip < FINITE)) return 0;
  const scale = -size / slip;
  apply(c, a, b, nx, ny, nz, slipX * scale, slipY * scale, slipZ * scale);
  return 1;
}

// Brings the friction of a contact that lasts up to date: `sum` holds three f32, the tangential impulse on b so far in
// this step, which may not exceed `limit`. Returns 1 when anything changed.
export function hold(
  c: Columns, a: i32, b: i32, nx: real, ny: real, nz: real, limit: real, sum: usize,
): i32 {
  readSlip(c, a, b, nx, ny, nz);
  const oldX = <real>load<f32>(sum);
  const oldY = <real>load<f32>(sum, 4);
  const oldZ = <real>load<f32>(sum, 8);
  const x = oldX - slipX * stop;
  const y = oldY - slipY * stop;
  const z = oldZ - slipZ * stop;
  const size = sqrt<real>(x * x + y * y + z * z);
  if (!(size < FINITE)) return 0;
  const scale = size > limit ? limit / size : <real>1;
  store<f32>(sum, <f32>(x * scale));
  store<f32>(sum, <f32>(y * scale), 4);
  store<f32>(sum, <f32>(z * scale), 8);
  // What is stored is what has been applied, to the bit.
  const jx = <real>load<f32>(sum) - oldX;
  const jy = <real>load<f32>(sum, 4) - oldY;
  const jz = <real>load<f32>(sum, 8) - oldZ;
  if (jx == 0 && jy == 0 && jz == 0) return 0;
  apply(c, a, b, nx, ny, nz, jx, jy, jz);
  return 1;
}

function apply(
  c: Columns, a: i32, b: i32, nx: real, ny: real, nz: real, jx: real, jy: real, jz: real,
): void {
  const wa = inverseMass(c, a);
  const wb = inverseMass(c, b);
  if (wa > 0) {
    put(c.velocityX, a, get(c.velocityX, a) - wa * jx);
    put(c.velocityY, a, get(c.velocityY, a) - wa * jy);
    put(c.velocityZ, a, get(c.velocityZ, a) - wa * jz);
  }
  if (wb > 0) {
    put(c.velocityX, b, get(c.velocityX, b) + wb * jx);
    put(c.velocityY, b, get(c.velocityY, b) + wb * jy);
    put(c.velocityZ, b, get(c.velocityZ, b) + wb * jz);
  }
  spin(c, a, nx, ny, nz, jx, jy, jz);
  spin(c, b, nx, ny, nz, jx, jy, jz);
  frictionX = jx;
  frictionY = jy;
  frictionZ = jz;
}

// Both bodies turn the same way: the impulse is opposite and so is the arm. omega -= r/I (n x j).
function spin(
  c: Columns, row: i32, nx: real, ny: real, nz: real, jx: real, jy: real, jz: real,
): void {
  const k = turning(c, row);
  if (k == 0) return;
  put(c.angularVelocityX, row, get(c.angularVelocityX, row) - k * (ny * jz - nz * jy));
  put(c.angularVelocityY, row, get(c.angularVelocityY, row) - k * (nz * jx - nx * jz));
  put(c.angularVelocityZ, row, get(c.angularVelocityZ, row) - k * (nx * jy - ny * jx));
}

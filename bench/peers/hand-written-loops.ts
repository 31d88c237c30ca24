// One function for each precision and dimension, although they read alike: a function that sees arrays of both precisions
// is compiled for both and takes 1.4 times as long. Each is a function of its own in the source, because closures made
// of one source share what the compiler has learned of their arguments.
import type { Precision } from '@principia/physics';
import type { ParticleColumns } from './particles-columns.ts';

/** What is a column in our world, and what else does not change. */
export interface Constants {
  readonly dt: number;
  readonly gravity: number;
  /** Of drag over mass, 1/m. */
  readonly drag: number;
  /** Where the centre of a body meets the walls, m. */
  readonly low: number;
  readonly high: number;
  readonly restitution: number;
}

/** The columns it moves. */
type State<Column> = { readonly [Name in 'x' | 'y' | 'z' | 'vx' | 'vy' | 'vz']: Column };

/** The loop for a precision and a dimension, on these columns. */
export function handWrittenStep(
  precision: Precision,
  dimensions: 2 | 3,
  columns: ParticleColumns,
  constants: Constants,
): () => void {
  if (precision === 'f32') {
    const state = columns as State<Float32Array>;
    return dimensions === 2 ? () => step2dF32(state, constants) : () => step3dF32(state, constants);
  }
  const state = columns as State<Float64Array>;
  return dimensions === 2 ? () => step2dF64(state, constants) : () => step3dF64(state, constants);
}

function step2dF32(s: State<Float32Array>, c: Constants): void {
  const { x, y, vx, vy } = s;
  const { dt, gravity, drag, low, high, restitution } = c;
  for (let i = 0; i < x.length; i++) {
    let ux = vx[i];
    let uy = vy[i];
    const k = drag * Math.sqrt(ux * ux + uy * uy) * dt;
    ux -= k * ux;
    uy -= k * uy + gravity * dt;
    let px = x[i] + ux * dt;
    let py = y[i] + uy * dt;
    if (px < low) {
      px = low;
      ux = -restitution * ux;
    } else if (px > high) {
      px = high;
      ux = -restitution * ux;
    }
    if (py < low) {
      py = low;
      uy = -restitution * uy;
    } else if (py > high) {
      py = high;
      uy = -restitution * uy;
    }
    x[i] = px;
    y[i] = py;
    vx[i] = ux;
    vy[i] = uy;
  }
}

function step2dF64(s: State<Float64Array>, c: Constants): void {
  const { x, y, vx, vy } = s;
  const { dt, gravity, drag, low, high, restitution } = c;
  for (let i = 0; i < x.length; i++) {
    let ux = vx[i];
    let uy = vy[i];
    const k = drag * Math.sqrt(ux * ux + uy * uy) * dt;
    ux -= k * ux;
    uy -= k * uy + gravity * dt;
    let px = x[i] + ux * dt;
    let py = y[i] + uy * dt;
    if (px < low) {
      px = low;
      ux = -restitution * ux;
    } else if (px > high) {
      px = high;
      ux = -restitution * ux;
    }
    if (py < low) {
      py = low;
      uy = -restitution * uy;
    } else if (py > high) {
      py = high;
      uy = -restitution * uy;
    }
    x[i] = px;
    y[i] = py;
    vx[i] = ux;
    vy[i] = uy;
  }
}

function step3dF32(s: State<Float32Array>, c: Constants): void {
  const { x, y, z, vx, vy, vz } = s;
  const { dt, gravity, drag, low, high, restitution } = c;
  for (let i = 0; i < x.length; i++) {
    let ux = vx[i];
    let uy = vy[i];
    let uz = vz[i];
    const k = drag * Math.sqrt(ux * ux + uy * uy + uz * uz) * dt;
    ux -= k * ux;
    uy -= k * uy + gravity * dt;
    uz -= k * uz;
    let px = x[i] + ux * dt;
    let py = y[i] + uy * dt;
    let pz = z[i] + uz * dt;
    if (px < low) {
      px = low;
      ux = -restitution * ux;
    } else if (px > high) {
      px = high;
      ux = -restitution * ux;
    }
    if (py < low) {
      py = low;
      uy = -restitution * uy;
    } else if (py > high) {
      py = high;
      uy = -restitution * uy;
    }
    if (pz < low) {
      pz = low;
      uz = -restitution * uz;
    } else if (pz > high) {
      pz = high;
      uz = -restitution * uz;
    }
    x[i] = px;
    y[i] = py;
    z[i] = pz;
    vx[i] = ux;
    vy[i] = uy;
    vz[i] = uz;
  }
}

function step3dF64(s: State<Float64Array>, c: Constants): void {
  const { x, y, z, vx, vy, vz } = s;
  const { dt, gravity, drag, low, high, restitution } = c;
  for (let i = 0; i < x.length; i++) {
    let ux = vx[i];
    let uy = vy[i];
    let uz = vz[i];
    const k = drag * Math.sqrt(ux * ux + uy * uy + uz * uz) * dt;
    ux -= k * ux;
    uy -= k * uy + gravity * dt;
    uz -= k * uz;
    let px = x[i] + ux * dt;
    let py = y[i] + uy * dt;
    let pz = z[i] + uz * dt;
    if (px < low) {
      px = low;
      ux = -restitution * ux;
    } else if (px > high) {
      px = high;
      ux = -restitution * ux;
    }
    if (py < low) {
      py = low;
      uy = -restitution * uy;
    } else if (py > high) {
      py = high;
      uy = -restitution * uy;
    }
    if (pz < low) {
      pz = low;
      uz = -restitution * uz;
    } else if (pz > high) {
      pz = high;
      uz = -restitution * uz;
    }
    x[i] = px;
    y[i] = py;
    z[i] = pz;
    vx[i] = ux;
    vy[i] = uy;
    vz[i] = uz;
  }
}

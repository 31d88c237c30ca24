// One function for each precision and dimension, because a function that sees arrays of both precisions is compiled for
// both and takes 1.4 times as long. They are separate in the source, because closures of one source share type
// feedback.
import type { Precision } from '@principia/physics';
import type { ParticleColumns } from './particles-columns.ts';

/** The constants that replace columns of our world. */
export interface Constants {
  readonly dt: number;
  readonly gravity: number;
  /** Drag coefficient over mass, 1/m. */
  readonly drag: number;
  /** Limits of a body's centre at the walls, m. */
  readonly low: number;
  readonly high: number;
  readonly restitution: number;
}

/** The columns that the loop updates. */
type State<Column> = { readonly [Name in 'x' | 'y' | 'z' | 'vx' | 'vy' | 'vz']: Column };

/** Returns the loop for a precision and a dimension. */
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

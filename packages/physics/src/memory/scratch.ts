import type { Precision } from '../kernels/instantiate.ts';
import type { Arena } from './arena.ts';
import { type AxisAddresses, type AxisColumns, axisColumns } from './columns.ts';

/** Columns that mean something only inside a step: forces, and what integrators remember between their stages. */
export interface Scratch {
  /** Force on each body, N; writable by forces during `accumulate`, and only then. */
  readonly force: AxisColumns;
  /** Torque on each body, N m, likewise, by forces that say `appliesTorque`; in 2D only z is used. */
  readonly torque: AxisColumns;
  readonly at: {
    readonly force: AxisAddresses;
    readonly torque: AxisAddresses;
    /** Velocity at the start of the step. */
    readonly startVelocity: AxisAddresses;
    /** Free for the integrator. */
    readonly stage1: AxisAddresses;
    readonly stage2: AxisAddresses;
  };
}

const BUFFERS = ['force', 'startVelocity', 'stage1', 'stage2', 'torque'] as const;

/** Number of real columns the scratch takes. */
export const SCRATCH_COLUMNS = BUFFERS.length * 3;

/** Makes the scratch columns. */
export function createScratch(arena: Arena, precision: Precision, rows: number): Scratch {
  const made = BUFFERS.map((name) => axisColumns(arena, precision, rows, name));
  const [force, , , , torque] = made.map(([columns]) => columns);
  const at = Object.fromEntries(BUFFERS.map((name, i) => [name, made[i][1]]));
  return { force, torque, at } as Scratch;
}

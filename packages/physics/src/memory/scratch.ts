import type { Precision } from '../kernels/instantiate.ts';
import type { Arena } from './arena.ts';
import { type AxisAddresses, type AxisColumns, axisColumns } from './columns.ts';

/** Columns that are valid only inside a step: forces, and intermediate values of integrators. */
export interface Scratch {
  /** Force on each body, N; forces write it only during `accumulate`. */
  readonly force: AxisColumns;
  /** Torque on each body, N m; written during `accumulate` by forces with `appliesTorque`. In 2D only z is used. */
  readonly torque: AxisColumns;
  readonly at: {
    readonly force: AxisAddresses;
    readonly torque: AxisAddresses;
    /** Velocity at the start of the step. */
    readonly startVelocity: AxisAddresses;
    /** Free for use by the integrator. */
    readonly stage1: AxisAddresses;
    readonly stage2: AxisAddresses;
  };
}

const BUFFERS = ['force', 'startVelocity', 'stage1', 'stage2', 'torque'] as const;

/** Number of real columns of the scratch. */
export const SCRATCH_COLUMNS = BUFFERS.length * 3;

/** Allocates the scratch columns. */
export function createScratch(arena: Arena, precision: Precision, rows: number): Scratch {
  const made = BUFFERS.map((name) => axisColumns(arena, precision, rows, name));
  const [force, , , , torque] = made.map(([columns]) => columns);
  const at = Object.fromEntries(BUFFERS.map((name, i) => [name, made[i][1]]));
  return { force, torque, at } as Scratch;
}

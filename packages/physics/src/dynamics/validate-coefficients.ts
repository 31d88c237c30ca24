// Finds coefficients that user code has written out of the bounds of their component: a NaN mass would reach every body
// that it attracts, and a negative drag coefficient accelerates.
import { COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all.ts';
import type { ComponentSpec, RealColumn } from '../components/define.ts';
import { isOpen } from '../ecs/rows.ts';
import { reportFault } from '../errors/report-fault.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** A column, and the range of its values beside 0, which is the value of rows without the component. */
interface Coefficient {
  readonly component: ComponentName;
  readonly field: string;
  readonly min: number;
  readonly max: number;
  /** Whether other bodies read it too: then no value but 0 is harmless. */
  readonly isShared: boolean;
}

/** Components with checks of their own: the state of bodies, walls, and columns that physics does not read. */
const OTHER_CHECKS: readonly string[] = [
  'Position',
  'Velocity',
  'Rotation',
  'Orientation',
  'AngularVelocity',
  'SegmentWall',
  'PlaneWall',
  'Appearance',
  'Quarantined',
];

const SHARED: readonly string[] = ['Mass', 'Charge', 'Collider'];

/** The largest finite number of f32: a column of either precision holds it. */
const MAX_REAL = 3.4028234663852886e38;

const COEFFICIENTS: readonly Coefficient[] = /* @__PURE__ */ COMPONENT_NAMES.filter(
  (name) => !OTHER_CHECKS.includes(name),
).flatMap((component) =>
  Object.entries((COMPONENTS[component] as ComponentSpec).fields)
    .filter(([, { kind }]) => kind === 'real')
    .map(([field, { bounds }]) => {
      const { min = bounds.above ?? -MAX_REAL, max = MAX_REAL } = bounds;
      return { component, field, min, max, isShared: SHARED.includes(component) };
    }),
);

/** Steps in which all rows of a column are checked once, where a bad value stays with its own body. */
const ROUND = 64;

/**
 * Reports coefficients out of bounds and corrects them. If forces, the integrator or contacts couple bodies, every step
 * checks the columns that couple them. Of all other columns it checks one part in 64, so that an invalid value is found
 * within 64 steps; reading every column in every step would slow particles down by a third.
 */
export function validateCoefficients(world: PhysicsWorld): void {
  const { counts, sweptRows } = world.internal;
  const rowsPerStep = 16 * Math.ceil(sweptRows / 16 / ROUND);
  const start = rowsPerStep * (world.tick % ROUND);
  const isCoupled = couplesBodies(world);
  // A world of few bodies has nothing to check in most steps.
  if (start >= sweptRows && !isCoupled && counts.Engine === 0) return;
  for (let c = 0; c < COEFFICIENTS.length; c++) {
    const coefficient = COEFFICIENTS[c];
    if (counts[coefficient.component] === 0) continue;
    // A bad engine would burn its fuel within the step.
    const isUrgent = (isCoupled && coefficient.isShared) || coefficient.component === 'Engine';
    if (isUrgent) checkRows(world, coefficient, 0, sweptRows);
    else if (start < sweptRows) checkRows(world, coefficient, start, Math.min(start + rowsPerStep, sweptRows));
  }
}

function couplesBodies({ internal, integrator, phases }: PhysicsWorld): boolean {
  return internal.plan?.forcesLocal !== true || integrator.wholeWorld === true || phases.collide.length > 0;
}

function checkRows(world: PhysicsWorld, coefficient: Coefficient, first: number, last: number): void {
  const { component, field, min, max } = coefficient;
  const address = (world.addresses[component] as Readonly<Record<string, number>>)[field];
  if (world.kernels.isColumnWithin(address, min, max, first, last) === 0) correctRows(world, coefficient, first, last);
}

function correctRows(world: PhysicsWorld, coefficient: Coefficient, first: number, last: number): void {
  const { component, field, min, max } = coefficient;
  const column = (world.components[component] as Readonly<Record<string, RealColumn>>)[field];
  const { hint } = (COMPONENTS[component] as ComponentSpec).fields[field];
  for (let row = first; row < last; row++) {
    const value = column[row];
    if (value === 0 || (value >= min && value <= max)) continue;
    column[row] = nearestValid(value, coefficient);
    if (!isOpen(world, row, component)) continue;
    const code = Number.isFinite(value) ? 'E_RANGE' : 'E_NONFINITE';
    const described = hint === undefined ? {} : { hint };
    reportFault(world, { code, entity: row, field: `${component}.${field}`, value, phase: 'begin', ...described });
  }
}

/** Returns the nearest bound, or 0 for NaN, below a positive lower bound, and where other bodies read the value. */
function nearestValid(value: number, { min, max, isShared }: Coefficient): number {
  if (isShared || !Number.isFinite(value)) return 0;
  if (value > max) return max;
  return min > 0 ? 0 : min;
}

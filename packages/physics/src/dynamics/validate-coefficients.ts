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

/**
 * Components that are not in the list of others: those of the lists above, the state of bodies and walls, which have their
 * own checks, and columns that physics does not read.
 */
const CHECKED_ELSEWHERE: readonly string[] = [
  'Mass',
  'Charge',
  'Collider',
  'Engine',
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

/** The largest finite number of f32: a column of either precision holds it. */
const MAX_REAL = 3.4028234663852886e38;

/** The real fields of some components. */
function coefficientsOf(components: readonly ComponentName[], isShared: boolean): readonly Coefficient[] {
  return components.flatMap((component) =>
    Object.entries((COMPONENTS[component] as ComponentSpec).fields)
      .filter(([, { kind, bounds }]) => kind === 'real' && bounds.integer !== true)
      .map(([field, { bounds }]) => {
        const { min = bounds.above ?? -MAX_REAL, max = MAX_REAL } = bounds;
        return { component, field, min, max, isShared };
      }),
  );
}

const SHARED = /* @__PURE__ */ coefficientsOf(['Mass', 'Charge', 'Collider'], true);
/** A bad engine would burn its fuel within the step. */
const ENGINE = /* @__PURE__ */ coefficientsOf(['Engine'], false);
const OTHERS = /* @__PURE__ */ coefficientsOf(
  COMPONENT_NAMES.filter((name) => !CHECKED_ELSEWHERE.includes(name)),
  false,
);

/** Steps in which all rows of a column are checked once, where a bad value stays with its own body. */
const ROUND = 64;

/**
 * Reports coefficients out of bounds and corrects them. If forces, the integrator or contacts couple bodies, every step
 * checks the columns that couple them. Of all other columns it checks one part in 64, so that an invalid value is found
 * within 64 steps; reading every column in every step would slow particles down by a third.
 */
export function validateCoefficients(world: PhysicsWorld): void {
  const { sweptRows } = world.internal;
  const rowsPerStep = 16 * Math.ceil(sweptRows / 16 / ROUND);
  const start = rowsPerStep * (world.tick % ROUND);
  const end = Math.min(start + rowsPerStep, sweptRows);
  checkColumns(world, ENGINE, 0, sweptRows);
  if (couplesBodies(world)) checkColumns(world, SHARED, 0, sweptRows);
  else checkColumns(world, SHARED, start, end);
  checkColumns(world, OTHERS, start, end);
}

function couplesBodies({ internal, integrator, phases }: PhysicsWorld): boolean {
  return internal.plan?.forcesLocal !== true || integrator.wholeWorld === true || phases.collide.length > 0;
}

function checkColumns(world: PhysicsWorld, list: readonly Coefficient[], first: number, last: number): void {
  // A world of few bodies has no rows to check in most steps.
  if (first >= last) return;
  const { addresses, kernels, internal } = world;
  for (let c = 0; c < list.length; c++) {
    const { component, field, min, max } = list[c];
    if (internal.counts[component] === 0) continue;
    const address = (addresses[component] as Readonly<Record<string, number>>)[field];
    if (kernels.isColumnWithin(address, min, max, first, last) === 0) correctRows(world, list[c], first, last);
  }
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

// Finds coefficients that user code has written out of the bounds of their component: a NaN mass would reach every body
// that it attracts, and a negative drag coefficient accelerates.
import { COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all.ts';
import type { ComponentSpec, RealColumn } from '../components/define.ts';
import { isOpen } from '../ecs/rows.ts';
import { reportFault } from '../errors/report-fault.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** A component and those of its columns that are checked. */
interface Coefficients {
  readonly component: ComponentName;
  readonly columns: readonly Coefficient[];
}

/** A column, and the range of its values beside 0, which is the value of rows without the component. */
interface Coefficient {
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
function coefficientsOf(components: readonly ComponentName[], isShared: boolean): readonly Coefficients[] {
  return components.map((component) => ({
    component,
    columns: Object.entries((COMPONENTS[component] as ComponentSpec).fields)
      .filter(([, { kind, bounds }]) => kind === 'real' && bounds.integer !== true)
      .map(([field, { bounds }]) => {
        const { min = bounds.above ?? -MAX_REAL, max = MAX_REAL } = bounds;
        return { field, min, max, isShared };
      }),
  }));
}

const BODIES = /* @__PURE__ */ coefficientsOf(['Mass', 'Charge'], true);
/** Shapes attached to a body have a Collider too, in rows without a Position. */
const COLLIDERS = /* @__PURE__ */ coefficientsOf(['Collider'], true);
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
  const { internal, ranges } = world;
  const { sweptRows } = internal;
  const rowsPerStep = 16 * Math.ceil(sweptRows / 16 / ROUND);
  const start = rowsPerStep * (world.tick % ROUND);
  const end = Math.min(start + rowsPerStep, sweptRows);
  checkColumns(world, ENGINE, 0, sweptRows);
  if (couplesBodies(world)) {
    for (let r = 0; r < ranges.count; r++) checkColumns(world, BODIES, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
    checkColumns(world, COLLIDERS, 0, sweptRows);
  }
  checkColumns(world, BODIES, start, end);
  checkColumns(world, COLLIDERS, start, end);
  checkColumns(world, OTHERS, start, end);
}

function couplesBodies({ internal, integrator, phases }: PhysicsWorld): boolean {
  return internal.plan?.forcesLocal !== true || integrator.wholeWorld === true || phases.collide.length > 0;
}

function checkColumns(world: PhysicsWorld, list: readonly Coefficients[], first: number, last: number): void {
  // A world of few bodies has no rows to check in most steps.
  if (first >= last) return;
  const { addresses, kernels, internal } = world;
  for (let c = 0; c < list.length; c++) {
    const { component, columns } = list[c];
    if (internal.counts[component] === 0) continue;
    const at: Readonly<Record<string, number>> = addresses[component];
    for (let f = 0; f < columns.length; f++) {
      const { field, min, max } = columns[f];
      if (kernels.isColumnWithin(at[field], min, max, first, last) === 0) {
        correctRows(world, component, columns[f], first, last);
      }
    }
  }
}

function correctRows(
  world: PhysicsWorld,
  component: ComponentName,
  coefficient: Coefficient,
  first: number,
  last: number,
): void {
  const { field, min, max } = coefficient;
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

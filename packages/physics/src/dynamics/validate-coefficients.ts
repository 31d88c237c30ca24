// Finds coefficients that user code has written out of the bounds of their component: a NaN mass would reach every body
// that it attracts, and a negative drag coefficient accelerates.
import { COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all.ts';
import type { ComponentSpec, RealColumn } from '../components/define.ts';
import { isOpen } from '../ecs/rows.ts';
import { reportFault } from '../errors/report-fault.ts';
import { isStorable } from '../errors/validate.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
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

/** State of bodies and walls, which have their own checks, and columns that physics does not read. */
const CHECKED_ELSEWHERE: readonly ComponentName[] = [
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

/** Components by which bodies act on others. */
const SHARED: readonly ComponentName[] = ['Mass', 'Charge', 'Collider'];

/** The largest finite number of f32: a column of either precision holds it. */
const MAX_REAL = 3.4028234663852886e38;

/** The real fields of all components that are checked. */
const COEFFICIENTS: readonly Coefficients[] = /* @__PURE__ */ COMPONENT_NAMES.filter(
  (name) => !CHECKED_ELSEWHERE.includes(name),
).map((component) => ({ component, columns: coefficientsOf(component) }));

function coefficientsOf(component: ComponentName): readonly Coefficient[] {
  const isShared = SHARED.includes(component);
  return Object.entries((COMPONENTS[component] as ComponentSpec).fields)
    .filter(([, { kind, bounds }]) => kind === 'real' && bounds.integer !== true)
    .map(([field, { bounds }]) => {
      const { min = bounds.above ?? -MAX_REAL, max = MAX_REAL } = bounds;
      return { field, min, max, isShared };
    });
}

/**
 * Where a bad value stays with its own body, a step checks a sixteenth of the rows in an eighth of the components: everything
 * once in 128 steps. A 128th of the rows in every component would take twice the time, because each piece of a column begins
 * anew.
 */
const PARTS = 16;
const GROUPS = 8;

/** What is checked in a world, without the components that nothing has: most worlds use few of them. */
interface Watch {
  /** The version of membership for which the lists were made, and that of the world's past: a restore takes the former back. */
  membership: number;
  restored: number;
  /** Engines, where a bad value would burn fuel within the step. */
  readonly engine: Coefficients[];
  /** Columns by which bodies are coupled: a bad value would reach other bodies within the step. */
  readonly coupling: Coefficients[];
  /** All but engines. */
  readonly all: Coefficients[];
}

const watchOf = cachedWithPlan((): Watch => ({ membership: -1, restored: -1, engine: [], coupling: [], all: [] }));

/** The columns by which the forces, the integrator or contacts couple bodies. */
const coupledBy = cachedWithPlan(({ forces, integrator, phases }): readonly Coefficients[] => {
  const readers = [
    ...(integrator.wholeWorld === true ? [{}] : []),
    ...forces.filter(({ local }) => !local),
    ...phases.collide,
  ] as readonly { readonly readsOfOthers?: readonly string[] }[];
  const reads = new Set(readers.flatMap(({ readsOfOthers = SHARED }) => readsOfOthers));
  return COEFFICIENTS.map(({ component, columns }) => ({
    component,
    columns: columns.filter(({ field }) => reads.has(component) || reads.has(`${component}.${field}`)),
  })).filter(({ columns }) => columns.length > 0);
});

/**
 * Reports coefficients out of bounds and corrects them; Infinity becomes the bound where that stands for it. Every step checks those
 * by which bodies are coupled. Of the others it checks a 128th, so that an invalid value is found within 128 steps; reading every
 * column in every step would slow particles down by a third.
 */
export function validateCoefficients(world: PhysicsWorld): void {
  const { engine, coupling, all } = currentWatch(world);
  const { sweptRows } = world.internal;
  const group = world.tick % GROUPS;
  const rowsPerStep = 16 * Math.ceil(sweptRows / 16 / PARTS);
  const start = rowsPerStep * (Math.floor(world.tick / GROUPS) % PARTS);
  const end = Math.min(start + rowsPerStep, sweptRows);
  for (let c = 0; c < engine.length; c++) checkColumns(world, engine[c], 0, sweptRows);
  for (let c = 0; c < coupling.length; c++) checkCoupling(world, coupling[c]);
  // A world of few bodies has no rows to check in most steps.
  if (start >= end) return;
  for (let c = group; c < all.length; c += GROUPS) checkColumns(world, all[c], start, end);
}

function currentWatch(world: PhysicsWorld): Watch {
  const watch = watchOf(world);
  const { membership, restored } = world.versions;
  if (watch.membership === membership && watch.restored === restored) return watch;
  watch.membership = membership;
  watch.restored = restored;
  const coupled = coupledBy(world);
  const { engine, coupling, all } = watch;
  engine.length = coupling.length = all.length = 0;
  for (const each of COEFFICIENTS) {
    const { component } = each;
    if (world.internal.counts[component] === 0) continue;
    (component === 'Engine' ? engine : all).push(each);
  }
  for (const each of coupled) if (world.internal.counts[each.component] > 0) coupling.push(each);
  return watch;
}

/** Checks all rows in which a body may have the component. */
function checkCoupling(world: PhysicsWorld, coefficients: Coefficients): void {
  const { ranges, internal } = world;
  if (coefficients.component === 'Collider') {
    // Shapes attached to a body have a Collider in rows without a Position.
    checkColumns(world, coefficients, 0, internal.sweptRows);
    return;
  }
  for (let r = 0; r < ranges.count; r++) {
    checkColumns(world, coefficients, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  }
}

function checkColumns(world: PhysicsWorld, { component, columns }: Coefficients, first: number, last: number): void {
  const { addresses, kernels } = world;
  const at: Readonly<Record<string, number>> = addresses[component];
  for (let f = 0; f < columns.length; f++) {
    const { field, min, max } = columns[f];
    if (kernels.isColumnWithin(at[field], min, max, first, last) === 0) {
      correctRows(world, component, columns[f], first, last);
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
  const { field, max } = coefficient;
  const column = (world.components[component] as Readonly<Record<string, RealColumn>>)[field];
  const { hint, infinite } = (COMPONENTS[component] as ComponentSpec).fields[field];
  for (let row = first; row < last; row++) {
    const value = column[row];
    // The kernel compares in the precision of the column, in which a bound may be rounded to beyond itself.
    if (value === 0 || isStorable(value, coefficient)) continue;
    const isStored = value === Infinity && infinite === max;
    column[row] = isStored ? max : nearestValid(value, coefficient);
    if (isStored || !isOpen(world, row, component)) continue;
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

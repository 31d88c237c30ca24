// Restricts a force to some bodies, a region or a time: fuel in a zone, wind in a corridor, a switched magnet.
//
// Inside its limits the force is unchanged; outside it is zero. This works with every force, also with forces that
// read the sum of those before them. A law remains a law with a condition, and is fused into the step. The
// contribution of other forces outside the limits is undone exactly. Resources consumed at the start of a step, such
// as fuel, are consumed only inside the limits.
//
// Limits of time are rounded to the stages of a step: switched on or off within a step, a force gives an impulse that is off by at most
// one step of it, F dt (two with `yoshida4`, one and a half with `yoshida6` and `positionVerlet`). `dormandPrince` and `gaussRadau` take
// sub-steps at the jump and are off by less than a tenth of a step; they may report E_STEP there.
//
// A force of pairs, such as springs or mutual gravity, that is restricted to a group or a region acts on those ends of its pairs
// that are within, so that neither momentum nor energy is kept; a warning says so. Restricted in time it is whole.
//
// Potential: a force restricted in time has its potential only within that time. A local force restricted to a group
// has the potential of the group, because bodies without coefficients have none. A force restricted to a region has
// no potential: energy changes at its border. Cost: one to seven comparisons per body for a law; two copies of the
// force columns and a test per body for another force.
import { COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all.ts';
import { bitsOf } from '../components/membership.ts';
import type { LawForce } from '../dynamics/sum-of-laws.ts';
import { ownBit } from '../ecs/own-components.ts';
import { allocate } from '../memory/arena.ts';
import { realAddresses, realBytes } from '../memory/columns.ts';
import { forceMemory, type TakeBytes } from '../memory/force-memory.ts';
import { LIMITS_BYTES, LimitsNumber, LimitsWord } from '../memory/layouts.gen.ts';
import { recordAt } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import { checkForce } from '../world/execution-plan.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { forceKernels } from './support/force-kernels.ts';
import { restrictedLaw } from './support/restricted-law.ts';
import {
  type CheckedRestrictions,
  checkRestrictions,
  namesInGroup,
  type Restrictions,
} from './support/restrictions.ts';

/** Saved force and torque columns, one set per nesting level of restricted forces. */
const savesOf = namedResource('saved forces', (): number[][] => []);
let depth = 0;

/**
 * Restricts a force to bodies with a component, to a region or to a time. Restricted to a region it has no potential: what it
 * does is missing from `energy(world)`.
 * Times `from` and `until`, s, are rounded to the stages of a step: the impulse is off by at most F dt, one step of the force (two
 * with `yoshida4`, one and a half with `yoshida6` and `positionVerlet`), with `dormandPrince` and `gaussRadau` by less than a tenth
 * of that, though they may report E_STEP at the jump.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN; E_CAPACITY from a step when the world has no room
 */
export function restrictForce(force: Force, limits: Restrictions): Force {
  checkForce(force, 'restrictForce: force');
  const checked = checkRestrictions(limits);
  const { of: limitsAt, release } = forceMemory((world, take) => writeLimits(world, take, checked));
  const releaseMemory = (world: PhysicsWorld) => {
    release(world);
    force.releaseMemory?.(world);
  };
  const prepare = prepareWithin(force, checked, limitsAt);
  const reads = [...new Set([...force.reads, ...namesInGroup(checked)])];
  if (force.law !== undefined)
    return { ...restrictedLaw(force as LawForce, checked), reads, ...prepare, releaseMemory };
  return {
    ...force,
    name: `${force.name} (restricted)`,
    reads,
    ...prepare,
    releaseMemory,
    accumulate(world, first, last, time) {
      // A step has one torque, that of its last evaluation, so it is decided by the start of the step, as fuel is.
      const isPerStep = force.consumes !== undefined || force.appliesTorque === true;
      const decisionTime = isPerStep ? world.time : time;
      if (decisionTime < checked.from || decisionTime >= checked.until) return;
      if (isUnlimited(checked)) force.accumulate?.(world, first, last, time);
      else accumulateWithin(world, force, limitsAt(world), first, last, time);
    },
    ...potentialWithin(force, checked, limitsAt),
  };
}

function isUnlimited({ group, box, ball }: CheckedRestrictions): boolean {
  return group.length === 0 && box === undefined && ball === undefined;
}

/** Runs the preparation and undoes what it consumed outside the limits. */
function prepareWithin(
  force: Force,
  limits: CheckedRestrictions,
  limitsAt: (world: PhysicsWorld) => number,
): Pick<Force, 'prepare'> {
  const { consumes } = force;
  if (force.prepare === undefined || consumes === undefined) {
    const hasOwn = namesInGroup(limits).length < limits.group.length;
    return hasOwn && force.law === undefined ? prepareGroup(force, limitsAt) : {};
  }
  return {
    prepare(world, dt) {
      if (world.time < limits.from || world.time >= limits.until) return;
      if (isUnlimited(limits)) {
        force.prepare?.(world, dt);
        return;
      }
      const columns = columnsOf(world, consumes);
      const saves = savedColumns(world, columns.length);
      const rows = world.lastId + 1;
      for (let i = 0; i < columns.length; i++) world.kernels.copyColumn(saves[i], columns[i], 0, rows);
      try {
        force.prepare?.(world, dt);
      } finally {
        const at = limitsAt(world);
        for (let i = 0; i < columns.length; i++) forceKernels(world).restoreOutside(at, columns[i], saves[i], 0, rows);
      }
    },
  };
}

/** Finds out before anything moves whether the world has the components of the user in the group; laws do when compiled. */
function prepareGroup(force: Force, limitsAt: (world: PhysicsWorld) => number): Pick<Force, 'prepare'> {
  return {
    prepare(world, dt) {
      limitsAt(world);
      force.prepare?.(world, dt);
    },
  };
}

const consumedColumns = namedResource('consumed columns', () => new Map<readonly ComponentName[], number[]>());

/** Returns the addresses of all real columns of the given components. */
function columnsOf(world: PhysicsWorld, consumed: readonly ComponentName[]): readonly number[] {
  const columnsByNames = consumedColumns(world);
  let columns = columnsByNames.get(consumed);
  if (columns === undefined) {
    columns = consumed.flatMap((name) => realAddresses(world.addresses, name));
    columnsByNames.set(consumed, columns);
  }
  return columns;
}

function accumulateWithin(
  world: PhysicsWorld,
  force: Force,
  limits: number,
  first: number,
  last: number,
  time: number,
): void {
  const { kernels, scratch } = world;
  const { force: f, torque: t } = scratch.at;
  const hasTorque = force.appliesTorque === true;
  const saves = savedColumns(world, hasTorque ? 6 : 3);
  for (let a = 0; a < 3; a++) {
    kernels.copyColumn(saves[a], f[SPACE[a]], first, last);
    if (hasTorque) kernels.copyColumn(saves[a + 3], t[SPACE[a]], first, last);
  }
  depth++;
  try {
    force.accumulate?.(world, first, last, time);
  } finally {
    depth--;
    const laws = forceKernels(world);
    for (let a = 0; a < 3; a++) {
      laws.restoreOutside(limits, f[SPACE[a]], saves[a], first, last);
      if (hasTorque) laws.restoreOutside(limits, t[SPACE[a]], saves[a + 3], first, last);
    }
  }
}

const SPACE = ['x', 'y', 'z'] as const;

function savedColumns(world: PhysicsWorld, count: number): readonly number[] {
  const saves = savesOf(world);
  saves[depth] ??= [];
  const columns = saves[depth];
  const bytes = world.rows * realBytes(world.precision);
  while (columns.length < count) {
    columns.push(allocate(world.internal.arena, bytes, 'a restricted force'));
  }
  return columns;
}

function potentialWithin(
  force: Force,
  limits: CheckedRestrictions,
  limitsAt: (world: PhysicsWorld) => number,
): Pick<Force, 'potential'> {
  const { potential } = force;
  const isRegion = limits.box !== undefined || limits.ball !== undefined;
  const groupOnly = limits.group.length > 0 && !isRegion;
  if (potential === undefined || isRegion || (groupOnly && !force.local)) {
    return { potential: undefined } as unknown as Pick<Force, 'potential'>;
  }
  return {
    potential(world) {
      if (world.time < limits.from || world.time >= limits.until) return 0;
      return groupOnly ? potentialOfGroup(world, force, limitsAt(world)) : potential(world);
    },
  };
}

/** Sets the coefficients of all other bodies to zero while the potential is evaluated. */
function potentialOfGroup(world: PhysicsWorld, force: Force, limits: number): number {
  const { components, addresses, internal } = world;
  const laws = forceKernels(world);
  const saved: [{ set(values: ArrayLike<number>): void }, ArrayLike<number>][] = [];
  for (const name of COMPONENT_NAMES) {
    if (!force.reads.includes(name) || name === 'Position' || internal.counts[name] === 0) continue;
    for (const [field, spec] of Object.entries(COMPONENTS[name].fields)) {
      if (spec.kind !== 'real') continue;
      const column = (components[name] as Record<string, Float64Array>)[field].subarray(0, world.lastId + 1);
      saved.push([column, column.slice()]);
      laws.zeroOutside(limits, (addresses[name] as Record<string, number>)[field], 0, world.lastId + 1);
    }
  }
  try {
    return force.potential?.(world) ?? 0;
  } finally {
    for (const [column, values] of saved) column.set(values);
  }
}

function writeLimits(world: PhysicsWorld, take: TakeBytes, limits: CheckedRestrictions): number {
  const { group, box, ball } = limits;
  const required = bitsOf(namesInGroup(limits));
  const own = group.map((component) => (typeof component === 'string' ? 0 : ownBit(world, component)));
  const { at, numbers, words } = recordAt(world.memory, take(LIMITS_BYTES, 'limits'), LIMITS_BYTES);
  const isFlat = world.dimensions === 2;
  // In 2D a region has no depth: a centre has z = 0, and a box is unbounded in z.
  if (ball !== undefined) {
    const { x, y, z } = ball.centre;
    numbers.set([x, y, isFlat ? 0 : z, ball.radius * ball.radius], LimitsNumber.ax);
  } else if (box !== undefined) {
    const { min, max } = box;
    numbers.set([min.x, min.y, isFlat ? -Infinity : min.z], LimitsNumber.ax);
    numbers.set([max.x, max.y, isFlat ? Infinity : max.z], LimitsNumber.bx);
  }
  words[LimitsWord.kind] = ball !== undefined ? 2 : box !== undefined ? 1 : 0;
  words[LimitsWord.group] = required.first;
  words[LimitsWord.moreGroup] = own.reduce((bits, bit) => bits | bit, required.second);
  words[LimitsWord.moreMembers] = world.internal.moreMembersAt;
  return at;
}

// A force for some bodies, some places or some time only: fuel in a region, wind in a corridor, a magnet that switches.
//
// Inside its limits the force is what it was; outside, there is none. Works with every force, and one that reads the
// forces before it still does. A law stays a law, under a condition, and is fused into the step. Of other forces, what
// they added outside is taken back, to the bit. What a force spends at the start of a step, such as fuel, it spends inside
// its limits only.
//
// Potential: a force limited in time has its own inside that time and none outside. A local force limited to a group has
// the potential of that group, because bodies without its coefficients have none. A force limited to a region has no
// potential: energy changes at the border. Cost: of a law, one to seven comparisons a body; of another force, two copies of
// the force columns and a test a body.
import { COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all.ts';
import type { LawForce } from '../dynamics/sum-of-laws.ts';
import { allocate } from '../memory/arena.ts';
import { realAddresses, realBytes } from '../memory/columns.ts';
import { LIMITS_BYTES, LimitsNumber, LimitsWord } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { resource } from '../memory/resource.ts';
import { checkForce } from '../world/execution-plan.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { forceKernels } from './support/force-kernels.ts';
import { restrictedLaw } from './support/restricted-law.ts';
import { type CheckedRestrictions, checkRestrictions, type Restrictions } from './support/restrictions.ts';

/** Columns that hold the force and torque from before, one set for each restricted force inside another. */
const savesOf = resource((): number[][] => []);
let depth = 0;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN; E_CAPACITY from a step when the world has no room */
export function restrictForce(force: Force, limits: Restrictions): Force {
  checkForce(force, 'restrictForce: force');
  const checked = checkRestrictions(limits);
  const limitsAt = resource((world) => writeLimits(world, checked));
  const prepare = prepareWithin(force, checked, limitsAt);
  if (force.law !== undefined) return { ...restrictedLaw(force as LawForce, checked), ...prepare };
  return {
    ...force,
    name: `${force.name} (restricted)`,
    ...prepare,
    accumulate(world, first, last, time) {
      // What was spent at the start of a step drives the whole of it.
      const moment = force.consumes === undefined ? time : world.time;
      if (moment < checked.from || moment >= checked.until) return;
      if (isEverywhere(checked)) force.accumulate?.(world, first, last, time);
      else accumulateWithin(world, force, limitsAt(world), first, last, time);
    },
    ...potentialWithin(force, checked, limitsAt),
  };
}

function isEverywhere({ group, box, ball }: CheckedRestrictions): boolean {
  return group === 0 && box === undefined && ball === undefined;
}

/** The whole preparation, but of what is spent outside the limits nothing is. */
function prepareWithin(
  force: Force,
  limits: CheckedRestrictions,
  limitsAt: (world: PhysicsWorld) => number,
): Pick<Force, 'prepare'> {
  const { consumes } = force;
  if (force.prepare === undefined || consumes === undefined) return {};
  return {
    prepare(world, dt) {
      if (world.time < limits.from || world.time >= limits.until) return;
      if (isEverywhere(limits)) {
        force.prepare?.(world, dt);
        return;
      }
      const columns = spentOf(world, consumes);
      const saves = savesAt(world, columns.length);
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

const spentColumns = resource(() => new Map<readonly ComponentName[], number[]>());

/** Addresses of all real columns of some components. */
function spentOf(world: PhysicsWorld, spends: readonly ComponentName[]): readonly number[] {
  const known = spentColumns(world);
  let columns = known.get(spends);
  if (columns === undefined) {
    columns = spends.flatMap((name) => realAddresses(world.addresses, name));
    known.set(spends, columns);
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
  const turns = force.appliesTorque === true;
  const saves = savesAt(world, turns ? 6 : 3);
  for (let a = 0; a < 3; a++) {
    kernels.copyColumn(saves[a], f[SPACE[a]], first, last);
    if (turns) kernels.copyColumn(saves[a + 3], t[SPACE[a]], first, last);
  }
  depth++;
  try {
    force.accumulate?.(world, first, last, time);
  } finally {
    depth--;
    const laws = forceKernels(world);
    for (let a = 0; a < 3; a++) {
      laws.restoreOutside(limits, f[SPACE[a]], saves[a], first, last);
      if (turns) laws.restoreOutside(limits, t[SPACE[a]], saves[a + 3], first, last);
    }
  }
}

const SPACE = ['x', 'y', 'z'] as const;

function savesAt(world: PhysicsWorld, count: number): readonly number[] {
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
  const groupOnly = limits.group !== 0 && !isRegion;
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

/** The coefficients of all other bodies are put away while the potential is asked for. */
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

function writeLimits(world: PhysicsWorld, { group, box, ball }: CheckedRestrictions): number {
  const { at, numbers, words } = allocateRecord(world.internal.arena, LIMITS_BYTES, 'limits');
  const isFlat = world.dimensions === 2;
  // In the plane a region has no depth: a centre lies in it, a box is open.
  if (ball !== undefined) {
    const { x, y, z } = ball.centre;
    numbers.set([x, y, isFlat ? 0 : z, ball.radius * ball.radius], LimitsNumber.ax);
  } else if (box !== undefined) {
    const { min, max } = box;
    numbers.set([min.x, min.y, isFlat ? -Infinity : min.z], LimitsNumber.ax);
    numbers.set([max.x, max.y, isFlat ? Infinity : max.z], LimitsNumber.bx);
  }
  words[LimitsWord.kind] = ball !== undefined ? 2 : box !== undefined ? 1 : 0;
  words[LimitsWord.group] = group;
  return at;
}

// A force for some bodies, some places or some time only: fuel in a region, wind in a corridor, a magnet that switches.
//
// Inside its limits the force is what it was; outside, the force and torque it added are taken back, to the bit. Works
// with every force: local ones run in tiles as before, and one that reads the forces before it still does. What a force
// spends at the start of a step, such as fuel, it spends inside its limits only.
//
// Potential: a force limited in time has its own inside that time and none outside. A local force limited to a group has
// the potential of that group, because bodies without its coefficients have none. A force limited to a region has no
// potential: energy changes at the border. Cost: two copies of the force columns and a test a body.
import { bitOf, COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all';
import { PhysicsError } from '../faults/physics-error';
import { checkHas, checkKeys, checkNumber, checkVector, type VectorInput } from '../faults/validate';
import { allocate } from '../store/arena';
import { realAddresses, realBytes } from '../store/columns';
import { resource } from '../store/resource';
import type { PhysicsWorld } from '../world';
import { LENGTHS, PLACES } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';

/** A box, or a ball (a disc in 2D). Axes left out of a box are not limited. */
export type Region =
  | { readonly min: VectorInput; readonly max: VectorInput }
  | { readonly centre: VectorInput; readonly radius: number };

export interface Limits {
  /** Only bodies that have this component, or all of these. */
  readonly group?: ComponentName | readonly ComponentName[];
  /** Only bodies whose centre is here. */
  readonly region?: Region;
  /** Only from this time on, s. */
  readonly from?: number;
  /** Only before this time, s. */
  readonly until?: number;
}

/** Bytes of a record of limits, kernels/forces/limited.ts. */
const LIMITS_BYTES = 56;

/** Columns that hold the force and torque from before, one set for each limited force inside another. */
const savesOf = resource((): number[][] => []);
let depth = 0;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN; E_CAPACITY from a step when the world has no room */
export function limited(force: Force, limits: Limits): Force {
  checkHas(force, 'accumulate', 'limited: force', 'Such as uniformGravity() or defineForce({ … }).');
  checkKeys(limits, 'limited', ['group', 'region', 'from', 'until']);
  const from = limits.from === undefined ? -Infinity : checkNumber(limits.from, 'limited.from');
  const until = limits.until === undefined ? Infinity : checkNumber(limits.until, 'limited.until');
  const group = groupBits(limits.group);
  const region = limits.region === undefined ? undefined : regionNumbers(limits.region);
  const limitsAt = resource((world) => writeLimits(world, region, group));
  const everywhere = group === 0 && region === undefined;
  return {
    ...force,
    name: `${force.name} (limited)`,
    timeless: force.timeless === true && from === -Infinity && until === Infinity,
    ...prepareWithin(force, from, until, everywhere, limitsAt),
    accumulate(world, first, last, time) {
      // What was spent at the start of a step drives the whole of it.
      const moment = force.spends === undefined ? time : world.time;
      if (moment < from || moment >= until) return;
      if (everywhere) force.accumulate(world, first, last, time);
      else accumulateWithin(world, force, limitsAt(world), first, last, time);
    },
    ...potentialWithin(force, limits, from, until, limitsAt),
  };
}

/** The whole preparation, but of what is spent outside the limits nothing is. */
function prepareWithin(
  force: Force,
  from: number,
  until: number,
  everywhere: boolean,
  limitsAt: (world: PhysicsWorld) => number,
): Pick<Force, 'prepare'> {
  const { spends } = force;
  if (force.prepare === undefined || spends === undefined) return {};
  return {
    prepare(world, dt) {
      if (world.time < from || world.time >= until) return;
      if (everywhere) {
        force.prepare?.(world, dt);
        return;
      }
      const columns = spentOf(world, spends);
      const saves = savesAt(world, columns.length);
      const rows = world.lastId + 1;
      for (let i = 0; i < columns.length; i++) world.kernels.copyColumn(saves[i], columns[i], 0, rows);
      try {
        force.prepare?.(world, dt);
      } finally {
        const limits = limitsAt(world);
        for (let i = 0; i < columns.length; i++)
          lawKernels(world).restoreOutside(limits, columns[i], saves[i], 0, rows);
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
    columns = spends.flatMap((name) => realAddresses(world, name));
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
  const turns = force.turns === true;
  const saves = savesAt(world, turns ? 6 : 3);
  for (let a = 0; a < 3; a++) {
    kernels.copyColumn(saves[a], f[SPACE[a]], first, last);
    if (turns) kernels.copyColumn(saves[a + 3], t[SPACE[a]], first, last);
  }
  depth++;
  try {
    force.accumulate(world, first, last, time);
  } finally {
    depth--;
    const laws = lawKernels(world);
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
    columns.push(allocate(world.internal.arena, bytes, 'a limited force'));
  }
  return columns;
}

function potentialWithin(
  force: Force,
  limits: Limits,
  from: number,
  until: number,
  limitsAt: (world: PhysicsWorld) => number,
): Pick<Force, 'potential'> {
  const { potential } = force;
  const groupOnly = limits.group !== undefined && limits.region === undefined;
  if (potential === undefined || limits.region !== undefined || (groupOnly && !force.local)) {
    return { potential: undefined } as unknown as Pick<Force, 'potential'>;
  }
  return {
    potential(world) {
      if (world.time < from || world.time >= until) return 0;
      return groupOnly ? potentialOfGroup(world, force, limitsAt(world)) : potential(world);
    },
  };
}

/** The coefficients of all other bodies are put away while the potential is asked for. */
function potentialOfGroup(world: PhysicsWorld, force: Force, limits: number): number {
  const { components, addresses, internal } = world;
  const laws = lawKernels(world);
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

function groupBits(group: Limits['group']): number {
  if (group === undefined) return 0;
  let bits = 0;
  for (const name of typeof group === 'string' ? [group] : group) {
    if (!COMPONENT_NAMES.includes(name)) {
      throw new PhysicsError('E_UNKNOWN', `limited.group names no component "${String(name)}".`, {
        field: 'group',
        value: name,
        hint: `Valid: ${COMPONENT_NAMES.join(', ')}.`,
      });
    }
    bits |= bitOf(name);
  }
  return bits >>> 0;
}

/** Kind, and the six numbers of it. */
function regionNumbers(region: Region): readonly number[] {
  if ('radius' in region) {
    checkKeys(region, 'limited.region', ['centre', 'radius']);
    const { x, y, z } = checkVector(region.centre, 'limited.region.centre', PLACES);
    const radius = checkNumber(region.radius, 'limited.region.radius', LENGTHS);
    return [2, x, y, z, radius * radius, 0, 0];
  }
  checkKeys(region, 'limited.region', ['min', 'max']);
  checkVector(region.min, 'limited.region.min', PLACES);
  checkVector(region.max, 'limited.region.max', PLACES);
  const { x: x0 = -Infinity, y: y0 = -Infinity, z: z0 = -Infinity } = region.min;
  const { x: x1 = Infinity, y: y1 = Infinity, z: z1 = Infinity } = region.max;
  if (x0 > x1 || y0 > y1 || z0 > z1) {
    throw new PhysicsError('E_RANGE', 'limited.region is empty: a corner `min` lies beyond `max`.', {
      field: 'region',
      value: region,
    });
  }
  return [1, x0, y0, z0, x1, y1, z1];
}

function writeLimits(world: PhysicsWorld, region: readonly number[] | undefined, group: number): number {
  const at = allocate(world.internal.arena, LIMITS_BYTES, 'limits');
  const [kind = 0, ...numbers] = region ?? [];
  // In the plane a region has no depth: a centre lies in it, a box is open.
  if (world.dimensions === 2 && kind === 2) numbers[2] = 0;
  if (world.dimensions === 2 && kind === 1) [numbers[2], numbers[5]] = [-Infinity, Infinity];
  new Float64Array(world.memory.buffer, at, 6).set(numbers);
  new Uint32Array(world.memory.buffer, at + 48, 2).set([kind, group]);
  return at;
}

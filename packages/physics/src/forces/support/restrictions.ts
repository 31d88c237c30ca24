// What a force can be limited to, checked.
import { bitOf, COMPONENT_NAMES, type ComponentName } from '../../components/all.ts';
import { PhysicsError } from '../../errors/physics-error.ts';
import { checkKeys, checkNumber, checkVector, type Vector, type VectorInput } from '../../errors/validate.ts';
import { LENGTHS, PLACES } from './bounds.ts';

/** A box, or a ball (a disc in 2D). Axes left out of a box are not limited. */
export type Region = Box | Ball;

interface Box {
  readonly min: VectorInput;
  readonly max: VectorInput;
}

interface Ball {
  readonly centre: VectorInput;
  readonly radius: number;
}

export interface Restrictions {
  /** Only bodies that have this component, or all of these. */
  readonly group?: ComponentName | readonly ComponentName[];
  /** Only bodies whose centre is here. */
  readonly region?: Region;
  /** Only from this time on, s. */
  readonly from?: number;
  /** Only before this time, s. */
  readonly until?: number;
}

/** Limits that were checked. */
export interface CheckedRestrictions {
  /** Bits of the components that a body needs: zero for all bodies. */
  readonly group: number;
  readonly box?: { readonly min: Vector; readonly max: Vector };
  readonly ball?: { readonly centre: Vector; readonly radius: number };
  /** s; -∞ and ∞ where there is no limit. */
  readonly from: number;
  readonly until: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function checkRestrictions(limits: Restrictions): CheckedRestrictions {
  checkKeys(limits, 'restrictForce', ['group', 'region', 'from', 'until']);
  const { from, until, region } = limits;
  return {
    group: groupBits(limits.group),
    ...(region === undefined ? {} : 'radius' in region ? { ball: checkBall(region) } : { box: checkBox(region) }),
    from: from === undefined ? -Infinity : checkNumber(from, 'restrictForce.from'),
    until: until === undefined ? Infinity : checkNumber(until, 'restrictForce.until'),
  };
}

function groupBits(group: Restrictions['group']): number {
  if (group === undefined) return 0;
  let bits = 0;
  for (const name of typeof group === 'string' ? [group] : group) {
    if (!COMPONENT_NAMES.includes(name)) {
      throw new PhysicsError('E_UNKNOWN', `restrictForce.group names no component "${String(name)}".`, {
        field: 'group',
        value: name,
        hint: `Valid: ${COMPONENT_NAMES.join(', ')}.`,
      });
    }
    bits |= bitOf(name);
  }
  return bits >>> 0;
}

function checkBall(region: Ball): NonNullable<CheckedRestrictions['ball']> {
  checkKeys(region, 'restrictForce.region', ['centre', 'radius']);
  return {
    centre: checkVector(region.centre, 'restrictForce.region.centre', PLACES),
    radius: checkNumber(region.radius, 'restrictForce.region.radius', LENGTHS),
  };
}

function checkBox(region: Box): NonNullable<CheckedRestrictions['box']> {
  checkKeys(region, 'restrictForce.region', ['min', 'max']);
  checkVector(region.min, 'restrictForce.region.min', PLACES);
  checkVector(region.max, 'restrictForce.region.max', PLACES);
  const min = { x: -Infinity, y: -Infinity, z: -Infinity, ...region.min };
  const max = { x: Infinity, y: Infinity, z: Infinity, ...region.max };
  if (min.x > max.x || min.y > max.y || min.z > max.z) {
    throw new PhysicsError('E_RANGE', 'restrictForce.region is empty: a corner `min` lies beyond `max`.', {
      field: 'region',
      value: region,
    });
  }
  return { min, max };
}

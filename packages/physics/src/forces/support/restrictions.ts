// The validated limits of a restricted force.
import { COMPONENT_NAMES, type ComponentName } from '../../components/all.ts';
import { type ComponentSpec, isComponent } from '../../components/define.ts';
import { describe, PhysicsError } from '../../errors/physics-error.ts';
import { checkKeys, checkNumber, checkVector, mustBe, type Vector, type VectorInput } from '../../errors/validate.ts';
import { componentName } from '../../laws/body-symbols.ts';
import { LENGTH_BOUNDS, POSITION_BOUNDS } from './bounds.ts';

/** A box, or a ball (a disc in 2D). Omitted axes of a box are unlimited. */
export type Region = Box | Ball;

interface Box {
  readonly min: VectorInput;
  readonly max: VectorInput;
}

interface Ball {
  readonly centre: VectorInput;
  readonly radius: number;
}

/** A component of the package by its name, one of your own by its definition. */
type GroupComponent = ComponentName | ComponentSpec;

/** Where, when and on which bodies a force of `restrictForce` acts. */
export interface Restrictions {
  /**
   * Only bodies with this component, or with all of these: names such as 'Charge', or components that `defineComponent`
   * made and the world was created with. Default all bodies.
   */
  readonly group?: GroupComponent | readonly GroupComponent[];
  /** Only bodies whose centre is in this region. Default everywhere. */
  readonly region?: Region;
  /**
   * Only from this time on, s; a force that applies torque or consumes fuel, only in steps that begin then. Default
   * from the beginning.
   */
  readonly from?: number;
  /**
   * Only before this time, s; a force that applies torque or consumes fuel, only in steps that begin before. Default
   * for ever.
   */
  readonly until?: number;
}

/** Validated limits. */
export interface CheckedRestrictions {
  /** The required components: none for all bodies. */
  readonly group: readonly GroupComponent[];
  readonly box?: { readonly min: Vector; readonly max: Vector };
  readonly ball?: { readonly centre: Vector; readonly radius: number };
  /** Time limits, s; -∞ and ∞ if unlimited. */
  readonly from: number;
  readonly until: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function checkRestrictions(limits: Restrictions): CheckedRestrictions {
  checkKeys(limits, 'restrictForce', ['group', 'region', 'from', 'until']);
  const { from, until, region } = limits;
  return {
    group: checkGroup(limits.group),
    ...(region === undefined ? {} : 'radius' in region ? { ball: checkBall(region) } : { box: checkBox(region) }),
    from: from === undefined ? -Infinity : withRounding(checkNumber(from, 'restrictForce.from')),
    until: until === undefined ? Infinity : withRounding(checkNumber(until, 'restrictForce.until')),
  };
}

/**
 * Fraction of a time by which the sum of a hundred thousand steps is off at most: 300 steps of 1/60 s add up to less than
 * 5 s, and a force until 5 s would act in one step more.
 */
const ROUNDING = 2 ** -36;

/** A time limit, less what the sum of steps may fall short of it. */
function withRounding(time: number): number {
  return time - ROUNDING * Math.abs(time);
}

function checkGroup(group: Restrictions['group'] = []): readonly GroupComponent[] {
  return Array.isArray(group) ? group.map(checkMember) : [checkMember(group)];
}

function checkMember(member: unknown): GroupComponent {
  if (isComponent(member)) return componentName(member) ?? member;
  if (typeof member !== 'string') {
    const expected = 'the name of a component, a component made by defineComponent, or a list of these';
    throw mustBe(expected, member, 'restrictForce.group');
  }
  const name = COMPONENT_NAMES.find((known) => known === member);
  if (name !== undefined) return name;
  throw new PhysicsError('E_UNKNOWN', `restrictForce.group: ${describe(member)} is not a component.`, {
    field: 'group',
    value: member,
    hint: `Valid names: ${COMPONENT_NAMES.join(', ')}.`,
  });
}

/** The components of the package that the group asks for. */
export function namesInGroup({ group }: CheckedRestrictions): ComponentName[] {
  return group.filter((component) => typeof component === 'string');
}

function checkBall(region: Ball): NonNullable<CheckedRestrictions['ball']> {
  checkKeys(region, 'restrictForce.region', ['centre', 'radius']);
  return {
    centre: checkVector(region.centre, 'restrictForce.region.centre', POSITION_BOUNDS),
    radius: checkNumber(region.radius, 'restrictForce.region.radius', LENGTH_BOUNDS),
  };
}

function checkBox(region: Box): NonNullable<CheckedRestrictions['box']> {
  checkKeys(region, 'restrictForce.region', ['min', 'max']);
  checkVector(region.min, 'restrictForce.region.min', POSITION_BOUNDS);
  checkVector(region.max, 'restrictForce.region.max', POSITION_BOUNDS);
  const min = { x: -Infinity, y: -Infinity, z: -Infinity, ...region.min };
  const max = { x: Infinity, y: Infinity, z: Infinity, ...region.max };
  if (min.x > max.x || min.y > max.y || min.z > max.z) {
    throw new PhysicsError(
      'E_RANGE',
      'restrictForce.region is empty: `min` exceeds `max` on an axis. Give min ≤ max on every axis.',
      {
        field: 'region',
        value: region,
      },
    );
  }
  return { min, max };
}

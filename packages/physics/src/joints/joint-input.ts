// Converts the options that all joints share to fields of the component Joint, and validates them.
import { MAX_CAPACITY } from '../ecs/entity-ref.ts';
import { checkFlag, checkKeys, checkNumber, checkVector, checkWhole, type VectorInput } from '../errors/validate.ts';

/** Bounds of the free coordinate of a joint, m or rad; one that is left out is not there. */
export interface JointLimits {
  readonly lower?: number;
  readonly upper?: number;
}

/** A damped spring along the free coordinate. */
export interface JointSpring {
  /** Frequency, Hz. */
  readonly hertz: number;
  /** 1 is critical; default 1. */
  readonly dampingRatio?: number;
}

/** A motor along the free coordinate. */
export interface JointMotor {
  /** Speed that it keeps, m/s or rad/s. */
  readonly speed: number;
  /** Largest force, N, or torque, N m. */
  readonly max: number;
}

/** The options of every joint. */
export interface JointOptions {
  /** The bodies, by id; one of them may be static. */
  readonly a: number;
  readonly b: number;
  /** Whether the two bodies collide with each other; default false. */
  readonly collide?: boolean;
  /** Force at which the joint breaks, N; default never. */
  readonly breakForce?: number;
}

/** A described joint, for `createJoint`. */
export interface JointInput {
  readonly kind: number;
  readonly a: number;
  readonly b: number;
  /** Points of both bodies, m, in world coordinates. Without one it is the centre of its body. */
  readonly anchorA: VectorInput | undefined;
  readonly anchorB: VectorInput | undefined;
  /** Direction along which b moves, in world coordinates. */
  readonly axis: VectorInput | undefined;
  /** Other fields of the component. */
  readonly fields: Readonly<Record<string, number>>;
}

/** The options of some joints. */
interface AllOptions extends JointOptions {
  readonly anchor?: VectorInput;
  readonly anchorA?: VectorInput;
  readonly anchorB?: VectorInput;
  readonly axis?: VectorInput;
  readonly length?: number;
  readonly limits?: JointLimits;
  readonly spring?: JointSpring;
  readonly motor?: JointMotor;
}

/** The kinds of joints, as in kernels/joints/2d/joint-table.ts. */
const JOINT_KINDS = { revolute: 0, distance: 1, weld: 2, prismatic: 3, wheel: 4 } as const;

/** A free coordinate without a limit on one side. */
const UNLIMITED = 1e12;

/**
 * Checks the options of a joint and collects its fields.
 * @param names the options that this joint takes besides those of every joint
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function describeJoint(
  caller: keyof typeof JOINT_KINDS,
  options: AllOptions,
  names: readonly (keyof AllOptions)[],
): JointInput {
  checkKeys(options, caller, ['a', 'b', 'collide', 'breakForce', ...names]);
  for (const name of ['a', 'b'] as const) checkWhole(options[name], `${caller}.${name}`, 1, MAX_CAPACITY);
  const { anchor, limits, spring, motor, length, breakForce, collide } = options;
  for (const name of ['anchor', 'anchorA', 'anchorB', 'axis'] as const) {
    if (options[name] !== undefined) checkVector(options[name], `${caller}.${name}`);
  }
  const fields: Record<string, number> = {};
  const take = (field: string, value: number | undefined, name: string, min = 0) => {
    if (value !== undefined) fields[field] = checkNumber(value, `${caller}.${name}`, { min, max: 1e12 });
  };
  take('length', length, 'length');
  take('breakForce', breakForce, 'breakForce');
  fields.collide = Number(checkFlag(collide ?? false, `${caller}.collide`));
  if (limits !== undefined) {
    checkKeys(limits, `${caller}.limits`, ['lower', 'upper']);
    fields.hasLimits = 1;
    take('lower', limits.lower ?? -UNLIMITED, 'limits.lower', -UNLIMITED);
    take('upper', limits.upper ?? UNLIMITED, 'limits.upper', -UNLIMITED);
  }
  if (spring !== undefined) {
    checkKeys(spring, `${caller}.spring`, ['hertz', 'dampingRatio']);
    take('hertz', spring.hertz, 'spring.hertz');
    take('dampingRatio', spring.dampingRatio, 'spring.dampingRatio');
  }
  if (motor !== undefined) {
    checkKeys(motor, `${caller}.motor`, ['speed', 'max']);
    take('motorSpeed', motor.speed, 'motor.speed', -1e9);
    take('maxMotor', motor.max, 'motor.max');
  }
  const { a, b, anchorA = anchor, anchorB = anchor, axis } = options;
  return { kind: JOINT_KINDS[caller], a, b, anchorA, anchorB, axis, fields };
}

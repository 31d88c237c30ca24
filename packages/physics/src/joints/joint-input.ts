// Converts the options that all joints share to fields of the component Joint, and validates them.
import { JOINT_KINDS } from '../components/joint.ts';
import { MAX_CAPACITY } from '../ecs/entity-ref.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import {
  checkFlag,
  checkKeys,
  checkNumber,
  checkPoint,
  checkVector,
  checkWhole,
  type VectorInput,
} from '../errors/validate.ts';

/** Bounds of the free coordinate of a joint, m or rad; one that is left out is not there. */
export interface JointLimits {
  /** The least value; default none. */
  readonly lower?: number;
  /** The greatest value; default none. */
  readonly upper?: number;
}

/** A damped spring along the free coordinate. */
export interface JointSpring {
  /** Frequency, Hz; from a twelfth of the rate of sub-steps on, 20 Hz by default, the spring loses energy by itself, and very fast ones are less stiff. */
  readonly hertz: number;
  /** 1 is critical; default 1. */
  readonly dampingRatio?: number;
}

/** The spring of a distance joint. */
export interface DistanceSpring extends JointSpring {
  /** Largest force, N; default any. */
  readonly maxForce?: number;
  /** Largest force with which it pushes, N; default `maxForce`. With 0 it is an elastic cord: it only pulls, and hangs slack when shorter. */
  readonly maxCompression?: number;
}

/** A motor along the free coordinate. */
export interface JointMotor {
  /** Speed that it keeps, m/s or rad/s. With 0 it is friction: it brakes by at most `max`, and what hangs on it comes to rest. */
  readonly speed: number;
  /**
   * Largest force, N, or torque, N m, up to 10¹². Limits of the joint hold any motor; contacts give way, by 14 mm to a hundred times the
   * weight of what it moves, and a thousand times and more may go through walls: stop such a motor by limits.
   */
  readonly max: number;
}

/** The options of joints that may hold b to the world. */
export interface JointOptions extends EveryJointOptions {
  /** The first body, by id, which may be static. Default the world: b is joined to it. */
  readonly a?: number;
}

/** The options of every joint. */
export interface EveryJointOptions {
  /** The second body, by id. */
  readonly b: number;
  /** Whether the two bodies collide with each other; default false. */
  readonly collide?: boolean;
  /** Force at which the joint breaks, N; default never. */
  readonly breakForce?: number;
  /** Torque at which the joint breaks, N m; default never. */
  readonly breakTorque?: number;
}

/** A described joint, for `createJoint`. */
export interface JointInput {
  readonly kind: number;
  /** 0 for the world. */
  readonly a: number;
  readonly b: number;
  /** Points of both bodies, m, in world coordinates. Without one it is the centre of its body. */
  readonly anchorA: VectorInput | undefined;
  readonly anchorB: VectorInput | undefined;
  /** Direction along which b moves, in world coordinates. */
  readonly axis: VectorInput | undefined;
  /** Wheels of a pulley, m, in world coordinates. */
  readonly pulleyA: VectorInput | undefined;
  readonly pulleyB: VectorInput | undefined;
  /** Other fields of the component. */
  readonly fields: Readonly<Record<string, number>>;
}

/** The options of some joints. */
interface AllOptions extends JointOptions {
  readonly anchor?: VectorInput;
  readonly anchorA?: VectorInput;
  readonly anchorB?: VectorInput;
  readonly target?: VectorInput;
  readonly axis?: VectorInput;
  readonly pulleyA?: VectorInput;
  readonly pulleyB?: VectorInput;
  readonly ratio?: number;
  readonly length?: number;
  readonly turn?: number;
  readonly maxForce?: number;
  readonly maxTorque?: number;
  readonly angularSpeed?: number;
  readonly limits?: JointLimits;
  readonly spring?: DistanceSpring;
  readonly motor?: JointMotor;
}

/** The options that are points or directions. */
const POINTS = ['anchor', 'anchorA', 'anchorB', 'target', 'axis', 'pulleyA', 'pulleyB'] as const;

/** A free coordinate without a limit on one side. */
const UNLIMITED = 1e12;

/** The options that are numbers: the field that each sets, and its least value. */
const NUMBERS = [
  ['length', 'length', 0],
  ['ratio', 'ratio', -1e6],
  ['turn', 'angle', -1e6],
  ['maxForce', 'maxForce', 0],
  ['maxTorque', 'maxMotor', 0],
  ['angularSpeed', 'motorSpeed', -1e9],
  ['breakForce', 'breakForce', 0],
  ['breakTorque', 'breakTorque', 0],
] as const;

/** The joints that couple two bodies, and so need both. */
const PAIRS: readonly string[] = ['pulley', 'gear', 'filterJoint'];

/** The options that a joint cannot do without, besides the bodies. */
const REQUIRED: Readonly<Partial<Record<keyof typeof KINDS, readonly (keyof AllOptions)[]>>> = {
  revolute: ['anchor'],
  weld: ['anchor'],
  prismatic: ['anchor', 'axis'],
  wheel: ['anchor'],
  // A motor without a limit would be a weld.
  motorJoint: ['maxForce', 'maxTorque'],
  mouseJoint: ['target', 'maxForce'],
  pulley: ['pulleyA', 'pulleyB'],
  gear: ['ratio'],
};

/** The kind of joint that each function describes. */
const KINDS = {
  revolute: 'revolute',
  distance: 'distance',
  weld: 'weld',
  prismatic: 'prismatic',
  wheel: 'wheel',
  motorJoint: 'motor',
  mouseJoint: 'motor',
  pulley: 'pulley',
  gear: 'gear',
  filterJoint: 'filter',
} as const satisfies Record<string, (typeof JOINT_KINDS)[number]>;

/**
 * Checks the options of a joint and collects its fields.
 * @param names the options that this joint takes besides those of every joint
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function describeJoint(
  caller: keyof typeof KINDS,
  options: AllOptions,
  names: readonly (keyof AllOptions)[],
): JointInput {
  checkKeys(options, caller, ['a', 'b', 'collide', 'breakForce', 'breakTorque', ...names]);
  checkWhole(options.b, `${caller}.b`, 1, MAX_CAPACITY);
  if (options.a !== undefined || PAIRS.includes(caller)) checkWhole(options.a, `${caller}.a`, 1, MAX_CAPACITY);
  const required = REQUIRED[caller] ?? [];
  for (const name of POINTS) {
    if (options[name] === undefined && !required.includes(name)) continue;
    if (name === 'axis') checkVector(options.axis, `${caller}.axis`);
    else checkPoint(options[name], `${caller}.${name}`);
  }
  checkMeaning(caller, options);
  const { a = 0, b, anchor, anchorA = options.target ?? anchor, anchorB = anchor, axis, pulleyA, pulleyB } = options;
  return {
    kind: JOINT_KINDS.indexOf(KINDS[caller]),
    a,
    b,
    anchorA,
    anchorB,
    axis,
    pulleyA,
    pulleyB,
    fields: fieldsOf(caller, options, required),
  };
}

/** Refuses an axis without a direction, and ratios that couple nothing. */
function checkMeaning(caller: string, { axis, ratio }: AllOptions): void {
  if (axis !== undefined && (axis.x ?? 0) === 0 && (axis.y ?? 0) === 0)
    throw new PhysicsError('E_RANGE', `${caller}.axis must have a direction, and its x and y are 0.`, {
      field: `${caller}.axis`,
    });
  if (ratio === 0 || (caller === 'pulley' && ratio !== undefined && ratio < 0))
    throw new PhysicsError(
      'E_RANGE',
      `${caller}.ratio must be ${caller === 'pulley' ? 'above' : 'other than'} 0, got ${ratio}.`,
      { field: `${caller}.ratio` },
    );
}

function fieldsOf(
  caller: string,
  options: AllOptions,
  required: readonly (keyof AllOptions)[],
): Record<string, number> {
  const { limits, spring, motor, collide } = options;
  const fields: Record<string, number> = {};
  const take = (field: string, value: number | undefined, name: string, min = 0, isRequired = false) => {
    if (value !== undefined || isRequired) fields[field] = checkNumber(value, `${caller}.${name}`, { min, max: 1e12 });
  };
  for (const [name, field, min] of NUMBERS) take(field, options[name], name, min, required.includes(name));
  fields.collide = Number(checkFlag(collide ?? false, `${caller}.collide`));
  if (limits !== undefined) {
    checkKeys(limits, `${caller}.limits`, ['lower', 'upper']);
    fields.hasLimits = 1;
    take('lower', limits.lower ?? -UNLIMITED, 'limits.lower', -UNLIMITED);
    take('upper', limits.upper ?? UNLIMITED, 'limits.upper', -UNLIMITED);
  }
  if (spring !== undefined) {
    const bounds = caller === 'distance' ? ['maxForce', 'maxCompression'] : [];
    checkKeys(spring, `${caller}.spring`, ['hertz', 'dampingRatio', ...bounds]);
    take('hertz', spring.hertz, 'spring.hertz', 0, true);
    take('dampingRatio', spring.dampingRatio, 'spring.dampingRatio');
    take('maxForce', spring.maxForce, 'spring.maxForce');
    take('maxCompression', spring.maxCompression, 'spring.maxCompression');
  }
  if (motor !== undefined) {
    checkKeys(motor, `${caller}.motor`, ['speed', 'max']);
    take('motorSpeed', motor.speed, 'motor.speed', -1e9, true);
    take('maxMotor', motor.max, 'motor.max', 0, true);
  }
  return fields;
}

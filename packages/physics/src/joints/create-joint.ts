// Joints as entities. What a joint does is in kernels/joints/2d.
import { warnAboutJoint } from '#warnings';
import { bodyOf } from '../bodies/parts.ts';
import { despawn, spawn } from '../bodies/spawn.ts';
import { JOINT_KINDS } from '../components/joint.ts';
import { assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { isRecord, mustBe, type VectorInput } from '../errors/validate.ts';
import { atan2, cos, sin } from '../math/elementary.ts';
import {
  JointImpulsesNumber as Impulses,
  JOINT_IMPULSES_BYTES,
  JointTableWord as Word,
} from '../memory/layouts.gen.ts';
import { placeParts } from '../solver/refresh-parts.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { assertJoint } from './assert-joint.ts';
import type { JointInput } from './joint-input.ts';
import { type EndedJoints, endedOf, jointTable } from './joint-table.ts';

/**
 * Joins two rigid bodies in their present poses. The joint is an entity with the component Joint, whose limits, spring and motor
 * may be changed at any time; `despawn` removes it, and it goes when one of its bodies goes. A part of a compound body stands
 * for its body: without an anchor the joint is at the part.
 * @param joint made by `revolute`, `distance`, `weld`, `prismatic`, `wheel`, `pulley`, `gear`, `motorJoint`, `mouseJoint` or
 *   `filterJoint`
 * @returns the entity id of the joint
 * @throws PhysicsError E_STALE for a body that is not there; E_TYPE, E_RANGE, E_CAPACITY, E_DESTROYED
 */
export function createJoint(world: PhysicsWorld, joint: JointInput): number {
  assertUsable(world);
  if (!isRecord(joint) || !isRecord(joint.fields))
    throw mustBe('made by a function such as revolute()', joint, 'joint');
  if (!isSoftStep(world.integrator)) {
    throw new PhysicsError('E_RANGE', 'joints join rigid bodies, and this world has none.', {
      field: 'joint',
      hint: 'Make the world with `preset: rigidBodies`.',
    });
  }
  placeParts(world);
  const a = joint.a === 0 ? 0 : bodyOf(world, joint.a);
  const b = bodyOf(world, joint.b);
  const values = valuesOf(world, joint, a, b);
  const id = spawn(world, { joint: values });
  warnAboutJoint(world, values, id);
  return id;
}

/** @param a body, or 0 for the world @param b body; `joint` names these, or parts of theirs */
function valuesOf(world: PhysicsWorld, joint: JointInput, a: number, b: number): Record<string, number> {
  const { kind, axis, fields, ...points } = joint;
  const angles = world.components.Rotation.angle;
  const anchorB = placeOf(world, joint.b, points.anchorB);
  // The world has no centre: a body that is joined to it is held where it is, and so is one that a motor joint drives.
  const isHeld = (a === 0 || kind === MOTOR) && points.anchorA === undefined;
  const anchorA = isHeld ? anchorB : placeOf(world, joint.a, points.anchorA);
  const localA = toLocal(world, a, anchorA);
  const localB = toLocal(world, b, anchorB);
  const values: Record<string, number> = {
    kind,
    b,
    ax: localA.x,
    ay: localA.y,
    bx: localB.x,
    by: localB.y,
    length: distanceBetween(anchorA, anchorB),
    ...fields,
    angle: angles[b] - angles[a] + (fields.angle ?? 0),
  };
  if (a !== 0) values.a = a;
  const direction = axis === undefined ? 0 : atan2(axis.y ?? 0, axis.x ?? 0);
  if (kind === GEAR)
    return { ...values, ...gearValues(world, a, b, axis === undefined ? undefined : direction, fields) };
  if (kind === PULLEY) return { ...values, ...pulleyValues(anchorA, anchorB, points, fields) };
  if (axis !== undefined) values.axis = direction - angles[a];
  return values;
}

const GEAR = JOINT_KINDS.indexOf('gear');
const PULLEY = JOINT_KINDS.indexOf('pulley');
const MOTOR = JOINT_KINDS.indexOf('motor');

/** The coordinate of a gear joint is 0 as the bodies are now. An axis makes b a rack, which moves along it. */
function gearValues(
  { components }: PhysicsWorld,
  a: number,
  b: number,
  axis: number | undefined,
  { ratio = 1 }: JointInput['fields'],
): Record<string, number> {
  const { Position, Rotation } = components;
  const start = -ratio * Rotation.angle[a];
  if (axis === undefined) return { angle: Rotation.angle[b] + start };
  return { isRack: 1, axis, angle: cos(axis) * Position.x[b] + sin(axis) * Position.y[b] + start };
}

/** The rope is as long as it is now, unless its length is given. */
function pulleyValues(
  anchorA: Point,
  anchorB: Point,
  { pulleyA, pulleyB }: Pick<JointInput, 'pulleyA' | 'pulleyB'>,
  { ratio = 1, length }: JointInput['fields'],
): Record<string, number> {
  const { x: pulleyAx = 0, y: pulleyAy = 0 } = pulleyA ?? {};
  const { x: pulleyBx = 0, y: pulleyBy = 0 } = pulleyB ?? {};
  const ropeA = distanceBetween(anchorA, { x: pulleyAx, y: pulleyAy });
  const ropeB = distanceBetween(anchorB, { x: pulleyBx, y: pulleyBy });
  return { pulleyAx, pulleyAy, pulleyBx, pulleyBy, length: length ?? ropeA + ratio * ropeB };
}

function placeOf({ components }: PhysicsWorld, body: number, point: VectorInput | undefined) {
  const { x, y } = components.Position;
  return point === undefined ? { x: x[body], y: y[body] } : { x: point.x ?? 0, y: point.y ?? 0 };
}

type Point = { readonly x: number; readonly y: number };

function distanceBetween(a: Point, b: Point): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  return Math.sqrt(dx * dx + dy * dy);
}

function toLocal({ components }: PhysicsWorld, body: number, point: Point): Point {
  if (body === 0) return point;
  const { Position, Rotation } = components;
  const dx = point.x - Position.x[body];
  const dy = point.y - Position.y[body];
  const c = cos(Rotation.angle[body]);
  const s = sin(Rotation.angle[body]);
  return { x: c * dx + s * dy, y: c * dy - s * dx };
}

/** Returns the joints that ended by themselves: always the same object. @throws PhysicsError E_DESTROYED */
export function endedJoints(world: PhysicsWorld): EndedJoints {
  return endedOf(world);
}

/** Removes the joints whose force was above `breakForce`, when the step ends. */
export function breakJoints(world: PhysicsWorld): void {
  const { broken } = endedOf(world);
  if (broken.length > 0) broken.length = 0;
  if (world.internal.counts.Joint === 0) return;
  const { words } = jointTable(world);
  const ids = new Uint32Array(world.memory.buffer, words[Word.broken], words[Word.brokenCount]).sort();
  for (const id of ids) {
    broken.push(id);
    despawn(world, id);
  }
}

/**
 * Returns the largest force that a joint exerted in the last step, N: of its locked directions, spring, motor and limits.
 * A pulley with a ratio pulls its two bodies differently: this is the force on b. Before its first step it is 0.
 * @throws PhysicsError E_STALE when there is no joint with this id, E_DESTROYED
 */
export function jointForce(world: PhysicsWorld, joint: number): number {
  return exerted(world, joint, Impulses.force);
}

/**
 * Returns the largest torque that a joint exerted in the last step, N m, about its anchor. Before its first step it is 0.
 * @throws PhysicsError E_STALE when there is no joint with this id, E_DESTROYED
 */
export function jointTorque(world: PhysicsWorld, joint: number): number {
  return exerted(world, joint, Impulses.torque);
}

function exerted(world: PhysicsWorld, joint: number, number: Impulses): number {
  assertJoint(world, joint);
  // What stands there until its first step is that of a joint which had its id before.
  if (world.components.Joint.started[joint] === 0) return 0;
  const { words } = jointTable(world);
  const at = words[Word.impulses] + JOINT_IMPULSES_BYTES * joint;
  return new Float64Array(world.memory.buffer, at, JOINT_IMPULSES_BYTES / 8)[number];
}

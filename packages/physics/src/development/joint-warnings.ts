// Warnings about joints that are made where they cannot stay.
import { JOINT_KINDS } from '../components/joint.ts';
import { warnOnce } from '../errors/warn-once.ts';
import { cos, sin } from '../math/elementary.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { firstRow, isKinematic } from './first-row.ts';

/** A joint may begin this far beyond its limits, m or rad: bodies are often placed by eye. */
const LIMIT_TOLERANCE = 0.05;

type Values = Readonly<Record<string, number>>;

/** Joints that have had a motor or limits: they may be turned off and on. */
const switched = new WeakMap<PhysicsWorld, { readonly motors: Set<number>; readonly limits: Set<number> }>();

function switchedOf(world: PhysicsWorld) {
  const found = switched.get(world) ?? { motors: new Set(), limits: new Set() };
  switched.set(world, found);
  return found;
}

/** Warns about a new joint. */
export function warnAboutJoint(world: PhysicsWorld, joint: Values, id: number): void {
  const { motors, limits } = switchedOf(world);
  const note = (set: Set<number>, has: boolean) => (has ? set.add(id) : set.delete(id));
  note(motors, joint.maxMotor > 0);
  note(limits, joint.hasLimits === 1);
  warnAboutLimits(world, joint);
  warnAboutDegrees(world, joint);
}

/** Whole numbers beyond a turn are surely degrees. */
function warnAboutDegrees(world: PhysicsWorld, { kind, hasLimits, lower, upper }: Values): void {
  if (JOINT_KINDS[kind] !== 'revolute' || hasLimits !== 1) return;
  const isDegrees = (limit: number) =>
    Number.isInteger(limit) && Math.abs(limit) > 2 * Math.PI && limit > -1e6 && limit < 1e6;
  const limit = [lower, upper].find(isDegrees);
  if (limit === undefined) return;
  const warning = {
    message: `a hinge has the limit ${limit} rad, ${Math.round(Math.abs(limit) / (2 * Math.PI))} turns, which looks like degrees.`,
    hint: `Angles are in radians: ${limit} degrees are ${Number(((limit * Math.PI) / 180).toPrecision(4))} rad.`,
  };
  warnOnce(world, warning, 'degrees');
}

/** Warns about joints that hold nothing that moves. Called when bodies or components came or went. */
export function warnAboutJoints(world: PhysicsWorld): void {
  if (world.internal.counts.Joint === 0) return;
  const { members } = world.internal;
  const { Joint, Mass } = world.components;
  const isDriven = (id: number) => !(Mass.value[id] > 0) || isKinematic(world, id);
  const isIdle = (id: number) => Joint.b[id] > 0 && isDriven(Joint.a[id]) && isDriven(Joint.b[id]);
  const filter = JOINT_KINDS.indexOf('filter');
  const idle = firstRow(world, (id) => isIdle(id) && Joint.kind[id] !== filter && (members[Joint.b[id]] & 1) === 1);
  if (idle === 0) return;
  const warning = {
    message: `joint ${idle} moves nothing, because neither of its bodies has a mass that forces can move.`,
    hint: 'Give one a mass, as by `collider: { density: 100 }`.',
  };
  warnOnce(world, warning, 'idle joint');
}

/** Fields that have no effect without another, which turns them on. */
export function warnAboutStrayFields(world: PhysicsWorld): void {
  const { Joint } = world.components;
  const { motors, limits } = switchedOf(world);
  const check = (on: ArrayLike<number>, known: Set<number>, isStray: (id: number) => boolean) => {
    const joint = firstRow(world, (id) => {
      if (on[id] > 0) known.add(id);
      return isStray(id) && !known.has(id);
    });
    return Joint.b[joint] > 0 ? joint : 0;
  };
  const motor = check(Joint.maxMotor, motors, (id) => Joint.motorSpeed[id] !== 0);
  if (motor > 0) {
    const message = `Joint.motorSpeed of joint ${motor} has no effect, because the joint has no motor.`;
    const hint = 'Make the joint with `motor: { speed: 0, max: 10 }`, or write Joint.maxMotor as well.';
    warnOnce(world, { message, hint }, 'no motor');
  }
  const bounded = check(Joint.hasLimits, limits, (id) => Joint.lower[id] !== 0 || Joint.upper[id] !== 0);
  if (bounded === 0) return;
  const message = `Joint.lower and Joint.upper of joint ${bounded} have no effect, because the joint has no limits.`;
  const hint = 'Make the joint with `limits: { lower: -1, upper: 1 }`, or write 1 to Joint.hasLimits as well.';
  warnOnce(world, { message, hint }, 'no limits');
}

/** Warns about limits that were written to the columns and leave no place between them: `createJoint` refuses them. */
export function warnAboutCrossedLimits(world: PhysicsWorld): void {
  const { b, hasLimits, lower, upper } = world.components.Joint;
  const joint = firstRow(world, (id) => lower[id] > upper[id] && hasLimits[id] === 1 && b[id] > 0);
  if (joint === 0) return;
  const message = `Joint.lower of joint ${joint} is ${lower[joint]}, above Joint.upper, which is ${upper[joint]}: no place is within such limits.`;
  warnOnce(world, { message, hint: 'Swap the two, or write 0 to Joint.hasLimits.' }, 'crossed limits');
}

/** Warns if a new joint begins beyond its limits: the solver pulls it there in the next steps. */
function warnAboutLimits(world: PhysicsWorld, joint: Values): void {
  const kind = JOINT_KINDS[joint.kind];
  const isDistance = kind === 'distance';
  const now = isDistance ? anchorDistance(world, joint) : 0;
  if (isDistance && joint.hasLimits !== 1 && !(joint.hertz > 0)) warnAboutLength(world, now, joint.length);
  if (joint.hasLimits !== 1) return;
  const isBelow = now < joint.lower - LIMIT_TOLERANCE;
  if (!isBelow && now <= joint.upper + LIMIT_TOLERANCE) return;
  const limit = isBelow ? `less than its lower limit, ${joint.lower}` : `more than its upper limit, ${joint.upper}`;
  const place = isDistance ? `anchors are ${Number(now.toPrecision(3))} m apart` : 'coordinate is 0';
  const warning = {
    message: `a ${kind} joint was made beyond its limits: its ${place}, ${limit}. It is pulled there in the next steps.`,
    hint: isDistance
      ? 'Put the bodies where the limits hold before you join them.'
      : 'The coordinate of a joint is 0 as its bodies are when it is made: let the limits include 0.',
  };
  warnOnce(world, warning, `limits of a ${kind} joint`);
}

function warnAboutLength(world: PhysicsWorld, now: number, length: number): void {
  if (Math.abs(now - length) <= LIMIT_TOLERANCE) return;
  const warning = {
    message: `a rod of ${length} m was made between anchors that are ${Number(now.toPrecision(3))} m apart. It is brought to its length in the next steps.`,
    hint: 'Put the bodies at that distance before you join them, or leave `length` out.',
  };
  warnOnce(world, warning, 'length of a rod');
}

/** The distance of the anchors of a joint that is about to be made, m. */
function anchorDistance({ components }: PhysicsWorld, joint: Readonly<Record<string, number>>): number {
  const place = (body: number, x: number, y: number) => {
    if (body === 0) return [x, y];
    const angle = components.Rotation.angle[body];
    const [c, s] = [cos(angle), sin(angle)];
    return [components.Position.x[body] + c * x - s * y, components.Position.y[body] + s * x + c * y];
  };
  const [ax, ay] = place(joint.a ?? 0, joint.ax, joint.ay);
  const [bx, by] = place(joint.b, joint.bx, joint.by);
  return Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
}

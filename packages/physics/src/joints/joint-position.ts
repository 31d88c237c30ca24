// Where a joint is along or about the one direction that it leaves free.
import { JOINT_KINDS } from '../components/joint.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { cos, sin } from '../math/elementary.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { assertJoint } from './assert-joint.ts';

type JointKind = (typeof JOINT_KINDS)[number];

export type JointCoordinate = 'angle' | 'along the axis' | 'distance';

/** What limits, springs and motors of a kind of joint act on. */
const COORDINATES: Readonly<Record<JointKind, JointCoordinate | undefined>> = {
  revolute: 'angle',
  distance: 'distance',
  weld: 'angle',
  prismatic: 'along the axis',
  wheel: 'along the axis',
  motor: undefined,
  pulley: undefined,
  gear: undefined,
  filter: undefined,
};

/**
 * Returns the coordinate that limits and motors of a joint act on: of `revolute` and `weld` the angle of b from a, rad, 0 as the
 * bodies were when they were joined; of `prismatic` and `wheel` the distance along the axis, m; of `distance` that of its
 * anchors, m.
 * @throws PhysicsError E_STALE when there is no joint with this id, E_RANGE for a joint of another kind, E_DESTROYED
 */
export function jointPosition(world: PhysicsWorld, joint: number): number {
  assertJoint(world, joint);
  const kind = JOINT_KINDS[world.components.Joint.kind[joint]];
  const coordinate = COORDINATES[kind];
  if (coordinate === undefined) throw withoutPosition(joint, kind);
  return positionAlong(world, joint, coordinate);
}

/** What limits, springs and motors of a joint act on, if it has one such coordinate. */
export function coordinateOf(world: PhysicsWorld, joint: number): JointCoordinate | undefined {
  return COORDINATES[JOINT_KINDS[world.components.Joint.kind[joint]]];
}

/** Where a joint is along or about its coordinate, m or rad. */
export function positionAlong(world: PhysicsWorld, joint: number, coordinate: JointCoordinate): number {
  const { Joint, Rotation } = world.components;
  const [a, b] = [Joint.a[joint], Joint.b[joint]];
  if (coordinate === 'angle') return Rotation.angle[b] - Rotation.angle[a] - Joint.angle[joint];
  const { x, y } = betweenAnchors(world, joint);
  if (coordinate === 'distance') return Math.sqrt(x * x + y * y);
  const direction = Rotation.angle[a] + Joint.axis[joint];
  return x * cos(direction) + y * sin(direction);
}

function withoutPosition(joint: number, kind: JointKind): PhysicsError {
  const others = JOINT_KINDS.filter((name) => COORDINATES[name] !== undefined);
  return new PhysicsError('E_RANGE', `joint ${joint}, a ${kind} joint, has no position along or about one direction.`, {
    entity: joint,
    field: 'joint',
    value: joint,
    hint: `Ask a joint of one of these kinds: ${others.join(', ')}.`,
  });
}

/** The vector from the anchor of a to that of b, m. */
function betweenAnchors(world: PhysicsWorld, joint: number) {
  const { a, b, ax, ay, bx, by } = world.components.Joint;
  const from = toWorld(world, a[joint], ax[joint], ay[joint]);
  const to = toWorld(world, b[joint], bx[joint], by[joint]);
  return { x: to.x - from.x, y: to.y - from.y };
}

/** A point given in the frame of a body, or of the world, row 0. */
function toWorld({ components: { Position, Rotation } }: PhysicsWorld, body: number, x: number, y: number) {
  const [c, s] = [cos(Rotation.angle[body]), sin(Rotation.angle[body])];
  return { x: Position.x[body] + c * x - s * y, y: Position.y[body] + s * x + c * y };
}

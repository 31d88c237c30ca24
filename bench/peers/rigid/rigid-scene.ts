// A world of rigid bodies as plain data, from which other engines build the same scene.
import { type PhysicsWorld, type Shape, shapeAt } from '@principia/physics';
import type { RigidRun, SceneRun } from '@principia/scenes';
import { hasComponent, Not, query } from 'bitecs';

export interface RigidBodyData {
  /** Position of the centre of mass, m. */
  readonly x: number;
  readonly y: number;
  readonly angle: number;
  readonly vx: number;
  readonly vy: number;
  /** Angular velocity, rad/s. */
  readonly w: number;
  /** Mass, kg, and moment of inertia, kg m²; both 0 for a body that does not move. */
  readonly mass: number;
  readonly inertia: number;
  /** Whether it moves without a mass, as its velocity says. */
  readonly isKinematic: boolean;
  /** None for a body without a collider, several for a compound. */
  readonly shapes: readonly RigidShapeData[];
}

export interface RigidShapeData extends Pick<Shape, 'kind' | 'vertices' | 'radius'> {
  /** Pose in the frame of the body, m and rad. */
  readonly x: number;
  readonly y: number;
  readonly angle: number;
  readonly friction: number;
  readonly restitution: number;
  readonly collides: boolean;
}

export interface RigidJointData {
  readonly kind: 'revolute' | 'weld';
  /** Indices of the bodies. */
  readonly a: number;
  readonly b: number;
  /** Anchors in the frames of the bodies, m. */
  readonly ax: number;
  readonly ay: number;
  readonly bx: number;
  readonly by: number;
  /** Angle of b from a at which the joint's angle is 0. */
  readonly angle: number;
  /** Largest torque of the motor, N m, 0 for none, and its speed, rad/s. */
  readonly maxTorque: number;
  readonly speed: number;
}

export interface RigidSceneData {
  /** Downward acceleration, m/s². */
  readonly gravity: number;
  readonly bodies: readonly RigidBodyData[];
  readonly joints: readonly RigidJointData[];
}

/** The kinds of shapes that all peers have. */
const PLAIN: readonly Shape['kind'][] = ['circle', 'polygon'];

const JOINT_KINDS: Readonly<Record<number, RigidJointData['kind']>> = { 0: 'revolute', 2: 'weld' };

/** Reads a run; undefined where it holds what the peers do not build: chains, capsules, other joints. */
export function readRigidScene(run: SceneRun): RigidSceneData | undefined {
  const { world, gravity } = run as RigidRun;
  const { Position, Joint, Attachment } = world.components;
  const indices = new Map<number, number>();
  const bodies: RigidBodyData[] = [];
  const parts = [...query(world, [Position, Attachment])];
  for (const row of query(world, [Position, Not(Attachment)])) {
    indices.set(row, bodies.length);
    const own = parts.filter((part) => Attachment.body[part] === row);
    bodies.push(bodyData(world, row, own));
  }
  const joints = [...query(world, [Joint])].map((row) => jointData(world, row, indices));
  if (joints.includes(undefined)) return undefined;
  const isPlain = ({ kind }: RigidShapeData) => PLAIN.includes(kind);
  if (!bodies.every(({ shapes }) => shapes.every(isPlain))) return undefined;
  return { gravity, bodies, joints: joints as RigidJointData[] };
}

function bodyData(world: PhysicsWorld, row: number, parts: readonly number[]): RigidBodyData {
  const { Position, Rotation, Velocity, AngularVelocity, Mass, Inertia, Collider } = world.components;
  const hasMass = hasComponent(world, row, Mass);
  const pose = { x: 0, y: 0, angle: 0 };
  return {
    x: Position.x[row],
    y: Position.y[row],
    angle: Rotation.angle[row],
    vx: Velocity.x[row],
    vy: Velocity.y[row],
    w: AngularVelocity.z[row],
    mass: hasMass ? Mass.value[row] : 0,
    inertia: hasComponent(world, row, Inertia) ? Inertia.value[row] : 0,
    isKinematic: !hasMass && (Velocity.x[row] !== 0 || Velocity.y[row] !== 0 || AngularVelocity.z[row] !== 0),
    shapes: [
      ...(hasComponent(world, row, Collider) ? [shapeData(world, row, pose)] : []),
      ...parts.map((part) => shapeData(world, part, poseOf(world, part))),
    ],
  };
}

type Pose = Pick<RigidShapeData, 'x' | 'y' | 'angle'>;

function poseOf({ components: { Attachment } }: PhysicsWorld, part: number): Pose {
  return { x: Attachment.x[part], y: Attachment.y[part], angle: Attachment.angle[part] };
}

function shapeData(world: PhysicsWorld, row: number, pose: Pose): RigidShapeData {
  const { Collider } = world.components;
  const { kind, vertices, radius } = shapeAt(world, Collider.shape[row]) ?? disc(Collider.radius[row]);
  const [friction, restitution] = [Collider.friction[row], Collider.restitution[row]];
  return { kind, vertices, radius, ...pose, friction, restitution, collides: Collider.mask[row] !== 0 };
}

/** A collider without a shape of the pool is a disc. */
function disc(radius: number): Pick<Shape, 'kind' | 'vertices' | 'radius'> {
  return { kind: 'circle', vertices: [0, 0], radius };
}

/** The vertices of a shape in the frame of its body. */
export function placedVertices({
  vertices,
  x,
  y,
  angle,
}: RigidShapeData): { readonly x: number; readonly y: number }[] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return Array.from({ length: vertices.length / 2 }, (_, i) => {
    const [vx, vy] = [vertices[2 * i], vertices[2 * i + 1]];
    return { x: x + c * vx - s * vy, y: y + s * vx + c * vy };
  });
}

function jointData(
  { components: { Joint } }: PhysicsWorld,
  row: number,
  indices: ReadonlyMap<number, number>,
): RigidJointData | undefined {
  const kind = JOINT_KINDS[Joint.kind[row]];
  const [a, b] = [indices.get(Joint.a[row]), indices.get(Joint.b[row])];
  const isPlain = Joint.hasLimits[row] === 0 && Joint.hertz[row] === 0;
  if (kind === undefined || a === undefined || b === undefined || !isPlain) return undefined;
  const anchors = { ax: Joint.ax[row], ay: Joint.ay[row], bx: Joint.bx[row], by: Joint.by[row] };
  return {
    kind,
    a,
    b,
    ...anchors,
    angle: Joint.angle[row],
    maxTorque: Joint.maxMotor[row],
    speed: Joint.motorSpeed[row],
  };
}

/** Half the width and the height of a box about its centre; undefined if the vertices are no such box. */
export function halfSidesOfBox(vertices: readonly number[]): { readonly x: number; readonly y: number } | undefined {
  const half = (axis: number) => Math.max(...vertices.filter((_, i) => i % 2 === axis));
  const [x, y] = [half(0), half(1)];
  const isBox = vertices.length === 8 && vertices.every((v, i) => Math.abs(v) === (i % 2 === 0 ? x : y));
  return isBox ? { x, y } : undefined;
}

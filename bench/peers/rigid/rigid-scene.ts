// A world of rigid bodies as plain data, from which other engines build the same scene.
import { type PhysicsWorld, type Shape, shapeAt } from '@principia/physics';
import type { RigidRun, SceneRun } from '@principia/scenes';
import { hasComponent, query } from 'bitecs';

export interface RigidBodyData {
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
  /** Undefined for a body without a collider. */
  readonly shape: Pick<Shape, 'kind' | 'vertices' | 'radius' | 'area'> | undefined;
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

/** Reads a run; undefined where it holds what the peers do not build: chains, compounds, capsules, other joints. */
export function readRigidScene(run: SceneRun): RigidSceneData | undefined {
  const { world, gravity } = run as RigidRun;
  const { Position, Joint, Attachment } = world.components;
  if (query(world, [Attachment]).length > 0) return undefined;
  const indices = new Map<number, number>();
  const bodies: RigidBodyData[] = [];
  for (const row of query(world, [Position])) {
    indices.set(row, bodies.length);
    bodies.push(bodyData(world, row));
  }
  const joints = [...query(world, [Joint])].map((row) => jointData(world, row, indices));
  if (joints.includes(undefined)) return undefined;
  const isPlain = ({ shape }: RigidBodyData) => shape === undefined || PLAIN.includes(shape.kind);
  if (!bodies.every(isPlain)) return undefined;
  return { gravity, bodies, joints: joints as RigidJointData[] };
}

function bodyData(world: PhysicsWorld, row: number): RigidBodyData {
  const { Position, Rotation, Velocity, AngularVelocity, Mass, Inertia, Collider } = world.components;
  const shape = shapeAt(world, Collider.shape[row]) ?? disc(Collider.radius[row]);
  return {
    x: Position.x[row],
    y: Position.y[row],
    angle: Rotation.angle[row],
    vx: Velocity.x[row],
    vy: Velocity.y[row],
    w: AngularVelocity.z[row],
    mass: hasComponent(world, row, Mass) ? Mass.value[row] : 0,
    inertia: hasComponent(world, row, Inertia) ? Inertia.value[row] : 0,
    shape: hasComponent(world, row, Collider) ? shape : undefined,
    friction: Collider.friction[row],
    restitution: Collider.restitution[row],
    collides: Collider.mask[row] !== 0,
  };
}

/** A collider without a shape of the pool is a disc. */
function disc(radius: number): RigidBodyData['shape'] {
  return { kind: 'circle', vertices: [0, 0], radius, area: Math.PI * radius * radius };
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

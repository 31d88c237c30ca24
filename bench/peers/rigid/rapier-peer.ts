// The scene in Rapier, compiled to WebAssembly without SIMD, as the package of a browser has it.
import RAPIER from '@dimforge/rapier2d-compat';
import type { SceneRun } from '@principia/scenes';
import type { Peer } from '../peer.ts';
import {
  halfSidesOfBox,
  type RigidBodyData,
  type RigidJointData,
  type RigidShapeData,
  readRigidScene,
} from './rigid-scene.ts';

/** Rapier's solver makes one sub-step of an iteration; its default is 4, as ours. */
const SOLVER_ITERATIONS = 4;

export async function rapierPeer(run: SceneRun): Promise<Peer | undefined> {
  const scene = readRigidScene(run);
  if (scene === undefined) return undefined;
  await RAPIER.init();
  const world = new RAPIER.World({ x: 0, y: -scene.gravity });
  world.timestep = run.dt;
  world.numSolverIterations = SOLVER_ITERATIONS;
  const bodies = scene.bodies.map((body) => addBody(world, body));
  for (const joint of scene.joints) addJoint(world, bodies, joint);
  return {
    name: 'Rapier 0.21',
    step: () => world.step(),
    positions: (axis) => bodies.map((body) => (axis === 'z' ? 0 : body.translation()[axis])),
    differs: true,
  };
}

function addBody(
  world: RAPIER.World,
  { mass, inertia, isKinematic, shapes, ...data }: RigidBodyData,
): RAPIER.RigidBody {
  const { RigidBodyDesc } = RAPIER;
  const unmoved = isKinematic ? RigidBodyDesc.kinematicVelocityBased() : RigidBodyDesc.fixed();
  const description = mass > 0 ? RigidBodyDesc.dynamic() : unmoved;
  description
    .setTranslation(data.x, data.y)
    .setRotation(data.angle)
    .setLinvel(data.vx, data.vy)
    .setAngvel(data.w)
    .setCanSleep(false)
    .setAdditionalMassProperties(mass, { x: 0, y: 0 }, inertia);
  const body = world.createRigidBody(description);
  for (const shape of shapes) {
    const { x, y, angle, friction, restitution, collides } = shape;
    const collider = colliderOf(shape).setTranslation(x, y).setRotation(angle);
    collider.setDensity(0).setFriction(friction).setRestitution(restitution);
    if (!collides) collider.setCollisionGroups(0);
    world.createCollider(collider, body);
  }
  return body;
}

function colliderOf({ kind, vertices, radius }: RigidShapeData): RAPIER.ColliderDesc {
  if (kind === 'circle') return RAPIER.ColliderDesc.ball(radius);
  const half = halfSidesOfBox(vertices);
  if (half !== undefined) return RAPIER.ColliderDesc.cuboid(half.x, half.y);
  return RAPIER.ColliderDesc.convexHull(Float32Array.from(vertices)) as RAPIER.ColliderDesc;
}

function addJoint(world: RAPIER.World, bodies: readonly RAPIER.RigidBody[], joint: RigidJointData): void {
  const [a, b] = [bodies[joint.a], bodies[joint.b]];
  const [anchorA, anchorB] = [
    { x: joint.ax, y: joint.ay },
    { x: joint.bx, y: joint.by },
  ];
  const isWeld = joint.kind === 'weld';
  const data = isWeld
    ? RAPIER.JointData.fixed(anchorA, joint.angle, anchorB, 0)
    : RAPIER.JointData.revolute(anchorA, anchorB);
  const made = world.createImpulseJoint(data, a, b, true);
  if (joint.maxTorque > 0) (made as RAPIER.RevoluteImpulseJoint).configureMotorVelocity(joint.speed, 1e6);
}

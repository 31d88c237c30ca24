// The scene in Rapier, compiled to WebAssembly without SIMD, as the package of a browser has it.
import RAPIER from '@dimforge/rapier2d-compat';
import type { SceneRun } from '@principia/scenes';
import type { Peer } from '../peer.ts';
import { halfSidesOfBox, type RigidBodyData, type RigidJointData, readRigidScene } from './rigid-scene.ts';

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

function addBody(world: RAPIER.World, { mass, inertia, shape, ...data }: RigidBodyData): RAPIER.RigidBody {
  const description = mass > 0 ? RAPIER.RigidBodyDesc.dynamic() : RAPIER.RigidBodyDesc.fixed();
  description
    .setTranslation(data.x, data.y)
    .setRotation(data.angle)
    .setLinvel(data.vx, data.vy)
    .setAngvel(data.w)
    .setCanSleep(false)
    .setAdditionalMassProperties(mass, { x: 0, y: 0 }, inertia);
  const body = world.createRigidBody(description);
  if (shape === undefined) return body;
  const collider = colliderOf(shape).setDensity(0).setFriction(data.friction).setRestitution(data.restitution);
  if (!data.collides) collider.setCollisionGroups(0);
  world.createCollider(collider, body);
  return body;
}

function colliderOf({ kind, vertices, radius }: NonNullable<RigidBodyData['shape']>): RAPIER.ColliderDesc {
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

// The scene in Box2D 3, compiled to WebAssembly: the single-threaded build of `box2d3-wasm`, without SIMD, and the build with
// SIMD and threads, of which it is given one.
import { readFileSync } from 'node:fs';
import type { SceneRun } from '@principia/scenes';
import type loadDefault from 'box2d3-wasm';
import type { Peer } from '../peer.ts';
import {
  placedVertices,
  type RigidBodyData,
  type RigidJointData,
  type RigidShapeData,
  readRigidScene,
} from './rigid-scene.ts';

type Box2D = Awaited<ReturnType<typeof loadDefault>>;
type BodyId = ReturnType<Box2D['b2CreateBody']>;
type WorldId = ReturnType<Box2D['b2CreateWorld']>;

const SUBSTEPS = 4;

export const box2dPeer = (run: SceneRun) => openPeer(run, 'compat', 'Box2D 3 (box2d3-wasm)');
export const box2dSimdPeer = (run: SceneRun) => openPeer(run, 'deluxe', 'Box2D 3 with SIMD (box2d3-wasm, one thread)');

async function openPeer(run: SceneRun, build: 'compat' | 'deluxe', name: string): Promise<Peer | undefined> {
  const scene = readRigidScene(run);
  if (scene === undefined) return undefined;
  const b2 = await loadBox2D(build);
  const definition = b2.b2DefaultWorldDef();
  definition.gravity.Set(0, -scene.gravity);
  definition.enableSleep = false;
  definition.workerCount = 0;
  const world = b2.b2CreateWorld(definition);
  const bodies = scene.bodies.map((body) => addBody(b2, world, body));
  for (const joint of scene.joints) addJoint(b2, world, bodies, joint);
  return {
    name,
    step: () => b2.b2World_Step(world, run.dt, SUBSTEPS),
    positions: (axis) => bodies.map((body) => (axis === 'z' ? 0 : b2.b2Body_GetPosition(body)[axis])),
    differs: true,
  };
}

async function loadBox2D(build: 'compat' | 'deluxe'): Promise<Box2D> {
  const base = new URL(`${build}/Box2D.${build}`, import.meta.resolve('box2d3-wasm')).href;
  const { default: make } = await import(`${base}.mjs`);
  return make({ wasmBinary: readFileSync(new URL(`${base}.wasm`)) });
}

function addBody(b2: Box2D, world: WorldId, { mass, inertia, isKinematic, shapes, ...data }: RigidBodyData): BodyId {
  const definition = b2.b2DefaultBodyDef();
  const { b2_dynamicBody, b2_kinematicBody, b2_staticBody } = b2.b2BodyType;
  const unmoved = isKinematic ? b2_kinematicBody : b2_staticBody;
  definition.type = mass > 0 ? b2_dynamicBody : unmoved;
  definition.position.Set(data.x, data.y);
  definition.rotation.SetAngle(data.angle);
  definition.linearVelocity.Set(data.vx, data.vy);
  definition.angularVelocity = data.w;
  const body = b2.b2CreateBody(world, definition);
  for (const shape of shapes) addShape(b2, body, shape);
  if (mass > 0) {
    const massData = b2.b2Body_GetMassData(body);
    massData.mass = mass;
    massData.rotationalInertia = inertia;
    massData.center.Set(0, 0);
    b2.b2Body_SetMassData(body, massData);
  }
  return body;
}

function addShape(b2: Box2D, body: BodyId, shape: RigidShapeData): void {
  const { kind, radius, friction, restitution, collides } = shape;
  const definition = b2.b2DefaultShapeDef();
  definition.material.friction = friction;
  definition.material.restitution = restitution;
  definition.enableContactEvents = false;
  if (!collides) definition.filter.setMaskBits64('0');
  if (kind === 'circle') {
    const circle = new b2.b2Circle();
    circle.center.Set(shape.x, shape.y);
    circle.radius = radius;
    b2.b2CreateCircleShape(body, definition, circle);
    return;
  }
  const points = placedVertices(shape).map(({ x, y }) => {
    const point = new b2.b2Vec2();
    point.Set(x, y);
    return point;
  });
  b2.b2CreatePolygonShape(body, definition, b2.b2MakePolygon(b2.b2ComputeHull(points), radius));
}

function addJoint(b2: Box2D, world: WorldId, bodies: readonly BodyId[], joint: RigidJointData): void {
  const definition = joint.kind === 'weld' ? b2.b2DefaultWeldJointDef() : b2.b2DefaultRevoluteJointDef();
  const { base } = definition;
  base.bodyIdA = bodies[joint.a];
  base.bodyIdB = bodies[joint.b];
  base.localFrameA.p.Set(joint.ax, joint.ay);
  base.localFrameA.q.SetAngle(joint.angle);
  base.localFrameB.p.Set(joint.bx, joint.by);
  if ('enableMotor' in definition) {
    definition.enableMotor = joint.maxTorque > 0;
    definition.maxMotorTorque = joint.maxTorque;
    definition.motorSpeed = joint.speed;
    b2.b2CreateRevoluteJoint(world, definition);
  } else b2.b2CreateWeldJoint(world, definition as never);
}

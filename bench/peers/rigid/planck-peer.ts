// The scene in planck, which is Box2D 2.4 in JavaScript: ten iterations of velocities and two of positions, and no sub-steps.
import type { SceneRun } from '@principia/scenes';
import { type Body, Box, Circle, Polygon, RevoluteJoint, Vec2, WeldJoint, World } from 'planck';
import type { Peer } from '../peer.ts';
import {
  halfSidesOfBox,
  placedVertices,
  type RigidBodyData,
  type RigidJointData,
  type RigidShapeData,
  readRigidScene,
} from './rigid-scene.ts';

/** Iterations of a step: the bench asks for about as much work as that of four sub-steps. */
const VELOCITY_ITERATIONS = 8;
const POSITION_ITERATIONS = 3;

export function planckPeer(run: SceneRun): Peer | undefined {
  const scene = readRigidScene(run);
  if (scene === undefined) return undefined;
  const world = new World({ gravity: new Vec2(0, -scene.gravity), allowSleep: false });
  const bodies = scene.bodies.map((body) => addBody(world, body));
  for (const joint of scene.joints) addJoint(world, bodies, joint);
  return {
    name: 'planck 1.4',
    step: () => world.step(run.dt, VELOCITY_ITERATIONS, POSITION_ITERATIONS),
    positions: (axis) => bodies.map((body) => (axis === 'z' ? 0 : body.getPosition()[axis])),
    differs: true,
  };
}

function addBody(world: World, { mass, inertia, isKinematic, shapes, ...data }: RigidBodyData): Body {
  const unmoved = isKinematic ? 'kinematic' : 'static';
  const body = world.createBody({
    type: mass > 0 ? 'dynamic' : unmoved,
    position: new Vec2(data.x, data.y),
    angle: data.angle,
    linearVelocity: new Vec2(data.vx, data.vy),
    angularVelocity: data.w,
  });
  for (const shape of shapes) {
    const { friction, restitution, collides } = shape;
    const filter = collides ? {} : { filterMaskBits: 0 };
    body.createFixture({ shape: shapeOf(shape), friction, restitution, density: 1, ...filter });
  }
  if (mass > 0) body.setMassData({ mass, I: inertia, center: new Vec2(0, 0) });
  return body;
}

function shapeOf(shape: RigidShapeData) {
  const { kind, vertices, radius, x, y, angle } = shape;
  if (kind === 'circle') return new Circle(new Vec2(x, y), radius);
  const half = halfSidesOfBox(vertices);
  if (half !== undefined) return new Box(half.x, half.y, new Vec2(x, y), angle);
  return new Polygon(placedVertices(shape).map((point) => new Vec2(point.x, point.y)));
}

function addJoint(world: World, bodies: readonly Body[], joint: RigidJointData): void {
  const bodyA = bodies[joint.a];
  const bodyB = bodies[joint.b];
  const anchors = { localAnchorA: new Vec2(joint.ax, joint.ay), localAnchorB: new Vec2(joint.bx, joint.by) };
  const common = { bodyA, bodyB, ...anchors, referenceAngle: joint.angle };
  if (joint.kind === 'weld') world.createJoint(new WeldJoint(common));
  else {
    const motor = { enableMotor: joint.maxTorque > 0, motorSpeed: joint.speed, maxMotorTorque: joint.maxTorque };
    world.createJoint(new RevoluteJoint({ ...common, ...motor }));
  }
}

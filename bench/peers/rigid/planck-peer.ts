// The scene in planck, which is Box2D 2.4 in JavaScript: ten iterations of velocities and two of positions, and no sub-steps.
import type { SceneRun } from '@principia/scenes';
import { type Body, Box, Circle, Polygon, RevoluteJoint, Vec2, WeldJoint, World } from 'planck';
import type { Peer } from '../peer.ts';
import { halfSidesOfBox, type RigidBodyData, type RigidJointData, readRigidScene } from './rigid-scene.ts';

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

function addBody(world: World, { mass, inertia, shape, ...data }: RigidBodyData): Body {
  const body = world.createBody({
    type: mass > 0 ? 'dynamic' : 'static',
    position: new Vec2(data.x, data.y),
    angle: data.angle,
    linearVelocity: new Vec2(data.vx, data.vy),
    angularVelocity: data.w,
  });
  if (shape !== undefined) {
    const material = { density: mass / shape.area, friction: data.friction, restitution: data.restitution };
    body.createFixture({ shape: shapeOf(shape), ...material, ...(data.collides ? {} : { filterMaskBits: 0 }) });
  }
  if (mass > 0) body.setMassData({ mass, I: inertia, center: new Vec2(0, 0) });
  return body;
}

function shapeOf({ kind, vertices, radius }: NonNullable<RigidBodyData['shape']>) {
  if (kind === 'circle') return new Circle(radius);
  const half = halfSidesOfBox(vertices);
  if (half !== undefined) return new Box(half.x, half.y);
  return new Polygon(
    Array.from({ length: vertices.length / 2 }, (_, i) => new Vec2(vertices[2 * i], vertices[2 * i + 1])),
  );
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

/** A build as numbers: bodies, shapes and joints. */
import {
  bodies,
  capsule,
  circle,
  createJoint,
  type JointInput,
  type PhysicsWorld,
  polygon,
  type Shape,
  shapeAt,
  spawn,
} from '@principia/physics';
import { query } from 'bitecs';
import type { Material } from './builds.ts';

const KINDS = ['circle', 'capsule', 'polygon'] as const;

/** A body: index of its shape, x, y, angle, mass (0 for one that does not move), colour, friction, restitution. */
type SavedBody = readonly number[];
/** A joint: indices of its bodies (−1 for the world), kind, anchors, angle, motor speed and torque. */
type SavedJoint = readonly number[];

export interface SavedScene {
  /** Of each shape its kind, its radius and its vertices. */
  readonly shapes: readonly (readonly number[])[];
  readonly bodies: readonly SavedBody[];
  readonly joints: readonly SavedJoint[];
}

const round = (value: number) => Math.round(1e4 * value) / 1e4;

/** The bodies of a world but one, such as the ground. */
export function sceneOf(world: PhysicsWorld, ground: number): SavedScene {
  const { Position, Rotation, Mass, Collider, Appearance, Joint } = world.components;
  const list = bodies(world);
  const ids = Array.from(list.ids.subarray(0, list.count)).filter((id) => id !== ground);
  const shapes: number[][] = [];
  const known = new Map<string, number>();
  const shapeOf = (id: number) => {
    const shape = shapeAt(world, Collider.shape[id]);
    const numbers = shape === undefined ? [0, round(Collider.radius[id])] : numbersOf(shape);
    const key = numbers.join();
    if (!known.has(key)) known.set(key, shapes.push(numbers) - 1);
    return known.get(key) as number;
  };
  const saved = ids.map((id) =>
    [
      shapeOf(id),
      Position.x[id],
      Position.y[id],
      Rotation.angle[id],
      finite(Mass.value[id]),
      Appearance.color[id],
      Collider.friction[id],
      Collider.restitution[id],
    ].map(round),
  );
  const place = (id: number) => ids.indexOf(id);
  const joints = [...query(world, [Joint])].map((id) => {
    const { a, b, kind, ax, ay, bx, by, angle, motorSpeed, maxMotor } = Joint;
    const pair = [a[id] === 0 || a[id] === ground ? -1 : place(a[id]), place(b[id])];
    return [...pair, kind[id], ...[ax, ay, bx, by, angle, motorSpeed, maxMotor].map((column) => round(column[id]))];
  });
  return { shapes, bodies: saved, joints: joints.filter(([, b]) => b >= 0) };
}

/** A body that does not move has an infinite mass or none. */
function finite(mass: number): number {
  return Number.isFinite(mass) ? mass : 0;
}

function numbersOf({ kind, radius, vertices }: Shape): number[] {
  return [KINDS.indexOf(kind as (typeof KINDS)[number]), round(radius), ...vertices.map(round)];
}

/** Builds a saved scene in an empty world. */
export function buildScene(world: PhysicsWorld, scene: SavedScene, material: Material): void {
  const shapes = scene.shapes.map(shapeFrom);
  const ids = scene.bodies.map(([shape, x, y, angle, mass, color, ...surface]) => {
    // Older links have no surfaces.
    const [friction = material.friction, restitution = material.restitution] = surface;
    const collider = { shape: shapes[shape], friction, restitution };
    const body = { position: { x, y }, rotation: angle, collider, appearance: { color: color >>> 0 } };
    return spawn(world, mass > 0 ? { ...body, mass, velocity: {} } : body);
  });
  const { Position, Rotation } = world.components;
  for (const [a, b, kind, ax, ay, bx, by, angle, motorSpeed, maxMotor] of scene.joints) {
    const id = ids[b];
    const [c, s] = [Math.cos(Rotation.angle[id]), Math.sin(Rotation.angle[id])];
    const anchorB = { x: Position.x[id] + c * bx - s * by, y: Position.y[id] + s * bx + c * by };
    const first = a < 0 ? 0 : ids[a];
    const [ca, sa] = [Math.cos(Rotation.angle[first]), Math.sin(Rotation.angle[first])];
    const anchorA =
      first === 0
        ? { x: ax, y: ay }
        : { x: Position.x[first] + ca * ax - sa * ay, y: Position.y[first] + sa * ax + ca * ay };
    // The angle is stored relative to the one that the two bodies have now.
    const now = Rotation.angle[id] - (first === 0 ? 0 : Rotation.angle[first]);
    const joint: JointInput = {
      kind,
      a: first,
      b: id,
      anchorA,
      anchorB,
      axis: undefined,
      pulleyA: undefined,
      pulleyB: undefined,
      fields: { angle: angle - now, motorSpeed, maxMotor },
    };
    createJoint(world, joint);
  }
}

function shapeFrom([kind, radius, ...vertices]: readonly number[]): Shape {
  const points = Array.from({ length: vertices.length / 2 }, (_, i) => ({
    x: vertices[2 * i],
    y: vertices[2 * i + 1],
  }));
  if (KINDS[kind] === 'polygon') return polygon(points, { rounding: radius });
  if (KINDS[kind] === 'circle') return circle(radius);
  return capsule(Math.hypot(points[1].x - points[0].x, points[1].y - points[0].y), radius);
}

/** A build as text for a link: bodies, shapes and joints as numbers, compressed, in URL-safe base64. */
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
import { WORDS } from './words.ts';

/** Bodies of a link at most: links of more than some thousand characters are cut off by programs that carry them. */
export const MAX_BODIES = 250;
const VERSION = '1.';
const KINDS = ['circle', 'capsule', 'polygon'] as const;

/** A body: index of its shape, x, y, angle, mass (0 for one that does not move), colour. */
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

/** The bodies of a world but one, such as the ground. @throws Error with a sentence where there are too many */
export function sceneOf(world: PhysicsWorld, ground: number): SavedScene {
  const { Position, Rotation, Mass, Collider, Appearance, Joint } = world.components;
  const list = bodies(world);
  const ids = Array.from(list.ids.subarray(0, list.count)).filter((id) => id !== ground);
  if (ids.length > MAX_BODIES) {
    throw new Error(WORDS.tooMany(MAX_BODIES, ids.length));
  }
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
    [shapeOf(id), Position.x[id], Position.y[id], Rotation.angle[id], finite(Mass.value[id]), Appearance.color[id]].map(
      round,
    ),
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
  const ids = scene.bodies.map(([shape, x, y, angle, mass, color]) => {
    const collider = { shape: shapes[shape], ...material };
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

/** The text of a scene. */
export async function writeScene(scene: SavedScene): Promise<string> {
  const packed = await through(new TextEncoder().encode(JSON.stringify(scene)), new CompressionStream('deflate-raw'));
  const text = btoa(String.fromCharCode(...packed));
  return VERSION + text.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** @throws Error with a sentence that says what is wrong with the text */
export async function readScene(text: string): Promise<SavedScene> {
  if (!text.startsWith(VERSION)) throw broken(WORDS.broken.version);
  try {
    const bytes = atob(text.slice(VERSION.length).replaceAll('-', '+').replaceAll('_', '/'));
    const packed = Uint8Array.from(bytes, (character) => character.charCodeAt(0));
    const scene = JSON.parse(new TextDecoder().decode(await through(packed, new DecompressionStream('deflate-raw'))));
    return checked(scene);
  } catch {
    throw broken(WORDS.broken.incomplete);
  }
}

/** @throws Error where a value is not a list of finite numbers, or refers to what is not there */
function checked({ shapes, bodies: list, joints }: SavedScene): SavedScene {
  const areNumbers = (rows: readonly (readonly number[])[]) => rows.every((row) => row.every(Number.isFinite));
  if (![shapes, list, joints].every(areNumbers) || list.length > MAX_BODIES) throw new Error('not a scene');
  const isPlace = (index: number, least: number, count: number) => index >= least && index < count;
  if (!list.every(([shape]) => isPlace(shape, 0, shapes.length))) throw new Error('no such shape');
  if (!joints.every(([a, b]) => isPlace(a, -1, list.length) && isPlace(b, 0, list.length)))
    throw new Error('no such body');
  return { shapes, bodies: list, joints };
}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array> {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

function broken(why: string): Error {
  return new Error(WORDS.broken.sentence(why));
}

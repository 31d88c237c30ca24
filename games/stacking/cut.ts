/** Cuts polygons along a swipe: what the line crosses becomes two bodies that move on as the parts of the one did. */
import {
  despawn,
  type PhysicsWorld,
  polygon,
  rayCastAll,
  type Shape,
  shapeAt,
  shapeCount,
  spawn,
} from '@principia/physics';

type Point = { readonly x: number; readonly y: number };

/** Layer of bodies that can be cut: not that of the ground. */
const CUT_MASK = 1;
/** Smallest area of a part, m², and least distance of its corners, m; smaller splinters are not cut off. */
const [MIN_AREA, MIN_EDGE] = [0.004, 0.012];
/** Corners of a polygon at most, and shapes in a world: every part has a shape of its own. */
const [MAX_CORNERS, MAX_SHAPES] = [8, 4000];

/** @returns the number of bodies cut */
export function cutAlong(world: PhysicsWorld, from: Point, to: Point): number {
  if (Math.hypot(to.x - from.x, to.y - from.y) < MIN_EDGE) return 0;
  const hits = rayCastAll(world, from, to, { mask: CUT_MASK, walls: false });
  const ids = [...new Set(hits.map(({ body }) => body))].filter((id) => world.components.Mass.value[id] > 0);
  return ids.filter((id) => cutBody(world, id, from, to)).length;
}

function cutBody(world: PhysicsWorld, id: number, from: Point, to: Point): boolean {
  const { Collider, Position, Rotation } = world.components;
  const shape = shapeAt(world, Collider.shape[id]);
  if (shape?.kind !== 'polygon' || shape.radius > 0 || shapeCount(world) + 2 > MAX_SHAPES) return false;
  const corners = cornersOf(shape, { x: Position.x[id], y: Position.y[id] }, Rotation.angle[id]);
  const parts = [split(corners, from, to), split(corners, to, from)].map(simplify);
  if (parts.some((part) => part.length < 3 || part.length > MAX_CORNERS || areaOf(part) < MIN_AREA)) return false;
  const density = world.components.Mass.value[id] / shape.area;
  const inputs = parts.map((part) => partOf(world, id, part, density));
  despawn(world, id);
  for (const input of inputs) spawn(world, input);
  return true;
}

/** A part of a body: its corners are where they were, and it moves as they did. */
function partOf(world: PhysicsWorld, id: number, corners: readonly Point[], density: number) {
  const { Collider, Position, Velocity, AngularVelocity, Appearance } = world.components;
  const shape = polygon(corners);
  const spin = AngularVelocity.z[id];
  const { x, y } = shape.centre;
  return {
    position: { x, y },
    rotation: 0,
    velocity: {
      x: Velocity.x[id] - spin * (y - Position.y[id]),
      y: Velocity.y[id] + spin * (x - Position.x[id]),
    },
    angularVelocity: { z: spin },
    collider: { shape, density, friction: Collider.friction[id], restitution: Collider.restitution[id] },
    appearance: { color: Appearance.color[id] },
  };
}

function cornersOf({ vertices }: Shape, { x, y }: Point, angle: number): Point[] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return Array.from({ length: vertices.length / 2 }, (_, i) => {
    const [u, v] = [vertices[2 * i], vertices[2 * i + 1]];
    return { x: x + c * u - s * v, y: y + s * u + c * v };
  });
}

/** The part of a convex polygon to the left of a line (Sutherland and Hodgman, Communications of the ACM 17, 32, 1974). */
export function split(corners: readonly Point[], from: Point, to: Point): Point[] {
  const side = ({ x, y }: Point) => (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
  return corners.flatMap((corner, i) => {
    const next = corners[(i + 1) % corners.length];
    const [here, there] = [side(corner), side(next)];
    const kept = here >= 0 ? [corner] : [];
    if (here * there >= 0) return kept;
    const share = here / (here - there);
    return [...kept, { x: corner.x + share * (next.x - corner.x), y: corner.y + share * (next.y - corner.y) }];
  });
}

/** Leaves out corners that nearly coincide with the one before. */
function simplify(corners: readonly Point[]): Point[] {
  return corners.filter((corner, i) => {
    const before = corners[(i + corners.length - 1) % corners.length];
    return Math.hypot(corner.x - before.x, corner.y - before.y) >= MIN_EDGE;
  });
}

/** The shoelace formula. */
export function areaOf(corners: readonly Point[]): number {
  return corners.reduce((sum, { x, y }, i) => {
    const next = corners[(i + 1) % corners.length];
    return sum + 0.5 * (x * next.y - next.x * y);
  }, 0);
}

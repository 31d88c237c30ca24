// What is around a character: the surfaces that it touches, and the first one that it meets on a path.
import { lengthOf } from '../collision/shapes/2d/shape.ts';
import { openQuery, readHit, visitBodies } from '../queries/body-query.ts';
import { castShapeAll } from '../queries/cast-shape.ts';
import { visitWalls } from '../queries/walls.ts';
import type { Character } from './character.ts';
import { isObstacle } from './obstacles.ts';
import { dot, gapTo, plus, type Surface, type Vector2 } from './surface.ts';
import { bodyBehind, isMovable, velocityAt } from './surface-body.ts';

/** How far around the character bodies are looked at that come nearer, as a part of its radius: by so much they push it. */
const APPROACH = 1;

/** One minus the cosine of the angle below which two surfaces are parallel. */
const PARALLEL = 1e-6;

/** How far surfaces that are flush may be out of line, as a part of the margin. */
const FLUSH = 0.1;

/** Distance of two surfaces at which `castShape` says that they have met, m. */
const MEETING_DISTANCE = 1e-4;

/**
 * Returns the surfaces that a character touches at a position: those no further away than twice its margin. What is deeper in
 * it than its radius is left out, so that nothing holds it for ever.
 */
export function touchedSurfaces(character: Character, position: Vector2): Surface[] {
  const { world, id, core, shape, angle, margin } = character;
  const distance = shape.radius + 2 * margin + APPROACH * shape.radius;
  const path = { ...position, angle, dx: 0, dy: 0 };
  const query = openQuery(world, path, core.extent + distance, { ignore: id }, core);
  const { kernels, at, shapeAt } = query;
  const surfaces: Surface[] = [];
  const consider = (other: number, isWall: boolean) => {
    const { x, y, nx, ny, fraction } = readHit(query, other, isWall);
    if (fraction === 0) return;
    const normal = { x: nx, y: ny };
    const point = { x, y };
    const clearance = shape.radius + margin + approachOf(character, other, point, normal);
    const surface = { id: other, isWall, point, normal, offset: dot(normal, position) - fraction + clearance };
    if (gapTo(surface, position) > margin) return;
    if (isObstacle(character, surface, position)) surfaces.push(surface);
  };
  const next = (row: number) => kernels.nextNearBody(at, shapeAt, row);
  visitBodies(query, next, (row) => consider(row, false));
  visitWalls(query, (wall) => {
    if (kernels.isNearWall(at, shapeAt) === 1) consider(wall, true);
  });
  return surfaces.length < 2 ? surfaces : withoutHidden(character, surfaces, position);
}

/**
 * Leaves out the corners that are no further out than the plane of a surface that is nearer: of a wall of flush tiles the
 * corners of the next ones. What keeps off the plane meets none of them, but a line through one would turn it aside.
 */
function withoutHidden(character: Character, surfaces: readonly Surface[], position: Vector2): Surface[] {
  const gaps = surfaces.map((surface) => gapTo(surface, position));
  const hides = (front: Surface, surface: Surface) => isBehind(character, surface, front);
  return surfaces.filter((surface, i) => !surfaces.some((front, k) => gaps[k] < gaps[i] && hides(front, surface)));
}

/** Whether the nearest point of a surface is no further out than the plane of another one, nor will be after the step. */
function isBehind({ world, dt, margin }: Character, { id, point, normal }: Surface, front: Surface): boolean {
  // Of parallel surfaces none turns the movement, and all are touched.
  if (dot(normal, front.normal) > 1 - PARALLEL) return false;
  const relative = plus(velocityAt(world, id, point), velocityAt(world, front.id, front.point), -1);
  const out = dot(plus(point, front.point, -1), front.normal);
  return out + Math.max(0, dot(relative, front.normal) * dt) <= FLUSH * margin;
}

/**
 * How far a kinematic body comes nearer during the step, m, seen from the ground that the character rides on. Bodies that
 * yield do not push it.
 */
export function approachOf(
  { world, groundVelocity, dt }: Character,
  id: number,
  point: Vector2,
  normal: Vector2,
): number {
  if (isMovable(world, bodyBehind(world, id))) return 0;
  return Math.max(0, dot(plus(velocityAt(world, id, point), groundVelocity, -1), normal) * dt);
}

/** The first surface that a character meets on a path. */
export interface Meeting {
  /** Part of the path that leaves the margin free. */
  readonly fraction: number;
  readonly surface: Surface;
}

/** Returns the first surface that a character meets on a path, except that of one body. */
export function firstMeeting(
  character: Character,
  position: Vector2,
  motion: Vector2,
  except = 0,
): Meeting | undefined {
  const { world, id, shape, angle, margin } = character;
  const length = lengthOf(motion.x, motion.y);
  if (length === 0) return undefined;
  // Beyond the end, too, so that the margin is free there.
  const longer = 1 + (2 * margin) / length;
  const path = { x: longer * motion.x, y: longer * motion.y };
  const hits = castShapeAll(world, shape, { ...position, angle }, path, { ignore: [id, except] });
  for (const { body, isWall, x, y, nx, ny, fraction: part } of hits) {
    const normal = { x: nx, y: ny };
    const fraction = part * longer;
    const closing = -dot(normal, motion) / length;
    // What overlaps from the start has no normal: `touchedSurfaces` sees it.
    if (!(closing > 0)) continue;
    // A one-way platform that it is passing through does not lift it: of how deep it is in it, `touchedSurfaces` knows.
    if (part === 0 && !isWall && world.components.Collider.oneWay[body] === 1) continue;
    const there = plus(position, motion, fraction);
    const offset = dot(normal, there) - MEETING_DISTANCE + margin;
    const surface = { id: body, isWall, point: { x, y }, normal, offset };
    const free = fraction - (margin - MEETING_DISTANCE) / closing / length;
    if (free < 1 && isObstacle(character, surface, position)) return { fraction: Math.max(0, free), surface };
  }
  return undefined;
}

// The ground of a character: a surface that is not too steep, or the edge of one.
import { rayCastAll } from '../queries/ray-cast.ts';
import type { Character } from './character.ts';
import { dot, plus, type Surface, type Vector2, ZERO } from './surface.ts';
import { velocityAt } from './surface-body.ts';
import { firstMeeting } from './surroundings.ts';

/** Whether a character can stand and walk on a surface. */
export function isGround(character: Character, surface: Surface, position: Vector2): boolean {
  const upward = dot(surface.normal, character.up);
  if (upward >= character.minUpward) return true;
  const isStep = upward > 0 && heightAbove(character, position, surface) <= character.stepHeight;
  return isStep && isEdgeOfGround(character, surface);
}

/** Height of a point of a surface above the lowest point of a character, m. */
export function heightAbove({ up, depth }: Character, position: Vector2, { point }: Surface): number {
  return dot(plus(point, position, -1), up) + depth;
}

/** Whether what is just behind the point of a surface is ground: then the character stands on the edge of it. */
function isEdgeOfGround({ world, id, up, right, minUpward, margin }: Character, surface: Surface): boolean {
  const inward = dot(surface.normal, right) > 0 ? -1 : 1;
  const behind = plus(surface.point, right, inward * margin);
  const hits = rayCastAll(world, plus(behind, up, margin), plus(behind, up, -margin), { ignore: id });
  return hits.some(({ body, nx, ny }) => body === surface.id && dot({ x: nx, y: ny }, up) >= minUpward);
}

/** The most level one of some surfaces, of equally level ones the first. */
export function mostLevel(surfaces: readonly Surface[], up: Vector2): Surface | undefined {
  let found: Surface | undefined;
  for (const surface of surfaces) {
    if (found === undefined || dot(surface.normal, up) > dot(found.normal, up)) found = surface;
  }
  return found;
}

/** Returns the ground within a distance below a character, and where it stands on it; undefined if there is none. */
export function groundBelow(
  character: Character,
  start: Vector2,
  distance: number,
): { readonly position: Vector2; readonly surface: Surface } | undefined {
  const { up, margin, minUpward } = character;
  // Down to where the shape itself would meet the ground, of which the margin is given back.
  const motion = plus(ZERO, up, -(distance + margin / minUpward));
  const met = firstMeeting(character, start, motion);
  if (met === undefined) return undefined;
  const position = plus(start, motion, met.fraction);
  return isGround(character, met.surface, position) ? { position, surface: met.surface } : undefined;
}

/**
 * Returns the ground that a character stood on if that has just gone down from under it: a lift, or a plank that yields to its
 * weight. Undefined if there is none, or if it was further away before.
 */
export function recedingGround(character: Character, start: Vector2): Surface | undefined {
  const { world, up, dt, margin, snapDistance } = character;
  const below = groundBelow(character, start, snapDistance);
  if (below === undefined) return undefined;
  const receded = -dot(velocityAt(world, below.surface.id, below.surface.point), up) * dt;
  const gap = dot(plus(start, below.position, -1), up);
  return receded > 0 && gap <= receded + margin ? below.surface : undefined;
}

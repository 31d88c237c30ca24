// The movement of a character along what it meets.
import { lengthOf } from '../collision/shapes/2d/shape.ts';
import type { Character } from './character.ts';
import { isGround } from './ground.ts';
import { nearestDisplacement } from './nearest-displacement.ts';
import { dot, gapTo, plus, type Surface, type Vector2, ZERO } from './surface.ts';
import { bodyBehind, isMovable } from './surface-body.ts';
import { firstMeeting, touchedSurfaces } from './surroundings.ts';

/** Surfaces that a character meets in one step at most: what it would do after the last is left out. */
const MAX_MEETINGS = 6;

/** Displacements below this part of the margin are not worth a look around. */
const TINY = 1e-3;

/** Sine of the angle below which a displacement is along a surface. */
const ROUNDING = 1e-4;

/** Where a movement led, and the surfaces that turned it aside. */
export interface Slide {
  readonly end: Vector2;
  readonly surfaces: readonly Surface[];
}

/**
 * Moves a character by a displacement, or as near to it as it gets without entering anything. What is too near at the start
 * pushes it away, if it is ground or does not yield. Slopes that are too steep lift it no more than walls do. One that falls on ground stops falling there.
 * @param touched the surfaces that it touches at the start
 */
export function slide(
  character: Character,
  start: Vector2,
  wanted: Vector2,
  touched = touchedSurfaces(character, start),
): Slide {
  const { shape, up, right, margin } = character;
  // Out of what it overlaps it gets by its radius in a step, and by the margin.
  const maxChange = lengthOf(wanted.x, wanted.y) + shape.radius + margin;
  let position = start;
  let target = plus(start, wanted);
  const met: Surface[] = [];
  let surfaces = touched;
  for (let i = 0; i < MAX_MEETINGS; i++) {
    if (i > 0) surfaces = [...touchedSurfaces(character, position), ...met];
    const rest = plus(target, position, -1);
    if (dot(rest, up) < 0 && surfaces.some((surface) => lands(character, surface, position, rest))) {
      target = plus(position, right, dot(rest, right));
    }
    const walls = surfaces.filter((surface) => !isGround(character, surface, position));
    const solid = surfaces.map((surface) => (walls.includes(surface) ? held(character, surface, position) : surface));
    const constraints = [...solid, ...walls.flatMap((surface) => asWall(character, surface, position))];
    const displacement = nearestDisplacement(position, plus(target, position, -1), constraints, maxChange);
    if (lengthOf(displacement.x, displacement.y) < TINY * margin) break;
    const meeting = firstMeeting(character, position, displacement);
    position = plus(position, displacement, meeting?.fraction ?? 1);
    if (meeting === undefined) break;
    met.push(meeting.surface);
  }
  return { end: position, surfaces };
}

/** A wall of a body that yields holds the character, but does not push it: the contact pushes the body out of the character. */
function held({ world }: Character, surface: Surface, position: Vector2): Surface {
  if (gapTo(surface, position) >= 0 || !isMovable(world, bodyBehind(world, surface.id))) return surface;
  return { ...surface, offset: dot(surface.normal, position) };
}

function lands(character: Character, surface: Surface, position: Vector2, rest: Vector2): boolean {
  // Along a slope that it walks down it does not fall, but for rounding.
  return dot(surface.normal, rest) < -ROUNDING * lengthOf(rest.x, rest.y) && isGround(character, surface, position);
}

/** The vertical wall that a slope is besides where it is too steep to walk on; it leaves the character where it is. */
function asWall(character: Character, surface: Surface, position: Vector2): Surface[] {
  const { up, right } = character;
  const sideways = dot(surface.normal, right);
  if (dot(surface.normal, up) <= 0 || sideways === 0) return [];
  const normal = plus(ZERO, right, Math.sign(sideways));
  return [{ ...surface, normal, offset: dot(normal, position) }];
}

/**
 * A velocity over the ground, without an upward part: zero if a wall is in the way along the ground. A wall that leans over the
 * character stops it as another does: to turn it down, as in the air, would press it into the ground, step after step.
 */
export function stoppedOnGround(
  { right }: Character,
  velocity: Vector2,
  ground: Surface,
  walls: readonly Surface[],
): Vector2 {
  const speed = dot(velocity, right);
  const along = { x: ground.normal.y * speed, y: -ground.normal.x * speed };
  return walls.some(({ normal }) => dot(normal, along) < -ROUNDING * Math.abs(speed)) ? ZERO : velocity;
}

/** A velocity in the air, without its parts into the surfaces that a character touches and that are no ground. */
export function stopped(
  character: Character,
  position: Vector2,
  velocity: Vector2,
  walls: readonly Surface[],
): Vector2 {
  const surfaces = walls.flatMap((surface) => [...asWall(character, surface, position), surface]);
  return surfaces.reduce((v, { normal }) => plus(v, normal, -Math.min(dot(v, normal), 0)), velocity);
}

// What a character moves along: surfaces, each as a line beyond which its body or wall lies.
//
//   n · p ≥ c        p  position of the character    n  unit normal    c  offset, with the character's margin
//
// A convex body lies on one side of the line through its nearest point, perpendicular to the shortest distance: a character
// that stays on the other side does not enter it. Source: the mover of Box2D 3 (mover.c), whose planes these are.

/** A point or a vector in the plane. */
export interface Vector2 {
  readonly x: number;
  readonly y: number;
}

/** A surface of a body or a wall. */
export interface Surface {
  /** Entity id of the body, the part or the wall; 0 for a wall of `boxWalls` that is no entity. */
  readonly id: number;
  readonly isWall: boolean;
  /** Point on the surface, m. */
  readonly point: Vector2;
  /** Unit normal, towards the character. */
  readonly normal: Vector2;
  /** The least that normal · position may be, m. */
  readonly offset: number;
}

export const ZERO: Vector2 = { x: 0, y: 0 };

export function dot(a: Vector2, b: Vector2): number {
  return a.x * b.x + a.y * b.y;
}

/** a + factor b */
export function plus(a: Vector2, b: Vector2, factor = 1): Vector2 {
  return { x: a.x + factor * b.x, y: a.y + factor * b.y };
}

/** How far a character at `position` is from a surface beyond its margin, m; negative where it is too near. */
export function gapTo({ normal, offset }: Surface, position: Vector2): number {
  return dot(normal, position) - offset;
}

/**
 * Kinds of shape a renderer can draw for a body, as stored in `BodySource.shape`. Every shape fills the body's drawn
 * radius: a disc of that radius, or a square of that half-width.
 */
export const SHAPES = {
  /** Filled disc; what a body is drawn as when nobody says otherwise. */
  disc: 0,
  /** Circle outline. */
  ring: 1,
  /** Filled square with half-width `size`, turned by the body's angle. */
  box: 2,
  /** Filled disc with one radius drawn on it, so that rotation can be seen. */
  markedDisc: 3,
  /** Soft round spot, brightest at the centre and zero at the rim; meant for additive blending. */
  glow: 4,
} as const;

/** Name of a shape kind. */
export type ShapeName = keyof typeof SHAPES;

/** Number of a shape kind. */
export type ShapeKind = (typeof SHAPES)[ShapeName];

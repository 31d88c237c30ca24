/**
 * Kinds of shape a renderer can draw for a body, as stored in `BodySource.shape`. Every shape fills the body's drawn
 * radius: a disc of that radius, or a square of that half-width. Where the collider has another shape than a disc, `disc`, `ring` and `markedDisc`
 * draw that shape.
 */
export const SHAPES = {
  /** Filled disc, or the filled shape of the collider; the default. */
  disc: 0,
  /** Outline of the disc or of the collider. */
  ring: 1,
  /** Filled square with half-width `size`, rotated by the body's angle. */
  box: 2,
  /** Filled disc with a radius drawn on it, which makes rotation visible. */
  markedDisc: 3,
  /** Soft round spot, brightest at the centre and zero at the rim; meant for additive blending. */
  glow: 4,
} as const;

/** Name of a shape kind. */
export type ShapeName = keyof typeof SHAPES;

/** Number of a shape kind. */
export type ShapeKind = (typeof SHAPES)[ShapeName];

import type { VectorInput } from '../../../errors/validate.ts';
import type { PhysicsWorld } from '../../../world/types.ts';

/** Kinds of shapes, as kernels/collision/shapes/2d/shape.ts numbers them. */
export const ShapeKind = { circle: 0, capsule: 1, polygon: 2, segment: 3 } as const;

/**
 * A convex shape of two dimensions: all points within `radius` of a point, a segment or a polygon. It is an immutable
 * value that any number of bodies and worlds may use. Its frame is that of a body: the origin is its centroid.
 */
export interface Shape {
  readonly kind: keyof typeof ShapeKind;
  /** x and y of each vertex, m, anticlockwise: one of a circle, two of a capsule or a segment, up to eight of a polygon. */
  readonly vertices: readonly number[];
  /** x and y of the unit outward normal of the edge from each vertex to the next. */
  readonly normals: readonly number[];
  /** Radius of a circle or of the caps of a capsule, rounding of a polygon, m. */
  readonly radius: number;
  /** Area, m²; 0 for a segment. */
  readonly area: number;
  /** Moment of inertia about the centroid for each kilogram, m². */
  readonly inertiaPerMass: number;
  /** Greatest distance of the surface from the centroid, m. */
  readonly extent: number;
  /** Least distance of the surface from the centroid, m. */
  readonly minExtent: number;
  /** Of a segment of a chain: x and y of the far ends of its neighbours, the one before and the one after. */
  readonly neighbours?: readonly number[] | undefined;
  /** Centroid in the coordinates of the points that made the shape, m. */
  readonly centre: { readonly x: number; readonly y: number };
}

/** A point as shapes are made from. */
export type PointInput = Pick<VectorInput, 'x' | 'y'>;

/** What `spawn` does with a shape. */
export interface ShapeFunctions {
  /** Puts a shape into the pool of a world and returns its index. */
  store(world: PhysicsWorld, shape: Shape): number;
  /** Gives the hull of a body that is spawned the half height of its shape, unless it has one. */
  completeHull(body: Record<string, unknown>, shape: Shape): void;
}

/** `spawn` finds the functions by the shape, so that a game without shapes does not contain them. */
const functions = new WeakMap<object, ShapeFunctions>();

/** Declares that an object is a shape, with which these functions deal. */
export function registerShape(shape: Shape, itsFunctions: ShapeFunctions): void {
  functions.set(shape, itsFunctions);
}

/** Returns whether a value was made by `circle`, `box`, `capsule`, `polygon`, `segment` or `chain`. */
export function isShape(value: unknown): value is Shape {
  return typeof value === 'object' && value !== null && functions.has(value);
}

/**
 * Returns the index of a shape in the pool of a world, to which it is added unless an equal one is there.
 * @throws PhysicsError E_CAPACITY when the world's memory is full
 */
export function storeShape(world: PhysicsWorld, shape: Shape): number {
  return functions.get(shape)?.store(world, shape) ?? 0;
}

/** Gives the hull of a body that is spawned the half height of its shape, unless it has one. */
export function completeHull(body: Record<string, unknown>, shape: Shape): void {
  functions.get(shape)?.completeHull(body, shape);
}

/** Length of a vector. */
export function lengthOf(x: number, y: number): number {
  return Math.sqrt(x * x + y * y);
}

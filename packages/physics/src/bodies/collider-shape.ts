// Computes the radius of a collider, and the mass and inertia of its body, from the shape and density given to `spawn`.
import { completeHull, isShape, type Shape } from '../collision/shapes/2d/shape.ts';
import { shapeAt, shapePool } from '../collision/shapes/shape-pool.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkNumber, isRecord, mustBe } from '../errors/validate.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { ballInertia, ballMass, discInertia, discMass } from './inertia.ts';

/** Shape and density, which are no columns of `Collider`. */
export interface ShapeInput {
  /**
   * Shape of two dimensions: `circle`, `box`, `capsule`, `polygon` or `segment`, or the index of a shape that the world
   * has. Default a disc or ball of `radius`.
   */
  readonly shape?: Shape | number;
  /**
   * Mass by area, kg/m² (in 3D by volume, kg/m³), from which mass and inertia follow unless they are given beside the
   * collider: a mass that is given counts, and the density does not. Default none: a body without mass is not moved.
   */
  readonly density?: number;
}

type Input = Readonly<Record<string, unknown>>;

/** An input without shape and density. */
export interface ResolvedInput<Body> {
  readonly body: Body;
  /** The shape to store in the shape pool once everything is checked. */
  readonly shape: Shape | undefined;
}

/**
 * Replaces shape and density by what follows from them. A body with a shape turns, so that it also gets `Rotation` and,
 * if it has mass, `AngularVelocity`; give `inertia: Infinity` to one that must not turn. Among rigid bodies a disc with mass
 * is one, whether it has a density or not.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function resolveShape<Body extends object>(world: PhysicsWorld, body: Body): ResolvedInput<Body> {
  const { collider } = body as Input;
  if (!isRecord(collider) || (collider.shape === undefined && collider.density === undefined)) {
    return { body: isRigidDisc(world, body) ? turning(body) : body, shape: undefined };
  }
  const { shape: given, density, ...fields } = collider;
  const shape = given === undefined || given === 0 ? undefined : checkShape(world, given, 'collider.shape');
  if (shape !== undefined && fields.radius !== undefined) {
    throw new PhysicsError('E_RANGE', 'collider has both a shape and a radius.', {
      field: 'collider.radius',
      value: fields.radius,
      hint: 'The radius follows from the shape: leave one of the two out.',
    });
  }
  const radius = shape?.extent ?? fields.radius ?? 0.5;
  const isSolid = shape !== undefined || density !== undefined;
  const missing = isSolid ? missingOf(world, body as Input, solidOf(world, shape, radius), density) : {};
  // An object that gets them afterwards takes engines five times as long.
  const resolved: Record<string, unknown> = { ...missing, ...body, collider: { ...fields, radius } };
  for (const key of Object.keys(missing)) resolved[key] ??= missing[key];
  if (shape !== undefined) completeHull(resolved, shape);
  return { body: resolved as Body, shape };
}

/** Whether a body without a shape is a disc of rigid bodies, which turns. */
function isRigidDisc(world: PhysicsWorld, body: object): boolean {
  const { mass, collider } = body as Input;
  return world.dimensions === 2 && isSoftStep(world.integrator) && mass !== undefined && collider !== undefined;
}

/** A disc with what it needs to turn. Masses and radii may be lists; what is wrong with them is said where they are checked. */
function turning<Body extends object>(body: Body): Body {
  const { mass, collider } = body as Input;
  const masses = (isRecord(mass) ? mass.value : mass) ?? 1;
  const radii = (isRecord(collider) ? collider.radius : collider) ?? 0.5;
  const each = (values: unknown, i: number) => (typeof values === 'number' ? values : (values as ArrayLike<number>)[i]);
  const lists = [masses, radii].filter((values) => typeof values !== 'number') as ArrayLike<number>[];
  const inertias = Array.from({ length: lists[0]?.length ?? 1 }, (_, i) => {
    const radius = each(radii, i);
    return 0.5 * each(masses, i) * radius * radius;
  });
  if (!inertias.every((inertia) => inertia > 0 && inertia < Infinity)) return body;
  return { rotation: {}, angularVelocity: {}, inertia: lists.length === 0 ? inertias[0] : inertias, ...body };
}

/**
 * Returns the shape that a caller gave, as a value or as an index.
 * @throws PhysicsError E_TYPE, E_RANGE
 */
export function checkShape(world: PhysicsWorld, given: unknown, field: string): Shape {
  const shape = typeof given === 'number' ? shapeAt(world, given) : given;
  if (typeof given === 'number' && shape === undefined) {
    throw mustBe(`an index of the ${shapePool(world).count - 1} shapes of this world`, given, field, 'E_RANGE');
  }
  if (Array.isArray(given)) {
    throw new PhysicsError('E_TYPE', `${field} must be one shape, got an array.`, {
      field,
      value: given,
      hint: 'Make the segments of a chain by spawnChain(world, points), and other parts by spawnCompound.',
    });
  }
  if (!isShape(shape)) throw mustBe('a shape such as box(1, 0.5)', given, field);
  if (world.dimensions === 3) {
    throw new PhysicsError('E_RANGE', `${field} is of two dimensions and the world of three.`, {
      field,
      hint: 'Make the world with `dimensions: 2`, or give the collider a radius.',
    });
  }
  return shape;
}

/** Mass for each unit of density, and inertia for each unit of mass. */
export interface Solid {
  readonly massPerDensity: number;
  readonly inertiaPerMass: number;
}

/** Mass and inertia of a shape, or of a disc or ball of a radius. @throws PhysicsError E_TYPE, E_NONFINITE */
export function solidOf(world: PhysicsWorld, shape: Shape | undefined, radius: unknown): Solid {
  if (shape !== undefined) return { massPerDensity: shape.area, inertiaPerMass: shape.inertiaPerMass };
  const checked = checkNumber(radius, 'collider.radius');
  return world.dimensions === 3
    ? { massPerDensity: ballMass(1, checked), inertiaPerMass: ballInertia(1, checked) }
    : { massPerDensity: discMass(1, checked), inertiaPerMass: discInertia(1, checked) };
}

/** The mass that follows from a density, and what a body with a shape turns by. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE */
function missingOf(world: PhysicsWorld, body: Input, solid: Solid, density: unknown): Record<string, unknown> {
  let { mass } = body;
  if (density !== undefined) {
    const checked = checkNumber(density, 'collider.density', { above: 0, max: 1e38 });
    if (solid.massPerDensity === 0) {
      throw new PhysicsError('E_RANGE', 'collider.density is given for a segment, which has no area.', {
        field: 'collider.density',
        value: density,
        hint: 'Leave it out, or give the body a mass.',
      });
    }
    mass ??= checked * solid.massPerDensity;
  }
  const turn = world.dimensions === 2 ? 'rotation' : 'orientation';
  if (mass === undefined) return { [turn]: {} };
  const value = (isRecord(mass) ? mass.value : mass) ?? 1;
  return { mass, [turn]: {}, inertia: scaled(value, solid.inertiaPerMass), angularVelocity: {} };
}

/** The product of a number or of each number of a list; what is neither is refused where the mass itself is checked. */
function scaled(mass: unknown, factor: number): unknown {
  if (typeof mass === 'number') return mass * factor;
  return Array.from(mass as ArrayLike<number>, (value) => value * factor);
}

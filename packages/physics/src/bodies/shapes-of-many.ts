// The shapes of many bodies: one for all of them, or one for each.
import { completeHull, type Shape, storeShape } from '../collision/shapes/2d/shape.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkNumber, isRecord } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { checkShape, resolveShape } from './collider-shape.ts';
import type { ComponentValues, ManyInput } from './many.ts';

/** An input without shapes and density. */
export interface ResolvedMany {
  readonly body: ManyInput;
  /** The shapes to store in the shape pool once everything is checked, one for all bodies or one for each. */
  readonly shapes: Shape | readonly Shape[] | undefined;
}

/**
 * Replaces shapes and density by what follows from them, as `resolveShape` does.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function resolveShapes(world: PhysicsWorld, values: ManyInput, count: number): ResolvedMany {
  const { collider } = values as Readonly<Record<string, unknown>>;
  if (!isRecord(collider) || !Array.isArray(collider.shape)) {
    const { body, shape } = resolveShape(world, values);
    return { body, shapes: shape };
  }
  const { shape: given, density, ...fields } = collider;
  if (given.length !== count) {
    throw new PhysicsError('E_RANGE', `collider.shape has ${given.length} shapes for ${count} bodies.`, {
      field: 'collider.shape',
    });
  }
  if (fields.radius !== undefined) {
    throw new PhysicsError('E_RANGE', 'collider has both shapes and a radius.', {
      field: 'collider.radius',
      hint: 'The radius follows from the shape: leave one of the two out.',
    });
  }
  const shapes = given.map((shape, i) => checkShape(world, shape, `collider.shape[${i}]`));
  const radius = shapes.map(({ extent }) => extent);
  const missing: Record<string, unknown> = { rotation: {}, ...massesOf(values, shapes, density) };
  const body: Record<string, unknown> = {
    ...missing,
    ...values,
    ...hullsOf(values, shapes),
    collider: { ...fields, radius },
  };
  for (const key of Object.keys(missing)) body[key] ??= missing[key];
  return { body: body as ManyInput, shapes };
}

/** What bodies have that a mass or a density moves. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE */
function massesOf({ mass }: ManyInput, shapes: readonly Shape[], density: unknown): Record<string, unknown> {
  if (mass === undefined && density === undefined) return {};
  const masses = mass ?? areasOf(shapes).map((area) => area * checkNumber(density, 'collider.density', BOUNDS));
  const values: unknown = (isRecord(masses) ? masses.value : masses) ?? 1;
  const at = (i: number) => (typeof values === 'number' ? values : (values as ArrayLike<number>)[i]);
  return { mass: masses, inertia: shapes.map(({ inertiaPerMass }, i) => at(i) * inertiaPerMass), angularVelocity: {} };
}

const BOUNDS = { above: 0, max: 1e38 };

/** @throws PhysicsError E_RANGE */
function areasOf(shapes: readonly Shape[]): number[] {
  const flat = shapes.findIndex(({ area }) => area === 0);
  if (flat < 0) return shapes.map(({ area }) => area);
  throw new PhysicsError(
    'E_RANGE',
    `collider.density is given, and collider.shape[${flat}] is a segment, without area.`,
    {
      field: 'collider.density',
      hint: 'Leave it out, or give the bodies a mass.',
    },
  );
}

/** Hulls get the half height and the volume of the shape of their body, unless they have some. */
function hullsOf({ hull }: ManyInput, shapes: readonly Shape[]): { hull?: object } {
  if (hull === undefined || hull === null) return {};
  const hulls = shapes.map((shape) => {
    const body: { hull: { halfHeight?: number; volume?: number } } = { hull: {} };
    completeHull(body, shape);
    return body.hull;
  });
  const halfHeight = hulls.map((each) => each.halfHeight ?? 0);
  const volume = hulls.map((each) => each.volume ?? 0);
  return { hull: { halfHeight, volume, ...(isRecord(hull) ? hull : { volume: hull }) } };
}

/** Returns the values with the indices of shapes, which are stored, in those of the collider. @throws PhysicsError E_CAPACITY */
export function withShapes(
  world: PhysicsWorld,
  components: readonly ComponentValues[],
  shapes: Shape | readonly Shape[],
): ComponentValues[] {
  const store = (shape: Shape) => storeShape(world, shape);
  const indices = 'extent' in shapes ? store(shapes) : Float64Array.from(shapes, store);
  const setIndex = ({ name, fields }: ComponentValues): ComponentValues => ({
    name,
    fields: fields.map(([field, column]) => [field, field === 'shape' ? indices : column] as const),
  });
  return components.map((component) => (component.name === 'Collider' ? setIndex(component) : component));
}

// A character as the functions of this folder see it: its checked options, its shape, and which way is up.
import { circle } from '../collision/shapes/2d/circle.ts';
import { lengthOf, type PointInput, type Shape } from '../collision/shapes/2d/shape.ts';
import { shapeAt } from '../collision/shapes/shape-pool.ts';
import { assertBody } from '../ecs/entity-ref.ts';
import { isOpen } from '../ecs/rows.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, checkNumber, checkVector } from '../errors/validate.ts';
import { cos, sin } from '../math/elementary.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { dot, type Vector2, ZERO } from './surface.ts';

/** Options of `moveCharacter`. */
export interface CharacterOptions {
  /** Direction in which the character stands, of any length; default { y: 1 }. */
  readonly up?: PointInput;
  /** Steepest slope on which it stands and walks, radians from the horizontal; default 0.9, which is 52°. */
  readonly maxSlope?: number;
  /** Highest step that it climbs, m; default half the radius of its shape. */
  readonly stepHeight?: number;
  /** How far the ground may fall away in a step without the character leaving it, m; default `stepHeight`. */
  readonly snapDistance?: number;
  /** Distance that it keeps from everything, m, at least 1 mm; default a thirtieth of the radius. */
  readonly margin?: number;
}

/** A character during a call. */
export interface Character {
  readonly world: PhysicsWorld;
  readonly id: number;
  /** Length of the step, s. */
  readonly dt: number;
  readonly shape: Shape;
  /** The shape without its radius. */
  readonly core: Shape;
  readonly angle: number;
  /** Unit vectors: up, and what is to the right of that. */
  readonly up: Vector2;
  readonly right: Vector2;
  /** Least upward part of the normal of ground. */
  readonly minUpward: number;
  readonly stepHeight: number;
  readonly snapDistance: number;
  readonly margin: number;
  /** How far the shape reaches down from the position, m. */
  readonly depth: number;
  /** Velocity of the ground, m/s, with which the character rides along; zero in the air. */
  readonly groundVelocity: Vector2;
}

/** Casts end when surfaces are 0.1 mm apart, so that less than this cannot be kept. */
const MIN_MARGIN = 1e-3;

/** What is steeper is a wall. */
const MAX_SLOPE = 1.5;

const LENGTH = { min: 0, max: 1e6 };

/**
 * Checks a body and options.
 * @throws PhysicsError E_STALE, E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function checkCharacter(world: PhysicsWorld, id: number, dt: number, options: CharacterOptions): Character {
  assertBody(world, id);
  assertKinematic(world, id);
  checkKeys(options, 'moveCharacter', ['up', 'maxSlope', 'stepHeight', 'snapDistance', 'margin']);
  const shape = roundShapeOf(world, id);
  const { radius } = shape;
  const angle = isOpen(world, id, 'Rotation') ? world.components.Rotation.angle[id] : 0;
  const up = unit(checkVector(options.up ?? { y: 1 }, 'up'));
  const maxSlope = checkNumber(options.maxSlope ?? 0.9, 'maxSlope', { min: 0, max: MAX_SLOPE });
  const stepHeight = checkNumber(options.stepHeight ?? radius / 2, 'stepHeight', LENGTH);
  return {
    world,
    id,
    dt,
    shape,
    core: { ...shape, radius: 0, extent: shape.extent - radius },
    angle,
    up,
    right: { x: up.y, y: -up.x },
    minUpward: cos(maxSlope),
    stepHeight,
    snapDistance: checkNumber(options.snapDistance ?? stepHeight, 'snapDistance', LENGTH),
    margin: checkNumber(options.margin ?? Math.max(radius / 30, MIN_MARGIN), 'margin', { min: MIN_MARGIN, max: 1e6 }),
    depth: depthOf(shape, angle, up),
    groundVelocity: ZERO,
  };
}

/** @throws PhysicsError E_RANGE unless the body moves by its velocity, whatever it meets */
function assertKinematic(world: PhysicsWorld, id: number): void {
  const has = (name: 'Velocity' | 'Collider' | 'Mass' | 'Kinematic') => isOpen(world, id, name);
  if (has('Velocity') && has('Collider') && (!has('Mass') || has('Kinematic'))) return;
  throw new PhysicsError('E_RANGE', `body ${id} is not kinematic, which a character must be.`, {
    entity: id,
    field: 'body',
    value: id,
    hint: 'Give it `velocity: {}`, a `collider` and `kinematic: {}`.',
  });
}

/** @throws PhysicsError E_RANGE for a shape with sharp corners */
function roundShapeOf(world: PhysicsWorld, id: number): Shape {
  const { radius, shape } = world.components.Collider;
  const found = shapeAt(world, shape[id]) ?? circle(radius[id]);
  if (found.radius > 0) return found;
  throw new PhysicsError('E_RANGE', `body ${id} has sharp corners, and a character must be round.`, {
    entity: id,
    field: 'collider.shape',
    value: found.kind,
    hint: 'Give it a capsule, a circle, or a polygon with a radius.',
  });
}

/** @throws PhysicsError E_RANGE for the zero vector */
function unit({ x, y }: Vector2): Vector2 {
  const length = lengthOf(x, y);
  if (length > 0) return { x: x / length, y: y / length };
  throw new PhysicsError('E_RANGE', 'up must not be zero.', { field: 'up', value: 0 });
}

function depthOf({ vertices, radius }: Shape, angle: number, up: Vector2): number {
  const [c, s] = [cos(angle), sin(angle)];
  let depth = -Infinity;
  for (let i = 0; i < vertices.length; i += 2) {
    const [x, y] = [vertices[i], vertices[i + 1]];
    depth = Math.max(depth, -dot(up, { x: c * x - s * y, y: s * x + c * y }));
  }
  return depth + radius;
}

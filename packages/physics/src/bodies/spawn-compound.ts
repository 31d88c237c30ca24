// Bodies of several shapes that move as one.
import { circle } from '../collision/shapes/2d/circle.ts';
import type { Shape } from '../collision/shapes/2d/shape.ts';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkNumber, checkVector, isRecord, mustBe } from '../errors/validate.ts';
import { POSITION_BOUNDS } from '../forces/support/bounds.ts';
import { cos, sin } from '../math/elementary.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { BodyInput } from './body-input.ts';
import { checkShape } from './collider-shape.ts';
import { compoundMass, type MassPart } from './compound-mass.ts';
import { spawn } from './spawn.ts';

/** A shape of a compound body: where it is, its density and how its surface behaves, as in `collider` of `spawn`. */
export type CompoundShape = Exclude<NonNullable<BodyInput['collider']>, number> & {
  /** Position of its centre in the coordinates of the compound, m; default 0. */
  readonly x?: number;
  readonly y?: number;
  /** Its angle, rad; default 0. */
  readonly angle?: number;
  /** How this part looks; default as `appearance` of the compound says. */
  readonly appearance?: BodyInput['appearance'];
};

/** A compound body: its parts, and the other components as for `spawn`. */
export type CompoundInput = Omit<BodyInput, 'collider' | 'attachment'> & { readonly parts: readonly CompoundShape[] };

/** The entities of a compound body. */
export interface Compound {
  /** The body, which has mass and velocity. Its Position is that of the centre of mass. */
  readonly body: number;
  /** The entities of the parts, in the order of the input. */
  readonly parts: readonly number[];
}

/** A part whose pose and shape were checked. */
interface CheckedPart extends MassPart {
  readonly angle: number;
  readonly area: number;
  readonly input: CompoundShape;
}

/**
 * Creates a rigid body of several shapes. `position` and `rotation` are those of the coordinates in which the parts are
 * given; the Position of the body is where its centre of mass is there. Mass, centre and moment of inertia follow from the densities
 * of the parts; with `mass` they are scaled to it, from the areas where no density is given. Without both the body does not
 * move. Each part is an entity with Collider and Attachment, which contact events and queries name; `bodyOf` gives its body,
 * and `despawn` of the body removes all.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_DESTROYED: nothing is made
 */
export function spawnCompound(world: PhysicsWorld, input: CompoundInput): Compound {
  assertUsable(world);
  if (!isRecord(input)) throw mustBe('an object with parts', input, 'spawnCompound');
  const { parts: given, position = {}, rotation = 0, appearance, ...rest } = input;
  const parts = checkParts(world, given);
  const origin = checkVector(position, 'position', POSITION_BOUNDS);
  const angle = checkNumber(isRecord(rotation) ? (rotation.angle ?? 0) : rotation, 'rotation');
  const { components, x, y } = massOf(parts, rest as BodyInput);
  const [c, s] = [cos(angle), sin(angle)];
  ensureCapacity(world, 1 + parts.length);
  const made: number[] = [];
  try {
    const centre = { ...origin, x: origin.x + (c * x - s * y), y: origin.y + (s * x + c * y) };
    made.push(spawn(world, { ...components, position: centre, rotation: angle }));
    for (const part of parts) {
      const [dx, dy] = [part.x - x, part.y - y];
      made.push(
        spawn(world, {
          position: { x: centre.x + (c * dx - s * dy), y: centre.y + (s * dx + c * dy) },
          rotation: angle + part.angle,
          collider: colliderOf(part.input),
          attachment: { body: made[0], x: dx, y: dy, angle: part.angle },
          appearance: part.input.appearance ?? appearance,
        }),
      );
    }
  } catch (error) {
    for (const id of made.reverse()) removeEntityCompletely(world, id);
    throw error;
  }
  const [body, ...ids] = made;
  return { body, parts: ids };
}

function checkParts(world: PhysicsWorld, parts: unknown): CheckedPart[] {
  if (!Array.isArray(parts)) throw mustBe('an array of { shape, x, y, angle, density }', parts, 'parts');
  if (parts.length === 0) {
    throw new PhysicsError('E_RANGE', 'parts is empty.', {
      field: 'parts',
      value: 0,
      hint: 'A compound has at least one part. For a body without a shape use spawn.',
    });
  }
  return Array.from(parts, (part: unknown, i) => checkPart(world, part, `parts[${i}]`));
}

function checkPart(world: PhysicsWorld, part: unknown, field: string): CheckedPart {
  if (!isRecord(part)) throw mustBe('{ shape, x, y, angle, density }', part, field);
  const shape = shapeOf(world, part, field);
  const [x, y, angle] = (['x', 'y', 'angle'] as const).map((key) =>
    checkNumber(part[key] ?? 0, `${field}.${key}`, POSITION_BOUNDS),
  );
  const { density } = part;
  const checked = density === undefined ? 0 : checkNumber(density, `${field}.density`, { above: 0, max: 1e38 });
  if (checked > 0 && shape.area === 0) {
    throw new PhysicsError('E_RANGE', `${field}.density is given for a segment, which has no area.`, {
      field: `${field}.density`,
      value: density,
      hint: 'Leave it out: the other parts have the mass.',
    });
  }
  const { area, inertiaPerMass } = shape;
  return { x, y, angle, area, mass: checked * area, inertiaPerMass, input: part as CompoundShape };
}

function shapeOf(world: PhysicsWorld, part: Readonly<Record<string, unknown>>, field: string): Shape {
  if (part.shape !== undefined && part.shape !== 0) {
    if (part.radius === undefined) return checkShape(world, part.shape, `${field}.shape`);
    throw new PhysicsError('E_RANGE', `${field} has both a shape and a radius.`, {
      field: `${field}.radius`,
      value: part.radius,
      hint: 'The radius follows from the shape: leave one of the two out.',
    });
  }
  if (world.dimensions === 2) return circle((part.radius ?? 0.5) as number);
  throw new PhysicsError('E_RANGE', 'compound bodies are of two dimensions, and this world has three.', {
    field: 'parts',
    hint: 'Make the world with `dimensions: 2`.',
  });
}

/** The fields of Collider of a part: all but its pose, its density and its looks. */
function colliderOf({
  x,
  y,
  angle,
  density,
  appearance,
  ...collider
}: CompoundShape): NonNullable<BodyInput['collider']> {
  return collider;
}

/** The components of the body that follow from its mass, and its centre in the coordinates of the parts. */
function massOf(parts: readonly CheckedPart[], given: BodyInput) {
  const sum = compoundMass(parts);
  const mass = isRecord(given.mass) ? given.mass.value : given.mass;
  if (mass === undefined && sum.mass === 0) return { components: given, x: 0, y: 0 };
  const weights = sum.mass > 0 ? sum : compoundMass(parts.map((part) => ({ ...part, mass: part.area })));
  const scale = typeof mass === 'number' && weights.mass > 0 ? mass / weights.mass : 1;
  const inertia = weights.inertia * scale;
  const components = { angularVelocity: 0, inertia, ...given, mass: given.mass ?? weights.mass };
  return { components, x: weights.x, y: weights.y };
}

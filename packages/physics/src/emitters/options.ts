import { MAX_POSITION } from '../components/position.ts';
import { MAX_SPEED } from '../components/velocity.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import {
  checkChoice,
  checkKeys,
  checkNumber,
  checkVector,
  checkWhole,
  mustBe,
  type VectorInput,
} from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { MAX_RAMPS, MAX_STOPS } from './record.ts';

/** Lifetimes are kept in f32, where less becomes 0, which marks a free place: such particles would never end. */
const MIN_LIFETIME = 1e-37;

/** A number, or a range from which each particle draws a value. */
export type Range = number | readonly [min: number, max: number];

/** The parameters of an emitter, which can be changed at any time. */
export interface EmitterParameters {
  /** Position of births, m. Default the origin. */
  readonly position?: VectorInput;
  /** Particles born per second, 1/s. Default 0: bursts only. */
  readonly rate?: number;
  /** Lifetime of a particle, s, 1e-37 to 1e9. Default 1. */
  readonly lifetime?: Range;
  /** Speed at birth, m/s. Default 1. */
  readonly speed?: Range;
  /** Mean direction at birth, of any length. Default upwards. */
  readonly direction?: VectorInput;
  /** Half-angle about the direction, rad: 0 is a jet, π (the default) is all directions. */
  readonly spread?: number;
  /** Half extent of the box about the position in which births are distributed uniformly, m. Default none. */
  readonly positionSpread?: VectorInput;
  /** Half range of a uniform random velocity, per axis, m/s. Default none. */
  readonly velocitySpread?: VectorInput;
  /** From the followed body to the place of births, m, such as a nozzle; see `frame`. Default none. */
  readonly offset?: VectorInput;
  /** Fraction of the emitter's velocity that particles inherit; a nozzle also moves as its body turns. Default 0. */
  readonly inheritVelocity?: number;
  /** Mass of a particle, kg. Default 1. */
  readonly mass?: number;
  /**
   * Colour (see `rgba`), or a ramp of 2 to 4 colours over a particle's life, or up to 8 ramps to draw from. Default 0:
   * that of the layer.
   */
  readonly color?: number | readonly number[] | readonly (readonly number[])[];
  /** Drawn radius, m, or a ramp of 2 to 4 radii over a life. Default 0: the radius of the collider. */
  readonly size?: number | readonly number[];
  /** Random factor of each particle's size. Default 1. */
  readonly sizeFactor?: Range;
}

/** The options of a new emitter. */
export interface EmitterOptions extends EmitterParameters {
  /** Maximum number of living particles. Their entities are created now and reused. */
  readonly capacity: number;
  /**
   * A body at whose position particles are born, instead of `position`; the emitter stops when the body is removed.
   * Default none.
   */
  readonly entity?: number;
  /**
   * Frame of the direction, the offset, both spreads and the patterns of bursts: 'world' (default), or 'entity', which
   * turns with the Rotation or Orientation of the followed body.
   */
  readonly frame?: 'world' | 'entity';
  /**
   * Behaviour when the pool is full: 'skip' (default) drops the birth and counts it as dropped, 'oldest' ends the
   * oldest particle.
   */
  readonly whenFull?: 'skip' | 'oldest';
  /** Coefficient of linear drag, kg/s. Default none. */
  readonly linearDrag?: number;
  /** Coefficient of quadratic drag, kg/m. Default none. */
  readonly quadraticDrag?: number;
  /** Electric charge of a particle, C. Default none. */
  readonly charge?: number;
  /** Factor of the acceleration by `uniformGravity()`, negative for smoke that rises. Default 1. */
  readonly gravityScale?: number;
  /** A round collider for living particles. Default none. */
  readonly collider?: {
    readonly radius: number;
    /** Default 0. */
    readonly restitution?: number;
    /** Default 0. */
    readonly friction?: number;
    /** Layers that it is on, bits; default 1. */
    readonly layers?: number;
    /** Layers that it collides with, bits; default all. A mask without its own layers lets particles pass through each other. */
    readonly mask?: number;
    /** Rigid bodies of one group collide with each other always if it is positive, and never if it is negative. Default 0. */
    readonly group?: number;
  };
  /** Whether mutual forces act on the particles and not back: see the component TestParticle. Default false. */
  readonly testParticle?: boolean;
  /** Kind of shape to draw; 0, the default, is a disc or ball. */
  readonly shape?: number;
  /** Record ended particles and their states for `endings`. Default false. */
  readonly reportEndings?: boolean;
}

const PARAMETERS = [
  'position',
  'rate',
  'lifetime',
  'speed',
  'direction',
  'spread',
  'positionSpread',
  'velocitySpread',
  'offset',
  'inheritVelocity',
  'mass',
  'color',
  'size',
  'sizeFactor',
] as const;

const FIXED = [
  'capacity',
  'entity',
  'frame',
  'whenFull',
  'linearDrag',
  'quadraticDrag',
  'charge',
  'gravityScale',
  'collider',
  'testParticle',
  'shape',
  'reportEndings',
] as const;

const COLLIDER = ['radius', 'restitution', 'friction', 'layers', 'mask', 'group'];

type Triple = readonly [x: number, y: number, z: number];

/** The validated parameters in the layout of the record. */
export interface CheckedParameters {
  readonly position: Triple;
  readonly offset: Triple;
  /** All numbers from the rate on, in the record's order. */
  readonly numbers: readonly number[];
  readonly ramps: readonly (readonly number[])[];
}

/** Refuses an offset and a frame without a body. @throws PhysicsError E_TYPE, E_RANGE */
export function checkFollows({ offset, frame = 'world', entity }: EmitterParameters & Partial<EmitterOptions>): void {
  checkChoice(frame, 'frame', ['world', 'entity']);
  if (entity !== undefined) return;
  const field = offset !== undefined ? 'offset' : frame === 'entity' ? 'frame' : undefined;
  if (field === undefined) return;
  throw new PhysicsError(
    'E_RANGE',
    `${field} belongs to the body that an emitter follows, and this one follows none.`,
    {
      field,
      hint: 'Make the emitter with `entity`.',
    },
  );
}

/** Refuses unknown options. @throws PhysicsError E_TYPE, E_UNKNOWN */
export function checkOptionNames(options: unknown, caller: string, live: boolean): void {
  checkKeys(options, caller, live ? PARAMETERS : [...PARAMETERS, ...FIXED]);
  const { collider } = options as EmitterOptions;
  if (collider !== undefined) checkKeys(collider, 'collider', COLLIDER);
}

/** Returns the options that can be changed later. */
export function parametersOf(options: EmitterParameters): EmitterParameters {
  return Object.fromEntries(
    PARAMETERS.filter((name) => options[name] !== undefined).map((name) => [name, options[name]]),
  );
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function checkParameters(world: PhysicsWorld, options: EmitterParameters): CheckedParameters {
  const positionBounds = { min: -MAX_POSITION, max: MAX_POSITION };
  const velocityBounds = { min: -MAX_SPEED, max: MAX_SPEED };
  return {
    position: checkPosition(world, options.position ?? {}, 'position', positionBounds),
    offset: checkPosition(world, options.offset ?? {}, 'offset', positionBounds),
    numbers: [
      checkNumber(options.rate ?? 0, 'rate', { min: 0, max: 1e9 }),
      ...range(options.lifetime ?? 1, 'lifetime', { min: MIN_LIFETIME, max: 1e9 }),
      ...range(options.speed ?? 1, 'speed', { min: 0, max: MAX_SPEED }),
      ...normalise(checkPosition(world, options.direction ?? { y: 1 }, 'direction')),
      checkNumber(options.spread ?? Math.PI, 'spread', { min: 0, max: Math.PI }),
      ...checkPosition(world, options.positionSpread ?? {}, 'positionSpread', positionBounds),
      ...checkPosition(world, options.velocitySpread ?? {}, 'velocitySpread', velocityBounds),
      checkNumber(options.inheritVelocity ?? 0, 'inheritVelocity', { min: -10, max: 10 }),
      checkNumber(options.mass ?? 1, 'mass', { above: 0, max: 1e38 }),
      ...range(options.sizeFactor ?? 1, 'sizeFactor', { min: 0, max: 1e6 }),
      ...sizeRamp(options.size ?? 0),
    ],
    ramps: colorRamps(options.color ?? 0),
  };
}

function checkPosition(world: PhysicsWorld, value: VectorInput, field: string, bounds = {}): Triple {
  const { x, y, z } = checkVector(value, field, bounds);
  if (world.dimensions === 2) checkNumber(z, `${field}.z`, { min: 0, max: 0 });
  return [x, y, z];
}

function range(value: unknown, field: string, bounds: Parameters<typeof checkNumber>[2]): readonly [number, number] {
  if (!Array.isArray(value)) {
    const both = checkNumber(value, field, bounds);
    return [both, both];
  }
  if (value.length !== 2) throw mustBe('a number or [min, max]', value, field, 'E_RANGE');
  const min = checkNumber(value[0], `${field}[0]`, bounds);
  return [min, checkNumber(value[1], `${field}[1]`, { ...bounds, min })];
}

function normalise(direction: Triple): Triple {
  // Scaled first, so that no square overflows.
  const largest = Math.max(...direction.map(Math.abs));
  if (largest === 0) throw mustBe('a vector other than zero', 0, 'direction', 'E_RANGE');
  const [x, y, z] = direction.map((component) => component / largest);
  const norm = Math.sqrt(x * x + y * y + z * z);
  return [x / norm, y / norm, z / norm];
}

function colorRamps(color: NonNullable<EmitterParameters['color']>): readonly (readonly number[])[] {
  const lists = Array.isArray(color) ? (Array.isArray(color[0]) ? color : [color]) : [[color]];
  if (lists.length > MAX_RAMPS) {
    throw mustBe(`at most ${MAX_RAMPS} lists of colours`, color, 'color', 'E_RANGE');
  }
  for (const list of lists) {
    if (!Array.isArray(list) || list.length < 1 || list.length > MAX_STOPS) {
      throw mustBe(`a colour, or lists of 1 to ${MAX_STOPS} colours`, color, 'color', 'E_RANGE');
    }
    for (const each of list) checkWhole(each, 'color', 0, 0xffffffff);
  }
  return lists as readonly (readonly number[])[];
}

function sizeRamp(size: number | readonly number[]): readonly number[] {
  const list = Array.isArray(size) ? size : [size];
  if (list.length < 1 || list.length > MAX_STOPS) {
    throw mustBe(`1 to ${MAX_STOPS} radii`, size, 'size', 'E_RANGE');
  }
  for (const each of list) checkNumber(each, 'size', { min: 0, max: 1e12 });
  return list;
}

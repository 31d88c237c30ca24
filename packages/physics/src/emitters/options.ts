import { MAX_POSITION } from '../components/position.ts';
import { MAX_SPEED } from '../components/velocity.ts';
import { checkKeys, checkNumber, checkVector, checkWhole, mustBe, type VectorInput } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { MAX_RAMPS, MAX_STOPS } from './record.ts';

/** A number, or a range within which each particle draws its own. */
export type Range = number | readonly [min: number, max: number];

/** What an emitter can be told at any time. */
export interface EmitterParameters {
  /** Where particles are born, m. Default the origin. */
  readonly position?: VectorInput;
  /** Particles born a second, 1/s. Default 0: bursts only. */
  readonly rate?: number;
  /** How long a particle lives, s. Default 1. */
  readonly lifetime?: Range;
  /** Speed at birth, m/s. Default 1. */
  readonly speed?: Range;
  /** Mean direction at birth; any length. Default upwards. */
  readonly direction?: VectorInput;
  /** Half-angle about the direction, rad: 0 a jet, π (the default) all around. */
  readonly spread?: number;
  /** Births are spread uniformly over a box of this half size about the position, m. Default none. */
  readonly positionSpread?: VectorInput;
  /** Each axis of the velocity gets up to this much more or less, m/s. Default none. */
  readonly velocitySpread?: VectorInput;
  /** Part of the emitter's own velocity that particles are born with. Default 0. */
  readonly inheritVelocity?: number;
  /** Mass of a particle, kg. Default 1. */
  readonly mass?: number;
  /** Colour (see `rgba`), or 2 to 4 colours that a particle passes through in its life, or up to 8 such lists to draw from. */
  readonly color?: number | readonly number[] | readonly (readonly number[])[];
  /** Drawn radius, m, or 2 to 4 radii passed through in a life. Default 0: as large as the collider. */
  readonly size?: number | readonly number[];
  /** Each particle's size is multiplied by one number of this range. Default 1. */
  readonly sizeFactor?: Range;
}

/** How an emitter is made. */
export interface EmitterOptions extends EmitterParameters {
  /** Most particles alive at once. Their entities are made now, and never again. */
  readonly capacity: number;
  /** A body to be born at, instead of `position`; when it goes the emitter stops. */
  readonly entity?: number;
  /** A birth that finds no room: 'skip' (default) drops it and counts it as lost, 'oldest' ends the oldest particle. */
  readonly whenFull?: 'skip' | 'oldest';
  /** Coefficient of linear drag, kg/s. Default none. */
  readonly linearDrag?: number;
  /** Coefficient of quadratic drag, kg/m. Default none. */
  readonly quadraticDrag?: number;
  /** A round collider for living particles. Default none. */
  readonly collider?: { readonly radius: number; readonly restitution?: number; readonly friction?: number };
  /** Kind of shape to draw; 0, the default, is a disc or ball. */
  readonly shape?: number;
  /** Keep who ended in a step, and where, for `endings`. */
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
  'inheritVelocity',
  'mass',
  'color',
  'size',
  'sizeFactor',
] as const;

const FIXED = [
  'capacity',
  'entity',
  'whenFull',
  'linearDrag',
  'quadraticDrag',
  'collider',
  'shape',
  'reportEndings',
] as const;

type Triple = readonly [x: number, y: number, z: number];

/** The parameters as the record takes them. */
export interface CheckedParameters {
  readonly position: Triple;
  /** All numbers from the rate on, in the record's order. */
  readonly numbers: readonly number[];
  readonly ramps: readonly (readonly number[])[];
}

/** Refuses keys that are not options. @throws PhysicsError E_TYPE, E_UNKNOWN */
export function checkOptionNames(options: unknown, caller: string, live: boolean): void {
  checkKeys(options, caller, live ? PARAMETERS : [...PARAMETERS, ...FIXED]);
  const { collider } = options as EmitterOptions;
  if (collider !== undefined) checkKeys(collider, 'collider', ['radius', 'restitution', 'friction']);
}

/** The options that may change later. */
export function parametersOf(options: EmitterParameters): EmitterParameters {
  return Object.fromEntries(
    PARAMETERS.filter((name) => options[name] !== undefined).map((name) => [name, options[name]]),
  );
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function checkParameters(world: PhysicsWorld, options: EmitterParameters): CheckedParameters {
  const anywhere = { min: -MAX_POSITION, max: MAX_POSITION };
  const speeds = { min: -MAX_SPEED, max: MAX_SPEED };
  return {
    position: place(world, options.position ?? {}, 'position', anywhere),
    numbers: [
      checkNumber(options.rate ?? 0, 'rate', { min: 0, max: 1e9 }),
      ...range(options.lifetime ?? 1, 'lifetime', { above: 0, max: 1e9 }),
      ...range(options.speed ?? 1, 'speed', { min: 0, max: MAX_SPEED }),
      ...unit(place(world, options.direction ?? { y: 1 }, 'direction')),
      checkNumber(options.spread ?? Math.PI, 'spread', { min: 0, max: Math.PI }),
      ...place(world, options.positionSpread ?? {}, 'positionSpread', anywhere),
      ...place(world, options.velocitySpread ?? {}, 'velocitySpread', speeds),
      checkNumber(options.inheritVelocity ?? 0, 'inheritVelocity', { min: -10, max: 10 }),
      checkNumber(options.mass ?? 1, 'mass', { above: 0, max: 1e38 }),
      ...range(options.sizeFactor ?? 1, 'sizeFactor', { min: 0, max: 1e6 }),
      ...sizeRamp(options.size ?? 0),
    ],
    ramps: colorRamps(options.color ?? 0),
  };
}

function place(world: PhysicsWorld, value: VectorInput, field: string, bounds = {}): Triple {
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

function unit(direction: Triple): Triple {
  // Scaled first, so that no square leaves the range of numbers.
  const most = Math.max(...direction.map(Math.abs));
  if (most === 0) throw mustBe('a vector that is not zero', 0, 'direction', 'E_RANGE');
  const [x, y, z] = direction.map((part) => part / most);
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

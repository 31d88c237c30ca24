// A fluid with a level surface, and the immersed fraction of a body in it.
import { PhysicsError } from '../../errors/physics-error.ts';
import { checkKeys, checkNumber, checkVector, type Vector, type VectorInput } from '../../errors/validate.ts';
import { type Scalar, select, type Vector as VectorSymbol } from '../../laws/expression.ts';
import { scalar, vector } from '../../laws/parameter.ts';
import { ANY, POSITION_BOUNDS, POSITIVE, VELOCITY_BOUNDS } from './bounds.ts';
import { STANDARD_GRAVITY } from './standard-gravity.ts';
import { unit } from './unit-vector.ts';
import { type Waves, type WaveValues, waveHeightOf, waveValues } from './waves.ts';

/** A body of water, or the air if there is no level. Give the same record to all forces of a fluid. */
export interface FluidVolume {
  /** Density ρ, kg/m³. */
  readonly density: number;
  /** Gravity, m/s²; default standard gravity downwards. It defines the upward direction. */
  readonly gravity?: VectorInput;
  /**
   * Height of the surface along up, m: its y if gravity points down. By default the fluid is unbounded. It is read once, as all of the
   * fluid: the surface rises where its forces are replaced, `replaceForce(world, buoyancy({ ...fluid, level }))`.
   */
  readonly level?: number;
  /** Velocity of the fluid, m/s; default at rest. Read by `immersedDrag`, and at a surface by `addedMass`: buoyancy does not depend on it. */
  readonly flow?: VectorInput;
  /**
   * Waves on the surface, which then needs a level, on deep water: `{ amplitude, length, direction?, phase? }`, m and rad. Default none;
   * `surfaceHeight(fluid, position, time)` tells where to draw it.
   */
  readonly waves?: Waves;
}

/**
 * Parameters of laws of a fluid: magnitude of gravity, and the unit vector against it. The values are validated
 * before.
 */
export const FLUID = /* @__PURE__ */ { density: scalar('kg/m³'), gravity: scalar('m/s²'), up: vector('') };

/** Parameters of laws of a fluid with a surface. */
export const FLUID_VOLUME = /* @__PURE__ */ { ...FLUID, level: scalar('m') };

/** The validated values of these parameters. */
export interface FluidVolumeValues {
  readonly fluid: { readonly density: number; readonly gravity: number; readonly up: Vector };
  readonly level: number | undefined;
  readonly flow: Vector;
  readonly waves: WaveValues | undefined;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function fluidVolumeValues(fluidVolume: FluidVolume, caller: string): FluidVolumeValues {
  checkKeys(fluidVolume, caller, ['density', 'gravity', 'level', 'flow', 'waves']);
  const density = checkNumber(fluidVolume.density, `${caller}.density`, POSITIVE);
  const given = checkVector(fluidVolume.gravity ?? { y: -STANDARD_GRAVITY }, `${caller}.gravity`, ANY);
  const down = unit(given, `${caller}.gravity`);
  const gravity = given.x * down.x + given.y * down.y + given.z * down.z;
  // 0 - x instead of -x, which may be -0.
  const up = { x: 0 - down.x, y: 0 - down.y, z: 0 - down.z };
  const level =
    fluidVolume.level === undefined ? undefined : checkNumber(fluidVolume.level, `${caller}.level`, POSITION_BOUNDS);
  const flow = checkVector(fluidVolume.flow ?? {}, `${caller}.flow`, VELOCITY_BOUNDS);
  const waves = fluidVolume.waves === undefined ? undefined : waveValues(fluidVolume.waves, up, gravity, caller);
  if (waves !== undefined && level === undefined) {
    throw new PhysicsError('E_RANGE', `${caller}.waves need a surface.`, {
      field: `${caller}.level`,
      value: level,
      hint: 'Give the fluid a `level` as well.',
    });
  }
  return { fluid: { density, gravity, up }, level, flow, waves };
}

/** The columns of a body that can float: reads `{ hull: Hull, collider: Collider }`. */
export interface HullSymbols {
  readonly position: VectorSymbol;
  readonly hull: { readonly volume: Scalar; readonly halfHeight: Scalar; readonly shape: Scalar };
  readonly collider: { readonly radius: Scalar };
}

/** The surface of a fluid. */
export interface SurfaceSymbols {
  readonly up: VectorSymbol;
  readonly level: Scalar;
}

/** The immersion of a body. */
export interface Immersion {
  /** Depth of the centre, m. */
  readonly depth: Scalar;
  /** Half the body's height, m. */
  readonly half: Scalar;
  /** Depth over half height, from -1 to 1. */
  readonly relative: Scalar;
  /** Immersed fraction of the volume. */
  readonly immersedFraction: Scalar;
  /** By how much this fraction grows with depth, 1/m; zero wholly in or out of the fluid. */
  readonly growth: Scalar;
}

/** Computes the immersion. Shape 0 is a sphere; all others count as an upright box. */
export function immersion(body: HullSymbols, { up, level }: SurfaceSymbols): Immersion {
  return immersionAt(level.sub(up.dot(body.position)), body);
}

/** The same where the centre of the body is at this depth. */
export function immersionAt(depth: Scalar, { hull, collider }: Omit<HullSymbols, 'position'>): Immersion {
  const half = select(hull.halfHeight.greater(0), hull.halfHeight, collider.radius);
  // A point is either in or out.
  const ofPoint = select(depth.greater(0), 1, -1);
  const d = select(half.greater(0), depth.div(half).min(1).max(-1), ofPoint);
  const isSphere = hull.shape.equals(0);
  const ofSphere = d.mul(d.square().negate().add(3)).mul(0.25).add(0.5);
  const slope = select(isSphere, d.square().negate().add(1).mul(0.75), 0.5);
  return {
    depth,
    half,
    relative: d,
    immersedFraction: select(isSphere, ofSphere, d.mul(0.5).add(0.5)),
    growth: select(d.abs().less(1), slope.div(half), 0),
  };
}

/**
 * The height of the surface of a fluid with waves along up at a position, m, for drawing it: its level where there are none.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, also without a level, E_UNKNOWN
 */
export function surfaceHeight(fluidVolume: FluidVolume, position: VectorInput, time: number): number {
  const { level, waves } = fluidVolumeValues(fluidVolume, 'surfaceHeight');
  const at = checkVector(position, 'surfaceHeight.position', POSITION_BOUNDS);
  checkNumber(time, 'surfaceHeight.time');
  const height = checkNumber(level, 'surfaceHeight.level');
  return waves === undefined ? height : height + waveHeightOf(waves, at, time);
}

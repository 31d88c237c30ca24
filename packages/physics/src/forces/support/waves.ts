// Waves on deep water, in the linear theory of Airy: of a surface that rises by η above its level,
//
//   η = a cos θ        θ = k·x - ω t + φ        ω² = g k        velocity of the fluid  u = a ω e^(k z) (cos θ, sin θ)
//
//   a  amplitude, m    k  wave number 2π/length, 1/m    z  height above the level, at most 0    (along the waves, up)
//
// The pressure of a wave pushes what it surrounds as it pushes the fluid: -∇p/ρ = g up + Du/Dt, where Du/Dt = ∂u/∂t + k u² up. A hull is
// taken to be much shorter than the waves, so that the surface about it is a plane.
// Airy, Tides and Waves (1845); Lamb, Hydrodynamics, section 229; Newman, Marine Hydrodynamics, section 6.
import { PhysicsError } from '../../errors/physics-error.ts';
import { checkKeys, checkNumber, checkVector, type Vector, type VectorInput } from '../../errors/validate.ts';
import type { Scalar, Vector as VectorSymbol } from '../../laws/expression.ts';
import { scalar, vector, vectorOverTime } from '../../laws/parameter.ts';
import { cos } from '../../math/elementary.ts';
import { ANY, LENGTH_BOUNDS, NOT_NEGATIVE } from './bounds.ts';
import { unit } from './unit-vector.ts';

/** Waves of one length on a fluid with a level. */
export interface Waves {
  /** Height of a crest above the level, m: at most a fourteenth of the length, above which waves break. */
  readonly amplitude: number;
  /** From crest to crest, m. */
  readonly length: number;
  /** Where they go, along the surface; default x. */
  readonly direction?: VectorInput;
  /** Phase at the origin at time 0, rad; default 0, a crest. */
  readonly phase?: number;
}

/** Parameters of laws of a fluid with waves. */
export const WAVES = /* @__PURE__ */ {
  /** Unit vector along which they go. */
  along: vector(''),
  waveNumber: scalar('1/m'),
  amplitude: scalar('m'),
  /** Angular frequency ω, rad/s. */
  frequency: scalar('rad/s'),
  /** ω t - φ, less whole turns, in x: single precision would lose it after some hours. */
  turned: vectorOverTime('rad'),
};

/** The values of these parameters. */
export interface WaveValues {
  readonly along: Vector;
  readonly waveNumber: number;
  readonly amplitude: number;
  readonly frequency: number;
  readonly turned: (time: number) => Vector;
}

const TURN = 2 * Math.PI;

/** A wave whose height from trough to crest is more than a seventh of its length breaks: Michell, On the Highest Waves in Water (1893). */
const STEEPEST = 1 / 14;

/**
 * @param up unit vector against gravity, of which `gravity` is the magnitude, m/s²
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function waveValues(waves: Waves, up: Vector, gravity: number, caller: string): WaveValues {
  checkKeys(waves, `${caller}.waves`, ['amplitude', 'length', 'direction', 'phase']);
  const length = checkNumber(waves.length, `${caller}.waves.length`, LENGTH_BOUNDS);
  const amplitude = checkNumber(waves.amplitude, `${caller}.waves.amplitude`, NOT_NEGATIVE);
  if (amplitude > STEEPEST * length) {
    throw new PhysicsError('E_RANGE', `${caller}.waves: waves of ${amplitude} m on ${length} m break.`, {
      field: `${caller}.waves.amplitude`,
      value: amplitude,
      hint: `Give an amplitude of at most length / 14, ${Number((STEEPEST * length).toPrecision(3))} m.`,
    });
  }
  const phase = checkNumber(waves.phase ?? 0, `${caller}.waves.phase`, ANY);
  const given = checkVector(waves.direction ?? { x: 1 }, `${caller}.waves.direction`, ANY);
  const rise = given.x * up.x + given.y * up.y + given.z * up.z;
  const level = { x: given.x - rise * up.x, y: given.y - rise * up.y, z: given.z - rise * up.z };
  const waveNumber = TURN / length;
  const frequency = Math.sqrt(gravity * waveNumber);
  return {
    along: unit(level, `${caller}.waves.direction along the surface`),
    waveNumber,
    amplitude,
    frequency,
    turned: turnedBy(frequency, phase),
  };
}

function turnedBy(frequency: number, phase: number): (time: number) => Vector {
  const turned = { x: 0, y: 0, z: 0 };
  return (time) => {
    turned.x = (frequency * time - phase) % TURN;
    return turned;
  };
}

/** The symbols of a fluid with waves. */
interface WaveSymbols {
  readonly up: VectorSymbol;
  readonly level: Scalar;
  readonly along: VectorSymbol;
  readonly waveNumber: Scalar;
  readonly amplitude: Scalar;
  readonly frequency: Scalar;
  readonly turned: VectorSymbol;
}

/** The fluid about a body. */
export interface LocalWave {
  /** Unit normal of the surface above the body. */
  readonly normal: VectorSymbol;
  /** Depth of the centre of the body under this surface, along the normal, m. */
  readonly depth: Scalar;
  /** Velocity of the fluid where the body is, m/s. */
  readonly velocity: VectorSymbol;
  /** Its acceleration, m/s². */
  readonly acceleration: VectorSymbol;
}

/** Computes the wave at a position. */
export function waveAt(position: VectorSymbol, fluid: WaveSymbols): LocalWave {
  const { up, along, waveNumber: k, amplitude, frequency } = fluid;
  const angle = along.dot(position).mul(k).sub(fluid.turned.x);
  const [c, s] = [angle.cos(), angle.sin()];
  const depth = fluid.level.sub(up.dot(position));
  const speed = amplitude.mul(frequency).mul(depth.max(0).mul(k).negate().exp());
  const slope = amplitude.mul(k).mul(s).negate();
  const cosine = slope.square().add(1).sqrt();
  return {
    normal: up.sub(along.mul(slope)).div(cosine),
    depth: depth.add(amplitude.mul(c)).div(cosine),
    velocity: along.mul(c).add(up.mul(s)).mul(speed),
    acceleration: along
      .mul(s)
      .sub(up.mul(c))
      .mul(speed.mul(frequency))
      .add(up.mul(speed.square().mul(k))),
  };
}

/** The height of waves above the level at a position and time, m. */
export function waveHeightOf({ along, waveNumber, amplitude, turned }: WaveValues, at: Vector, time: number): number {
  return amplitude * cos(waveNumber * (along.x * at.x + along.y * at.y + along.z * at.z) - turned(time).x);
}

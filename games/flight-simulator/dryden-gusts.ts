/**
 * Turbulence by Dryden, frozen in the air through which the aeroplane flies.
 *
 *   Φ_u = σ_u² (2 L_u/π)/(1 + (L_u Ω)²)        Φ_v,w = σ² (L/π) (1 + 3 (L Ω)²)/(1 + (L Ω)²)²
 *   below 1000 ft: L_w = h, L_u = L_v = h/(0.177 + 0.000823 h)^1.2, σ_u = σ_v = σ_w/(0.177 + 0.000823 h)^0.4, h in ft
 *   Φ_p = (σ_w²/L_w) 0.8 (π L_w/(4 b))^⅓/(1 + (4 b Ω/π)²)
 *
 *   p  rate at which the air rolls over the span b, rad/s
 *   u, v, w  gust along the course, to the right and up, m/s    L  scale, m    Ω  wave number, rad/m    σ  deviation, m/s
 *
 * MIL-F-8785C (1980), sections 3.7.2 and 3.7.3; between 1000 and 2000 ft L rises linearly to 1750 ft. White noise passes the
 * forming filters 1/(1 + T s) and (1 + √3 T s)/(1 + T s)², T = L/V, which are stepped exactly: with z = dt/T, e = e^(−z),
 *   p' = e p + …,  q' = e (q + z p) + …,  v = σ (√3 p + (1 − √3) q)/√2
 * with noise of the covariance [[1 − e², c], [c, d]], c = (1 − e² (1 + 2z))/2, d = (1 − e² (1 + 2z + 2z²))/2. Over the length of
 * the aeroplane the gust is the same: the pitching and yawing gusts of the specification are left out.
 */
import { createRandom, exp, keepState, type PhysicsWorld, pow, type Random } from '@principia/physics';
import { AIRCRAFT } from './aircraft.ts';
import type { Axes } from './body-frame.ts';

const FOOT = 0.3048;
const [LOWEST, LOW, MEDIUM, MEDIUM_SCALE] = [10, 1000, 2000, 1750];
/** An aeroplane at rest feels the field drift past at this speed at least, m/s. */
const SLOWEST = 5;
const ROOT_3 = Math.sqrt(3);

export interface Turbulence {
  /** Scales along and across the course, and vertically, m. */
  level: number;
  vertical: number;
  /** Deviation along and across the course, per vertical deviation. */
  ratio: number;
}

/** Scales and ratio at a height above the ground, m. */
export function turbulenceAt(height: number, out: Turbulence): Turbulence {
  const feet = Math.min(MEDIUM, Math.max(LOWEST, height / FOOT));
  const low = Math.min(LOW, feet);
  const base = 0.177 + 0.000823 * low;
  const above = ((MEDIUM_SCALE - LOW) * Math.max(0, feet - LOW)) / (MEDIUM - LOW);
  out.level = FOOT * (low / pow(base, 1.2) + above);
  out.vertical = FOOT * (low + above);
  out.ratio = 1 / pow(base, 0.4);
  return out;
}

/** Deviation of the rolling gusts per deviation of the vertical ones, rad/m: the root of ∫ Φ_p dΩ over all Ω. */
export function rollDeviation(verticalScale: number): number {
  const { span } = AIRCRAFT;
  const ratio = pow((Math.PI * verticalScale) / (4 * span), 1 / 3);
  return Math.PI * Math.sqrt((0.1 * ratio) / (span * verticalScale));
}

/** Length over which the rolling gusts forget, 4 b/π, m. */
const ROLL_SCALE = (4 * AIRCRAFT.span) / Math.PI;

/** Gusts along one flight. */
export class DrydenGusts {
  /** Mean wind and gust, m/s: at the beginning of the present step and at its end. */
  readonly #before: Axes;
  readonly #after: Axes;
  /** When the present step began and how long it takes, s. */
  readonly #step = new Float64Array([0, 1]);
  readonly #wind: Axes;
  readonly #mean: Readonly<Axes>;
  readonly #deviation: number;
  readonly #random: Random;
  /** Filters of unit variance: u; p and q of v; p and q of w. */
  readonly #filters = new Float64Array(5);
  /** The filter of unit variance of the rolling gust, and the gust, rad/s; from random numbers of their own. */
  readonly #rolling = new Float64Array(2);
  readonly #rollRandom: Random;
  readonly #turbulence: Turbulence = { level: 1, vertical: 1, ratio: 1 };

  /** @param deviation of the vertical gusts, m/s */
  constructor(mean: Readonly<Axes>, deviation: number, seed: number) {
    this.#mean = mean;
    this.#before = { ...mean };
    this.#after = { ...mean };
    this.#wind = { ...mean };
    this.#deviation = deviation;
    this.#random = createRandom(seed, 7);
    const draw = () => this.#random.gaussian();
    // In the steady state p has the variance 1, q ½, and their covariance is ½.
    const pair = () => {
      const p = draw();
      return [p, 0.5 * p + 0.5 * draw()];
    };
    this.#filters.set([draw(), ...pair(), ...pair()]);
    this.#rollRandom = createRandom(seed, 8);
    this.#rolling[0] = this.#rollRandom.gaussian();
  }

  /** Lets snapshots of a world bring the gusts back. */
  keep(world: PhysicsWorld): this {
    keepState(world, this.#filters, this.#random.state, this.#before, this.#after, this.#step);
    keepState(world, this.#rolling, this.#rollRandom.state);
    return this;
  }

  /** Rate at which the air turns about the aeroplane's axis, rad/s, throughout a step. */
  get roll(): number {
    return this.#rolling[1];
  }

  /** Mean wind and gust within the present step, m/s: the same object on every call. */
  at(time: number): Readonly<Axes> {
    const [begin, length] = this.#step;
    const part = (time - begin) / length;
    const [before, after, wind] = [this.#before, this.#after, this.#wind];
    // The end of a step has the bits that the beginning of the next has.
    if (part > 1 - 1e-6) return after;
    if (part < 1e-6) return before;
    wind.x = before.x + (after.x - before.x) * part;
    wind.y = before.y + (after.y - before.y) * part;
    wind.z = before.z + (after.z - before.z) * part;
    return wind;
  }

  /**
   * Moves the gusts by one step.
   * @param time at its beginning, s @param height above the ground, m @param airspeed m/s @param along x and z of the course, a level unit vector
   */
  step(time: number, dt: number, height: number, airspeed: number, alongX: number, alongZ: number): void {
    const { level, vertical, ratio } = turbulenceAt(height, this.#turbulence);
    const [filters, random, speed] = [this.#filters, this.#random, Math.max(SLOWEST, airspeed)];
    const kept = exp((-dt * speed) / level);
    filters[0] = kept * filters[0] + Math.sqrt(1 - kept * kept) * random.gaussian();
    stepPair(filters, 1, (dt * speed) / level, random);
    stepPair(filters, 3, (dt * speed) / vertical, random);
    const rolling = this.#rolling;
    const same = exp((-dt * speed) / ROLL_SCALE);
    rolling[0] = same * rolling[0] + Math.sqrt(1 - same * same) * this.#rollRandom.gaussian();
    rolling[1] = this.#deviation * rollDeviation(vertical) * rolling[0];
    const sideways = ratio * this.#deviation;
    const [u, v] = [sideways * filters[0], sideways * across(filters, 1)];
    const [mean, before, after] = [this.#mean, this.#before, this.#after];
    this.#step[0] = time;
    this.#step[1] = dt;
    before.x = after.x;
    before.y = after.y;
    before.z = after.z;
    after.x = mean.x + u * alongX - v * alongZ;
    after.y = mean.y + this.#deviation * across(filters, 3);
    after.z = mean.z + u * alongZ + v * alongX;
  }
}

function across(filters: Float64Array, at: number): number {
  return (ROOT_3 * filters[at] + (1 - ROOT_3) * filters[at + 1]) / Math.SQRT2;
}

/** @param z step per time of the filter */
function stepPair(filters: Float64Array, at: number, z: number, random: Random): void {
  const e = exp(-z);
  const square = e * e;
  const pp = 1 - square;
  const pq = (1 - square * (1 + 2 * z)) / 2;
  const qq = (1 - square * (1 + 2 * z + 2 * z * z)) / 2;
  const [first, second] = [random.gaussian(), random.gaussian()];
  const [p, q] = [filters[at], filters[at + 1]];
  const root = Math.sqrt(pp);
  filters[at] = e * p + root * first;
  // The square root of the covariance, by Cholesky; rounding may leave a little less than nothing.
  filters[at + 1] = e * (q + z * p) + (pq / root) * first + Math.sqrt(Math.max(0, qq - (pq * pq) / pp)) * second;
}

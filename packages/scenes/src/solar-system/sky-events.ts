// Conjunctions, oppositions and transits as seen from the centre of the Earth, found by stepping a solar system of its own.
//
// A body is seen where it was when its light left, τ = d/c ago: d = P − v τ − E. Aberration by the Earth's motion shifts
// neighbours alike. A conjunction is where two longitudes in the ecliptic of J2000 are equal, an opposition where planet and
// Sun are half a circle apart, and a transit an inferior conjunction in which the centres come closer than the Sun's angular
// radius; its date is that of the least distance. Between steps of two days positions are cubic (Hermite): Mercury is then
// within 60 km of its path, h⁴ n⁴ a/384. Times are TDB, 64 s ahead of UTC in 2000 and 69 s in 2020.
// Meeus, Astronomical Algorithms, chapters 17, 33 and 36.
import { atan2, gaussRadau, step } from '@principia/physics';
import { buildSolarSystem, type SolarState, type SolarSystem } from './build.ts';
import { BODY_NAMES, type BodyName, EPOCH, SPEED_OF_LIGHT, STATES } from './states.ts';

/** A transit or another inferior conjunction, a superior conjunction, an opposition, or a conjunction of two planets. */
export type SkyEventKind = 'transit' | 'inferior' | 'superior' | 'opposition' | 'meeting';

/** Something that is seen in the sky from the centre of the Earth. */
export interface SkyEvent {
  readonly kind: SkyEventKind;
  readonly body: BodyName;
  /** Of a meeting, the planet that is farther from the Sun. Default none. */
  readonly other?: BodyName;
  /** TDB. */
  readonly julianDate: number;
  /** Angle between the centres of the two, or of planet and Sun, rad. */
  readonly separation: number;
  /** Distance of the first body from the Earth, km. */
  readonly distance: number;
}

const DAY = 86400;
const STEP = 2 * DAY;
const PLANETS = ['mercury', 'venus', 'mars', 'jupiter', 'saturn', 'uranus', 'neptune'] as const;
/** Those that the eye sees meet. */
const BRIGHT = PLANETS.slice(0, 5);
const BISECTIONS = 40;

/** A pair whose difference of longitudes is watched, and the longitude's difference that counts. */
interface Watch {
  readonly body: BodyName;
  readonly other: BodyName;
  readonly isOpposite: boolean;
}

const WATCHES: readonly Watch[] = [
  ...PLANETS.map((body): Watch => ({ body, other: 'sun', isOpposite: false })),
  ...PLANETS.slice(2).map((body): Watch => ({ body, other: 'sun', isOpposite: true })),
  ...BRIGHT.flatMap((body, i) => BRIGHT.slice(i + 1).map((other): Watch => ({ body, other, isOpposite: false }))),
];

type State = Pick<SolarState, 'position' | 'velocity'>;

/** Position, velocity at the beginning and the end of a step: twelve numbers a body. */
const FIELDS = 12;
const indexOf = (name: BodyName) => FIELDS * BODY_NAMES.indexOf(name);

/** Finds conjunctions, oppositions and transits one after the other, by stepping a solar system of its own. */
export class SkyEventFinder {
  readonly #system: SolarSystem;
  readonly #ends = new Float64Array(FIELDS * BODY_NAMES.length);
  readonly #differences = new Float64Array(WATCHES.length);
  readonly #seen = new Float64Array(3);
  readonly #with = new Float64Array(3);
  /** Seconds since noon of 1 January 2000. */
  #time = 0;

  /** @param moon false: the Earth is the centre of mass of Earth and Moon, from which a transit looks up to 17″ different */
  constructor(moon = true) {
    this.#system = buildSolarSystem({ moon, integrator: gaussRadau() });
    this.#start();
  }

  /** The date up to which all events were found. */
  get julianDate(): number {
    return EPOCH + this.#time / DAY;
  }

  /** Starts at another date. @param stateOf the bodies then: ecliptic axes, km, km/s */
  begin(julianDate: number, stateOf: (name: BodyName) => State): void {
    const { Position, Velocity } = this.#system.world.components;
    for (const name of BODY_NAMES) {
      const id = this.#system.ids[name];
      if (id === undefined) continue;
      const { position, velocity } = stateOf(name);
      for (const axis of ['x', 'y', 'z'] as const) {
        Position[axis][id] = position[axis];
        Velocity[axis][id] = velocity[axis];
      }
    }
    this.#system.world.versions.pose++;
    this.#time = (julianDate - EPOCH) * DAY;
    this.#start();
  }

  /** Takes a step of two days. @returns the events in it, by date */
  advance(): SkyEvent[] {
    this.#read(0);
    step(this.#system.world, STEP);
    this.#read(6);
    const found: SkyEvent[] = [];
    for (const [i, watch] of WATCHES.entries()) {
      const before = this.#differences[i];
      const after = this.#difference(watch, 1);
      this.#differences[i] = after;
      // A jump of a whole turn is no crossing.
      if (before <= 0 === after <= 0 || Math.abs(before - after) > 1) continue;
      found.push(this.#eventOf(watch, this.#crossing(watch, before)));
    }
    this.#time += STEP;
    return found.sort((a, b) => a.julianDate - b.julianDate);
  }

  #start(): void {
    this.#read(0);
    this.#read(6);
    for (const [i, watch] of WATCHES.entries()) this.#differences[i] = this.#difference(watch, 0);
  }

  #read(offset: 0 | 6): void {
    const { Position, Velocity } = this.#system.world.components;
    for (const name of BODY_NAMES) {
      const id = this.#system.ids[name];
      if (id === undefined) continue;
      const at = indexOf(name) + offset;
      for (const [k, axis] of (['x', 'y', 'z'] as const).entries()) {
        this.#ends[at + k] = Position[axis][id];
        this.#ends[at + 3 + k] = Velocity[axis][id];
      }
    }
  }

  /** Position of a body at a part of the step. */
  #place(name: BodyName, part: number, axis: number): number {
    const at = indexOf(name) + axis;
    const ends = this.#ends;
    const [p, v, q, w] = [ends[at], STEP * ends[at + 3], ends[at + 6], STEP * ends[at + 9]];
    const s = part;
    return p + s * (v + s * (3 * (q - p) - 2 * v - w + s * (2 * (p - q) + v + w)));
  }

  /** From the Earth to where a body is seen, km. @returns its distance */
  #look(name: BodyName, part: number, out: Float64Array): number {
    const ends = this.#ends;
    let square = 0;
    for (let k = 0; k < 3; k++) {
      out[k] = this.#place(name, part, k) - this.#place('earth', part, k);
      square += out[k] * out[k];
    }
    const delay = Math.sqrt(square) / SPEED_OF_LIGHT;
    const at = indexOf(name);
    square = 0;
    for (let k = 0; k < 3; k++) {
      out[k] -= delay * (ends[at + 3 + k] + part * (ends[at + 9 + k] - ends[at + 3 + k]));
      square += out[k] * out[k];
    }
    return Math.sqrt(square);
  }

  /** Difference of the longitudes of a pair, or from half a circle, −π to π. */
  #difference({ body, other, isOpposite }: Watch, part: number): number {
    const [a, b] = [this.#seen, this.#with];
    this.#look(body, part, a);
    this.#look(other, part, b);
    const sign = isOpposite ? -1 : 1;
    return atan2(sign * (a[1] * b[0] - a[0] * b[1]), sign * (a[0] * b[0] + a[1] * b[1]));
  }

  /** The part of the step at which the difference is zero. */
  #crossing(watch: Watch, before: number): number {
    let [from, to] = [0, 1];
    for (let i = 0; i < BISECTIONS; i++) {
      const middle = (from + to) / 2;
      if (this.#difference(watch, middle) <= 0 === before <= 0) from = middle;
      else to = middle;
    }
    return (from + to) / 2;
  }

  #separation({ body, other }: Watch, part: number): number {
    const [a, b] = [this.#seen, this.#with];
    this.#look(body, part, a);
    this.#look(other, part, b);
    const x = a[1] * b[2] - a[2] * b[1];
    const y = a[2] * b[0] - a[0] * b[2];
    const z = a[0] * b[1] - a[1] * b[0];
    return atan2(Math.sqrt(x * x + y * y + z * z), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  }

  #eventOf(watch: Watch, crossing: number): SkyEvent {
    const { body, other, isOpposite } = watch;
    const event = (kind: SkyEventKind, part: number): SkyEvent => ({
      kind,
      body,
      ...(kind === 'meeting' ? { other } : {}),
      julianDate: this.julianDate + (part * STEP) / DAY,
      separation: this.#separation(watch, part),
      distance: this.#look(body, part, this.#seen),
    });
    if (isOpposite) return event('opposition', crossing);
    if (other !== 'sun') return event('meeting', crossing);
    const toSun = this.#look('sun', crossing, this.#with);
    if (this.#look(body, crossing, this.#seen) > toSun) return event('superior', crossing);
    const closest = this.#closest(watch, crossing);
    const radius = STATES.sun.radius;
    const sunRadius = atan2(radius, Math.sqrt(toSun * toSun - radius * radius));
    return this.#separation(watch, closest) < sunRadius ? event('transit', closest) : event('inferior', crossing);
  }

  /** Where the angle is least, within half a day of a conjunction; golden section would save half of these thirds. */
  #closest(watch: Watch, crossing: number): number {
    let [from, to] = [crossing - 0.25, crossing + 0.25];
    for (let i = 0; i < BISECTIONS; i++) {
      const third = (to - from) / 3;
      if (this.#separation(watch, from + third) < this.#separation(watch, to - third)) to -= third;
      else from += third;
    }
    return (from + to) / 2;
  }
}

/** The time of the solar system: how fast it runs, how far a step may go, and what limits it. */
import { EPOCH } from '@principia/scenes';
import type { Pacer } from './time-lapse.ts';

export const DAY = 86400;
export const YEAR = 365.25 * DAY;

/** Simulated seconds per second: the range of the slider. */
export const RATES = { min: 1, max: 100 * YEAR, initial: 5 * DAY } as const;

/**
 * Longest simulated time of a step, s. Gauss-Radau resolves the month of the Moon, or the year of Mercury, by steps of its
 * own, so its limits are those of computing time: 2 to 3 ms a step. The map takes equal steps of 4 days.
 */
const MAX_WITH_MOON = 12 * DAY;
const MAX_WITHOUT_MOON = 24 * DAY;
const MAP_STEP = 4 * DAY;
const MAX_BY_MAP = 153 * MAP_STEP;

/** A journey to another date may take longer steps, since nothing is played meanwhile. */
const MAX_TRAVEL = 60 * DAY;

/** Intervals of a step while a probe is close to a planet; time slows down there. */
const MAX_INTERVALS = 16;

/** Why time runs slower than asked for. */
export type Limit = 'none' | 'moon' | 'scheme' | 'encounter';

export interface ClockHooks {
  readonly hasMoon: boolean;
  /** Whether time stands still, as while a launch is prepared. */
  stands(): boolean;
  /** Whether a probe flies. */
  hasProbe(): boolean;
  /** The longest interval that resolves the motion of the probe, s. */
  encounterLimit(): number;
  /** The next date at which an interval must end, s; infinite without one. */
  nextStop(now: number, direction: number): number;
  /** Called after each interval, at the date that was reached. */
  reached(now: number, interval: number): void;
  /** Called when a journey has come to its end. */
  arrived(direction: number): void;
}

const [NOW, RATE, DESTINATION, DIRECTION, CARRIED, ACTUAL] = [0, 1, 2, 3, 4, 5];

export class SolarClock implements Pacer {
  /** Part of the state of the world. */
  readonly state = new Float64Array(6);
  /** What limited the last step. */
  limit: Limit = 'none';
  usesMap = false;
  readonly #hooks: ClockHooks;
  /** What is left of this step, s, and its intervals so far. */
  readonly #step = new Float64Array(3);

  constructor(hooks: ClockHooks) {
    this.#hooks = hooks;
    this.state[RATE] = RATES.initial;
    this.state[DESTINATION] = Number.NaN;
    this.state[DIRECTION] = 1;
  }

  /** Seconds since noon of 1 January 2000, TDB. */
  get now(): number {
    return this.state[NOW];
  }

  get julianDate(): number {
    return EPOCH + this.state[NOW] / DAY;
  }

  /** Simulated seconds per second that the player wants; 0 stands still. */
  get rate(): number {
    return this.state[RATE];
  }

  set rate(value: number) {
    this.state[RATE] = value;
  }

  /** Simulated seconds per second of the last step. */
  get actualRate(): number {
    return this.state[ACTUAL];
  }

  get isTravelling(): boolean {
    return !Number.isNaN(this.state[DESTINATION]);
  }

  /** Fraction of the journey that is left, as days. */
  get daysToTravel(): number {
    return this.isTravelling ? Math.abs(this.state[DESTINATION] - this.state[NOW]) / DAY : 0;
  }

  /** Starts a journey from a date, both in s since 2000. @param from the date of the bodies */
  travel(from: number, to: number): void {
    this.state[NOW] = from;
    this.state[DIRECTION] = to < from ? -1 : 1;
    this.state[DESTINATION] = to;
    this.state[CARRIED] = 0;
  }

  begin(seconds: number): void {
    const { state } = this;
    const { hasMoon } = this.#hooks;
    this.#step[1] = 0;
    this.#step[2] = seconds;
    this.limit = 'none';
    this.usesMap = false;
    state[ACTUAL] = 0;
    if (this.isTravelling) {
      this.#step[0] = Math.min(MAX_TRAVEL, Math.abs(state[DESTINATION] - state[NOW]));
      if (this.#step[0] === 0) this.#arrive();
      return;
    }
    const wanted = this.#hooks.stands() ? 0 : state[RATE] * seconds;
    this.usesMap = !hasMoon && !this.#hooks.hasProbe() && wanted > MAX_WITHOUT_MOON;
    const most = hasMoon ? MAX_WITH_MOON : this.usesMap ? MAX_BY_MAP : MAX_WITHOUT_MOON;
    if (wanted > 1.001 * most) this.limit = hasMoon ? 'moon' : 'scheme';
    this.#step[0] = Math.min(wanted, most);
    if (!this.usesMap) return;
    // The map wants equal steps: what does not fill one waits for the next frame.
    const sum = this.#step[0] + state[CARRIED];
    this.#step[0] = Math.floor(sum / MAP_STEP) * MAP_STEP;
    state[CARRIED] = sum - this.#step[0];
  }

  next(): number {
    const left = this.#step[0];
    if (!(left > 0)) return 0;
    if (this.usesMap) return MAP_STEP;
    let interval = left;
    if (this.#hooks.hasProbe()) {
      if (this.#step[1] >= MAX_INTERVALS) {
        this.limit = 'encounter';
        return 0;
      }
      interval = Math.min(interval, this.#hooks.encounterLimit());
    }
    const { state } = this;
    const stop = Math.abs(this.#hooks.nextStop(state[NOW], state[DIRECTION]) - state[NOW]);
    return Math.min(interval, stop);
  }

  passed(interval: number): void {
    const { state } = this;
    const stop = this.#hooks.nextStop(state[NOW], state[DIRECTION]);
    const reached = state[NOW] + state[DIRECTION] * interval;
    // An interval that ends at a date reaches it exactly, whatever the rounding.
    state[NOW] = Math.abs(stop - reached) < 1e-3 ? stop : reached;
    this.#step[0] = Math.max(0, this.#step[0] - interval);
    this.#step[1]++;
    state[ACTUAL] += interval / this.#step[2];
    this.#hooks.reached(state[NOW], interval);
    if (this.isTravelling && Math.abs(state[DESTINATION] - state[NOW]) < 1e-3) this.#arrive();
  }

  /** Ends the present step after this interval. */
  stopStep(): void {
    this.#step[0] = 0;
  }

  #arrive(): void {
    const { state } = this;
    state[NOW] = state[DESTINATION];
    state[DESTINATION] = Number.NaN;
    const direction = state[DIRECTION];
    state[DIRECTION] = 1;
    this.#step[0] = 0;
    this.#hooks.arrived(direction);
  }
}

/** The fastest flight past each layout of holes, in the browser's storage; without storage they last as long as the page. */
import type { Hole } from '@principia/scenes';
import { KeptValue, type LocalStore } from '@principia/shell';
import { MAX_SAMPLES, SAMPLE_STEPS } from './flight-record.ts';

export interface BestFlight {
  /** The layout that was flown past, from `layoutKey`. */
  readonly layout: string;
  /** Steps from the launch to the goal. */
  readonly steps: number;
  /** Positions as `FlightRecord` gives them. */
  readonly path: readonly number[];
}

const STORE_KEY = 'principia black hole flights';
/** Most flights that are kept; the ones flown longest ago are forgotten first. A flight takes 1 KB in 10 s. */
export const MAX_FLIGHTS = 40;

export class BestFlights {
  readonly #kept: KeptValue<readonly BestFlight[]>;

  constructor(store?: LocalStore) {
    this.#kept = new KeptValue(STORE_KEY, flightsIn, store);
  }

  /** The fastest flight past a layout; undefined before the first. */
  find(layout: string): BestFlight | undefined {
    return inLayout(this.#kept.value, layout);
  }

  /** Keeps a flight if none past the same layout was as fast. */
  offer(flight: BestFlight): void {
    this.#kept.change((list) => {
      const best = inLayout(list, flight.layout);
      if (best !== undefined && best.steps <= flight.steps) return list;
      return [flight, ...list.filter((other) => other !== best)].slice(0, MAX_FLIGHTS);
    });
  }
}

function inLayout(list: readonly BestFlight[], layout: string): BestFlight | undefined {
  return list.find((flight) => flight.layout === layout);
}

/**
 * A name for holes and the law of their pull: equal for the same level of the same seed, such as that of a day, however
 * often it is played.
 * @param hasFuel whether the tank is limited; flights with more fuel would not compare
 */
export function layoutKey(holes: readonly Hole[], isSteep: boolean, hasFuel: boolean): string {
  // FNV-1a (Fowler, Noll and Vo 1991) over millimetres and milliradians.
  let hash = 0x811c9dc5;
  for (const { x, y, radius, orbit, rate, phase } of holes) {
    for (const value of [x, y, radius, orbit, rate, phase]) {
      hash = Math.imul(hash ^ Math.round(1000 * value), 0x01000193) >>> 0;
    }
  }
  return `${holes.length}-${hash.toString(36)}${isSteep ? ' steep' : ''}${hasFuel ? '' : ' no fuel'}`;
}

/** Invalid data under the same name is ignored. */
function flightsIn(found: unknown): readonly BestFlight[] {
  return Array.isArray(found) ? found.filter(isFlight).slice(0, MAX_FLIGHTS) : [];
}

function isFlight(value: unknown): value is BestFlight {
  const { layout, steps, path } = (value ?? {}) as Record<string, unknown>;
  if (typeof layout !== 'string' || !Number.isInteger(steps) || !Array.isArray(path)) return false;
  const samples = Math.ceil((steps as number) / SAMPLE_STEPS);
  return samples > 0 && samples <= MAX_SAMPLES && path.length === 2 * samples && path.every(Number.isFinite);
}

/** The missions: where to fly, when, and what it may cost. */
import type { BodyName } from '@principia/scenes';
import { julianDate } from './dates.ts';

export interface Mission {
  readonly id: 'mars' | 'mercury' | 'saturn';
  readonly target: BodyName;
  /** The planet whose gravity one needs on the way. */
  readonly via?: BodyName;
  /** Julian date on which the probe is ready. */
  readonly start: number;
  /** Days of flight after which the mission has failed. */
  readonly maxDays: number;
  /** Distance from the target that counts as arrival, km. */
  readonly reach: number;
  /** Sum of all changes of velocity, km/s. */
  readonly budget: number;
  /** A good flight: it gives 1000 points. */
  readonly par: { readonly deltaV: number; readonly days: number };
  /** Distance within which the path must pass the first planet before the help with aiming takes over, km. */
  readonly helpFrom: number;
  /** Where the controls stand at the beginning, km/s: forward, outward, north. This path passes outside `helpFrom`. */
  readonly aim: readonly [number, number, number];
}

export const MISSIONS: readonly Mission[] = [
  {
    id: 'mars',
    target: 'mars',
    start: julianDate(2013, 11, 18),
    maxDays: 420,
    reach: 1e6,
    budget: 6,
    par: { deltaV: 3.5, days: 290 },
    helpFrom: 1e7,
    aim: [2.4, -1.5, 1],
  },
  {
    id: 'mercury',
    target: 'mercury',
    via: 'venus',
    start: julianDate(1973, 11, 3),
    maxDays: 400,
    reach: 2e6,
    budget: 5.5,
    par: { deltaV: 4.7, days: 310 },
    helpFrom: 1e6,
    aim: [-4.4, 0.3, 0.9],
  },
  {
    id: 'saturn',
    target: 'saturn',
    via: 'jupiter',
    start: julianDate(1977, 9, 5),
    maxDays: 1700,
    reach: 5e6,
    budget: 12,
    par: { deltaV: 9.4, days: 1290 },
    helpFrom: 1e7,
    aim: [9.5, 0, 0],
  },
];

/** How far before a planet the help with aiming passes, km, or behind it: near enough to be turned, far enough not to hit. */
export const PASS: Partial<Record<BodyName, number>> = { venus: 2.5e4, jupiter: -7e5 };

export function missionOf(id: string): Mission | undefined {
  return MISSIONS.find((mission) => mission.id === id);
}

/** Points of a flight that arrived: 1000 for par, more for less fuel and less time. */
export function pointsOf({ par }: Mission, deltaV: number, days: number): number {
  const fuel = par.deltaV / Math.max(deltaV, 0.1);
  const time = par.days / Math.max(days, 1);
  return Math.round(600 * Math.min(2, fuel) + 400 * Math.min(2, time));
}

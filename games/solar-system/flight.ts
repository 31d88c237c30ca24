/** The flight of a probe: its changes of velocity, and how close it came to each body. */
import { BODY_NAMES, type BodyName, SOLAR_STATES } from '@principia/scenes';
import { cross, difference, dot, lengthOf, scaled, sum, unit, type Vector } from './vectors.ts';

/** `ready` waits for the launch; `lost` ran out of time. */
export type Phase = 'none' | 'ready' | 'flying' | 'arrived' | 'lost' | 'crashed';

/** A change of velocity: s after the start of the mission, then km/s forward, outward and north. */
export type Burn = readonly [time: number, forward: number, outward: number, north: number];

/** The state of a flight, which is part of the state of the world. */
export interface Flight {
  phase: Phase;
  /** Id of the mission. */
  mission: string;
  /** Entity of the probe; 0 without one. */
  probe: number;
  /** Start of the mission and launch, s since 2000. */
  start: number;
  launch: number;
  /** When the flight ended, s since 2000. */
  end: number;
  /** km/s. */
  deltaV: number;
  burns: Burn[];
  /** Closest approach so far, km, and when, s since 2000; in the order of `BODY_NAMES`. */
  closest: Float64Array;
  closestAt: Float64Array;
  /** The body that was hit, as an index of `BODY_NAMES`; −1 without one. */
  hit: number;
}

export function newFlight(): Flight {
  return {
    phase: 'none',
    mission: '',
    probe: 0,
    start: 0,
    launch: 0,
    end: 0,
    deltaV: 0,
    burns: [],
    closest: new Float64Array(BODY_NAMES.length).fill(Number.POSITIVE_INFINITY),
    closestAt: new Float64Array(BODY_NAMES.length),
    hit: -1,
  };
}

/** Position, km, and velocity, km/s. */
export interface State {
  readonly position: Vector;
  readonly velocity: Vector;
}

/** Distance of the place from which probes start, beyond the Earth as seen from the Sun, km: that of the point L2. */
export const L2_DISTANCE = 1.5e6;

/** The state of a probe that waits at the point L2 of Sun and Earth, with which it goes round the Sun. */
export function waitingState(sun: State, earth: State): State {
  const arm = difference(earth.position, sun.position);
  const factor = L2_DISTANCE / lengthOf(arm);
  const motion = difference(earth.velocity, sun.velocity);
  return { position: sum(earth.position, arm, factor), velocity: sum(earth.velocity, motion, factor) };
}

/**
 * The axes of a change of velocity: forward along the motion about the Sun, outward at right angles to it in the plane of
 * the orbit, and north of this plane.
 */
export function burnAxes(probe: State, sun: State): readonly [Vector, Vector, Vector] {
  const r = difference(probe.position, sun.position);
  const forward = unit(difference(probe.velocity, sun.velocity));
  const north = unit(cross(r, forward));
  return [forward, cross(forward, north), north];
}

/** The velocity after a burn, km/s. */
export function burnt(probe: State, sun: State, [, ...amounts]: Burn): Vector {
  return burnAxes(probe, sun).reduce((velocity, axis, i) => sum(velocity, axis, amounts[i]), probe.velocity);
}

/** Components of a burn are multiples of 0.1 m/s, so that a link repeats the flight exactly. */
export const rounded = (kmPerSecond: number): number => Math.round(1e4 * kmPerSecond) / 1e4;

/** Radius of each body, km, in the order of `BODY_NAMES`. */
export const RADII: readonly number[] = BODY_NAMES.map((name) => SOLAR_STATES[name].radius);

/**
 * Smallest distance during the last interval, if both moved evenly: which they nearly do in intervals that are short
 * compared with the time of the encounter.
 * @param separation of probe and body at the end of the interval
 */
export function closestIn(separation: Vector, velocity: Vector, interval: number): { distance: number; ago: number } {
  const speed2 = dot(velocity, velocity);
  const ago = speed2 > 0 ? Math.min(interval, Math.max(0, dot(separation, velocity) / speed2)) : 0;
  return { distance: lengthOf(sum(separation, scaled(velocity, -ago))), ago };
}

/** Fraction of the time to a body that an interval may take. */
const ENCOUNTER_SHARE = 0.05;

/** Longest interval that resolves the motion past a body, s. */
export function encounterInterval(separation: Vector, velocity: Vector): number {
  return (ENCOUNTER_SHARE * lengthOf(separation)) / Math.max(1, lengthOf(velocity));
}

export const indexOf = (name: BodyName): number => BODY_NAMES.indexOf(name);

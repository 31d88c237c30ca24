// Deviation of the simulated solar system from JPL's ephemeris after a day, a month, 1, 10 and 50 years.
import { gaussRadau, type Integrator, type PhysicsWorld, step } from '@principia/physics';
import type { ReferenceRuns } from '../scene.ts';
import { buildSolarSystem, type SolarSystem } from './build.ts';
import { REFERENCES, type Reference } from './references.ts';
import { BODY_NAMES, type BodyName, OBLIQUITY, STATES } from './states.ts';

export const DAY = 86400;

/** Longest step of an integrator with adaptive sub-steps, s. */
const MAX_STEP = 32 * DAY;

/** Distance from JPL's position, km: planets relative to the Sun, the Moon relative to the Earth. */
export type ErrorsKm = Partial<Record<BodyName, number>>;

/** Errors by body, then by time: `d1`, `d30`, `y1`, `y10`, `y50`. */
export type ErrorTable = Record<string, Record<string, number>>;

/** Advances the world to `time` in steps of dt; the last may be shorter. */
export function advanceTo(world: PhysicsWorld, time: number, dt: number): void {
  // A tiny remainder is the rounding of the summed steps.
  while (time - world.time > 1e-6 * dt) step(world, Math.min(dt, time - world.time));
}

/** The errors of a world at the time of a reference. */
export function errorsAt({ world, ids }: SolarSystem, reference: Reference): ErrorsKm {
  const { Position } = world.components;
  const where = (name: BodyName) =>
    name === 'earth' && ids.moon === undefined ? earthAndMoon(reference) : reference.positions[name];
  const errors: ErrorsKm = {};
  for (const name of BODY_NAMES) {
    const id = ids[name];
    const centre = name === 'moon' ? 'earth' : 'sun';
    if (id === undefined || name === 'sun') continue;
    const origin = ids[centre] as number;
    const wanted = where(name).map((value, axis) => value - where(centre)[axis]);
    const { cos, sin } = OBLIQUITY;
    const dx = Position.x[id] - Position.x[origin] - wanted[0];
    const dy = Position.y[id] - Position.y[origin] - (cos * wanted[1] + sin * wanted[2]);
    const dz = Position.z[id] - Position.z[origin] - (cos * wanted[2] - sin * wanted[1]);
    errors[name] = Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
  return errors;
}

/** Their centre of mass. */
function earthAndMoon({ positions }: Reference): readonly number[] {
  const share = STATES.moon.gm / (STATES.earth.gm + STATES.moon.gm);
  return positions.earth.map((value, axis) => value + share * (positions.moon[axis] - value));
}

/** Advances a new system to each reference in turn, up to `years`, and returns the errors. */
export function measureErrors(system: SolarSystem, dt = MAX_STEP, years = 50): ErrorTable {
  const table: ErrorTable = {};
  for (const reference of REFERENCES) {
    if (reference.days > years * 365.25) break;
    advanceTo(system.world, reference.days * DAY, dt);
    for (const [name, error] of Object.entries(errorsAt(system, reference))) {
      const row = table[name] ?? {};
      row[reference.label] = error;
      table[name] = row;
    }
  }
  return table;
}

/**
 * Time step for an integrator: long steps for one with adaptive sub-steps, 4 days without the Moon for Wisdom-Holman,
 * an hour otherwise.
 */
function mannerOf({ name }: Integrator): { readonly dt: number; readonly moon: boolean } {
  if (name === 'Wisdom-Holman') return { dt: 4 * DAY, moon: false };
  const choosesSteps = name === 'Gauss-Radau 15' || name === 'Dormand-Prince 5(4)';
  return { dt: choosesSteps ? MAX_STEP : DAY / 24, moon: true };
}

/** The errors of an integrator over 50 years, in 3D and f64. */
export function errorsOf(integrator: Integrator): ErrorTable {
  const { dt, moon } = mannerOf(integrator);
  return measureErrors(buildSolarSystem({ integrator, moon }), dt);
}

/** Distance of each body between two runs, relative to the Sun, km. */
export function distancesBetween(a: SolarSystem, b: SolarSystem): ErrorsKm {
  const [p, q] = [a.world.components.Position, b.world.components.Position];
  const distances: ErrorsKm = {};
  for (const name of BODY_NAMES) {
    const [i, j] = [a.ids[name], b.ids[name]];
    if (i === undefined || j === undefined || name === 'sun') continue;
    const [m, n] = [a.ids.sun as number, b.ids.sun as number];
    const [dx, dy, dz] = (['x', 'y', 'z'] as const).map((axis) => p[axis][i] - p[axis][m] - (q[axis][j] - q[axis][n]));
    distances[name] = Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
  return distances;
}

/**
 * The multiple of four days nearest to the end of a year, because a shorter step would perturb a symplectic integrator.
 */
const endOf = (years: number) => 4 * DAY * Math.round((years * 365.25) / 4);

/** Fifty years by an integrator and by Gauss-Radau with the same bodies, to be advanced alternately year by year. */
export function againstGaussRadau(integrator: Integrator): ReferenceRuns {
  const { dt, moon } = mannerOf(integrator);
  const exact = gaussRadau();
  const [ours, theirs] = [integrator, exact].map((scheme) => buildSolarSystem({ integrator: scheme, moon }));
  return {
    name: exact.name,
    times: Array.from({ length: 50 }, (_, year) => endOf(year + 1)),
    labels: new Map([1, 10, 50].map((years) => [endOf(years), `y${years}`])),
    ours: (time) => advanceTo(ours.world, time, dt),
    theirs: (time) => advanceTo(theirs.world, time, MAX_STEP),
    apartKm: () => distancesBetween(ours, theirs),
  };
}

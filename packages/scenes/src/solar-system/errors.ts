// How far the simulated solar system is from JPL's after a day, a month, 1, 10 and 50 years.
import { type PhysicsWorld, step } from '@principia/physics';
import type { SolarSystem } from './build';
import { REFERENCES, type Reference } from './references';
import { BODY_NAMES, type BodyName, OBLIQUITY } from './states';

export const DAY = 86400;

/** Distance from where JPL has the body, km: planets as seen from the Sun, the Moon as seen from the Earth. */
export type ErrorsKm = Partial<Record<BodyName, number>>;

/** Errors by body, then by time: `d1`, `d30`, `y1`, `y10`, `y50`. */
export type ErrorTable = Partial<Record<BodyName, Record<string, number>>>;

/** Moves the world to `time` in steps of dt, of which the last may be shorter. */
export function advanceTo(world: PhysicsWorld, time: number, dt: number): void {
  // What is left after the last whole step is either a real part of one or the rounding of the sum of them all.
  while (time - world.time > 1e-6 * dt) step(world, Math.min(dt, time - world.time));
}

/** The errors of a world with the Moon that has come to the time of a reference. */
export function errorsAt({ world, ids }: SolarSystem, reference: Reference): ErrorsKm {
  const { Position } = world.components;
  const errors: ErrorsKm = {};
  for (const name of BODY_NAMES) {
    const id = ids[name];
    const centre = name === 'moon' ? 'earth' : 'sun';
    if (id === undefined || name === 'sun') continue;
    const origin = ids[centre] as number;
    const wanted = reference.positions[name].map((value, axis) => value - reference.positions[centre][axis]);
    const { cos, sin } = OBLIQUITY;
    const dx = Position.x[id] - Position.x[origin] - wanted[0];
    const dy = Position.y[id] - Position.y[origin] - (cos * wanted[1] + sin * wanted[2]);
    const dz = Position.z[id] - Position.z[origin] - (cos * wanted[2] - sin * wanted[1]);
    errors[name] = Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
  return errors;
}

/** Runs a fresh system to each reference in turn, up to `years`, and returns the errors there. */
export function measureErrors(system: SolarSystem, dt = 32 * DAY, years = 50): ErrorTable {
  const table: ErrorTable = {};
  for (const reference of REFERENCES) {
    if (reference.days > years * 365.25) break;
    advanceTo(system.world, reference.days * DAY, dt);
    for (const [name, error] of Object.entries(errorsAt(system, reference)) as [BodyName, number][]) {
      const row = table[name] ?? {};
      row[reference.label] = error;
      table[name] = row;
    }
  }
  return table;
}

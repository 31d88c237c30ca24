// The dates on which JPL's ephemeris is stored here, and how far a simulated solar system is from it on such a date.
import type { SolarSystem } from './build.ts';
import { type ErrorsKm, errorsAt } from './errors.ts';
import { BODIES_2012, type Positions2012, positions2012 } from './positions-2012.ts';
import { REFERENCES } from './references.ts';
import { EPOCH, STATES } from './states.ts';
import { EPOCH_2012 } from './states-2012.ts';

/** A date with stored positions. */
export interface Checkpoint {
  readonly julianDate: number;
  /** Distances from JPL's positions, km: planets relative to the Sun, the Moon relative to the Earth. */
  errors(system: SolarSystem): ErrorsKm;
}

/** All dates, ascending: five from 2000 to 2050 for all bodies, and every sixth day of 2012 for the inner ones. */
export function checkpoints(): readonly Checkpoint[] {
  const all = [
    ...REFERENCES.map((reference) => ({
      julianDate: EPOCH + reference.days,
      errors: (system: SolarSystem) => errorsAt(system, reference),
    })),
    ...positions2012().map((row) => ({
      julianDate: EPOCH_2012 + row.days,
      errors: (system: SolarSystem) => errorsIn2012(system, row),
    })),
  ];
  return all.sort((a, b) => a.julianDate - b.julianDate);
}

/** Share of the Moon in the mass of Earth and Moon. */
const MOON_SHARE = STATES.moon.gm / (STATES.earth.gm + STATES.moon.gm);

/** The errors of a world at the time of a row, of the bodies in the table. */
export function errorsIn2012({ world, ids }: SolarSystem, { positions }: Positions2012): ErrorsKm {
  const { x, y, z } = world.components.Position;
  const errors: ErrorsKm = {};
  for (const name of BODIES_2012) {
    const id = ids[name];
    if (id === undefined) continue;
    const origin = (name === 'moon' ? ids.earth : ids.sun) as number;
    // Without the Moon, the body called Earth is the centre of mass of both.
    const shift = name === 'moon' ? -1 : name === 'earth' && ids.moon === undefined ? MOON_SHARE : 0;
    const wanted = (axis: 0 | 1 | 2) => {
      const own = positions[name][axis];
      const { earth, moon } = positions;
      if (shift < 0) return own - earth[axis];
      return own + shift * (moon[axis] - earth[axis]);
    };
    const dx = x[id] - x[origin] - wanted(0);
    const dy = y[id] - y[origin] - wanted(1);
    const dz = z[id] - z[origin] - wanted(2);
    errors[name] = Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
  return errors;
}

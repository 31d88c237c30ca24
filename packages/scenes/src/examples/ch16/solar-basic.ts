import { rungeKutta4 } from '@principia/physics';
import { type BuildOptions, defineExample } from '../define-example.ts';
import { positionOf } from '../support/read.ts';
import {
  BOOK,
  BOOK_PLANETS,
  DAYS,
  ellipseOf,
  fixedSun,
  gmInPicture,
  INNER_DISTANCES,
  INNER_NAMES,
  INNER_PLANETS,
  innerPicture,
  periodOf,
  type SolarRun,
  speedInPicture,
} from '../support/solar.ts';
import { point } from '../support/space.ts';

/** G times the mass of the Sun with the constants of the book: 2.8e-4 too large, hence the periods 0.05 % too short. */
const MU = gmInPicture((BOOK.G * BOOK.sun) / 1e9);
/** Periods about a fixed Sun alone, days. */
const PERIODS = { mercury: 87.913, venus: 224.57, earth: 364.897, mars: 686.469 } as const;

/** Of the ellipse that begins at right angles to the way to the Sun: |r v²/μ − 1|. */
function eccentricityOf(name: (typeof INNER_PLANETS)[number]): number {
  const { distance, speed } = BOOK_PLANETS[name];
  const v = speedInPicture(speed);
  return Math.abs((distance * v * v) / MU - 1);
}

export default defineExample({
  id: 'ch16-solar-basic',
  title: 'Four planets on circles, nearly',
  chapter: 16,
  tags: ['3D', 'gravity', 'orbit', 'planets'],
  about:
    'Mercury, Venus, Earth and Mars start in a line, at their mean distances and with their mean speeds, and attract each other a little. The farther out, the slower: the square of a year grows as the cube of the distance. Ten days pass in each second.',
  dimensions: 3,
  duration: 70,
  parameters: {},
  build(_: object, { integrator = rungeKutta4 }: BuildOptions) {
    return fixedSun(
      (name) => ({
        position: point(BOOK_PLANETS[name].distance, 0, 0),
        velocity: point(0, speedInPicture(BOOK_PLANETS[name].speed), 0),
      }),
      MU,
      integrator,
    );
  },
  picture: innerPicture,
  plots: [INNER_DISTANCES],
  checks: ({ at }) => [
    ...INNER_PLANETS.map((name) =>
      at(
        0,
        `Year of ${INNER_NAMES[name]} about the Sun alone`,
        { exact: PERIODS[name], unit: 'd', relative: 1e-5 },
        (run: SolarRun) => periodOf(run, name),
      ),
    ),
    ...INNER_PLANETS.map((name) => ({
      label: `${INNER_NAMES[name]} is back where it started`,
      unit: 'd',
      exact: PERIODS[name],
      // The other planets delay or hasten it by some parts in 100 000.
      tolerance: { relative: 2e-4 },
      at: {
        event: ({ world, ids }: SolarRun) => positionOf(world, ids[name] as number).y,
        count: 1,
      },
      measure: ({ world }: SolarRun) => DAYS * world.time,
    })),
    ...INNER_PLANETS.map((name) =>
      at(
        0,
        `Eccentricity of ${INNER_NAMES[name]}`,
        { exact: eccentricityOf(name), relative: 1e-6 },
        (run: SolarRun) => ellipseOf(run, name).eccentricity,
      ),
    ),
  ],
  tryThis: ['Count: while Mars goes round once, Mercury does so nearly eight times.'],
});

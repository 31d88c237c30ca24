import { rungeKutta4 } from '@principia/physics';
import { type BuildOptions, defineExample } from '../define-example.ts';
import {
  distanceFromSun,
  ellipseOf,
  INNER_DISTANCES,
  INNER_NAMES,
  INNER_PLANETS,
  innerPicture,
  type SolarRun,
  system2012,
} from '../support/solar.ts';

/** The astronomical unit, 10⁹ m. */
const AU = 149.5978707;

/** Osculating elements of JPL's states: semi-major axis, au, eccentricity, inclination, degrees. */
const ELEMENTS = {
  mercury: [0.387099, 0.20563, 7.0043],
  venus: [0.723328, 0.00674, 3.3947],
  earth: [1.000069, 0.01679, 0.0021],
  mars: [1.523597, 0.09346, 1.8488],
} as const;

/** An angle whose sine is small, degrees: s + s³/6 + 3 s⁵/40. */
const degreesOf = (sine: number) =>
  ((sine + (sine * sine * sine) / 6 + (3 * sine * sine * sine * sine * sine) / 40) * 180) / Math.PI;

export default defineExample({
  id: 'ch16-solar-accurate',
  title: 'The inner planets as they were in 2012',
  chapter: 16,
  tags: ['3D', 'gravity', 'orbit', 'planets'],
  about:
    'The start is taken from JPL’s ephemeris: where each planet was at the beginning of 2012, and how fast it moved. The orbits are now ellipses that are a little inclined to each other. Mercury’s and Mars’s are clearly off centre. Ten days pass in each second.',
  dimensions: 3,
  duration: 70,
  parameters: {},
  build: (_: object, { integrator = rungeKutta4 }: BuildOptions) => system2012({ integrator }),
  picture: innerPicture,
  plots: [INNER_DISTANCES],
  checks: ({ at, smallest }) => [
    ...INNER_PLANETS.flatMap((name) => [
      at(
        0,
        `Semi-major axis of ${INNER_NAMES[name]}`,
        { exact: ELEMENTS[name][0], unit: 'au', absolute: 2e-6 },
        (run: SolarRun) => ellipseOf(run, name).axis / AU,
      ),
      at(
        0,
        `Eccentricity of ${INNER_NAMES[name]}`,
        { exact: ELEMENTS[name][1], absolute: 1.5e-5 },
        (run: SolarRun) => ellipseOf(run, name).eccentricity,
      ),
      at(
        0,
        `Inclination of ${INNER_NAMES[name]}`,
        { exact: ELEMENTS[name][2], unit: '°', absolute: 1e-4 },
        (run: SolarRun) => degreesOf(ellipseOf(run, name).tilt),
      ),
    ]),
    smallest(
      9,
      'Smallest distance of Mercury in 90 days',
      { exact: 46.001, unit: '10⁹ m', relative: 1e-3 },
      (run: SolarRun) => distanceFromSun(run, 'mercury'),
    ),
    smallest(
      69,
      'Smallest distance of Mars in 690 days',
      { exact: 206.626, unit: '10⁹ m', relative: 1e-3 },
      (run: SolarRun) => distanceFromSun(run, 'mars'),
    ),
  ],
  tryThis: ['Turn the view until you look along the plane: Mercury’s path is inclined by 7°.'],
});

import { type Integrator, rungeKutta4 } from '@principia/physics';
import { type BuildOptions, choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import {
  BOOK,
  DAYS,
  errorKm,
  fixedSun,
  gmInPicture,
  INNER_NAMES,
  INNER_PLANETS,
  innerPicture,
  jplPlace,
  type SolarRun,
  start2012,
  system2012,
} from '../support/solar.ts';

/** Days until the last stored position, that of 1 January 2013. */
const YEAR = 366;
const MODELS = ['All planets, Moon, relativity', 'All planets, Newton', 'Inner planets, book'];

/** Errors of the program of the book, km: nearly all of them come from a product of G and solar mass that is rounded. */
const BOOK_ERRORS = { mercury: 564534, venus: 647621, earth: 478932, mars: 533258 } as const;

/** @param model index of `MODELS` */
function build(model: number, integrator: Integrator): SolarRun {
  if (model < 1.5) return system2012({ integrator, moon: model < 0.5, relativity: model < 0.5 });
  return fixedSun(start2012, gmInPicture((BOOK.G * BOOK.sun) / 1e9), integrator);
}

/** The error on the last day; before, what is left to it. */
const lastError = (name: (typeof INNER_PLANETS)[number]) => (run: SolarRun) => errorKm(run, name, YEAR);

export default defineExample({
  id: 'ch16-solar-nasa',
  title: 'How far from JPL’s positions?',
  chapter: 16,
  tags: ['3D', 'gravity', 'planets', 'accuracy'],
  about:
    'The planets start where JPL’s ephemeris has them at the beginning of 2012. The marks show where it has them 366 days later, ten days in each second. With all planets, the Moon and the first term of relativity they arrive within a kilometre. With the constants of the book they are half a million kilometres off, which is less than the drawn discs: one would not see it.',
  dimensions: 3,
  duration: YEAR / DAYS,
  ends: true,
  parameters: { model: choiceOf('Model', MODELS) },
  presets: [
    { label: 'Newton without the Moon', values: { model: 1 } },
    { label: 'The book', values: { model: 2 } },
  ],
  build({ model }: ValuesOf<'model'>, { integrator = rungeKutta4 }: BuildOptions) {
    return build(model, integrator);
  },
  picture: (run) => ({
    ...innerPicture(run),
    curves: INNER_PLANETS.map((name) => ({
      points: [],
      now: () => jplPlace(name, YEAR),
      markRadius: 9,
      color: COLORS.white,
    })),
  }),
  plots: [
    {
      title: 'Distance from where JPL has it at the end',
      x: { label: 't, days', value: ({ world }) => DAYS * world.time },
      y: { label: 'r, 10⁹ m' },
      series: INNER_PLANETS.map((name) => ({
        label: INNER_NAMES[name],
        value: (run: SolarRun) => 1e-6 * lastError(name)(run),
      })),
    },
  ],
  checks: ({ at }) => [
    ...INNER_PLANETS.map((name) =>
      at(
        YEAR / DAYS,
        `${INNER_NAMES[name]} after 366 days, distance from JPL’s position`,
        { exact: 0, unit: 'km', absolute: 1 },
        lastError(name),
      ),
    ),
    at(
      YEAR / DAYS,
      'Earth without the Moon, distance after 366 days',
      { exact: 91891, unit: 'km', relative: 0.01, preset: 'Newton without the Moon' },
      lastError('earth'),
    ),
    ...INNER_PLANETS.map((name) =>
      at(
        YEAR / DAYS,
        `${INNER_NAMES[name]} with the constants of the book`,
        { exact: BOOK_ERRORS[name], unit: 'km', relative: 0.01, preset: 'The book' },
        lastError(name),
      ),
    ),
  ],
  tryThis: [
    'Choose Newton without the Moon: Mercury is 80 km off, and the Earth 92 000 km, because the Moon swings it about.',
    'Choose the book: the planets still end on their marks, to the eye.',
  ],
});

import {
  breakSprings,
  brokenSprings,
  createCloth,
  createPhysicsWorld,
  createRandom,
  linearDrag,
  rgba,
  spawn,
  turbulentDrag,
  uniformGravity,
  xpbd,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'growth' | 'strength' | 'wear' | 'gusts'>;

const [GRAVITY, COLUMNS, ROWS, SPACING] = [9.81, 22, 12, 0.1];
/** Mass of a knot, kg, and its drag coefficient, kg/s. */
const [KNOT, DRAG] = [0.002, 0.01];
const WEIGHT = KNOT * GRAVITY;
/** Knots that hang on each thread at the mast. */
const LOAD = COLUMNS - 1;
/** The wind at first, m/s, in which the flag lies still at first. */
const START = 4;
const MAST = { x: -1.4, y: 1 };

/** The wind at which `LOAD` knots in line pull with a force, m/s. */
const windAt = (strength: number) => {
  const pull = strength / LOAD;
  return Math.sqrt(pull * pull - WEIGHT * WEIGHT) / DRAG;
};

export default defineExample({
  id: 'ch17-tearing-flag',
  title: 'A flag that tears',
  chapter: 17,
  tags: ['cloth', 'wind', 'drag', 'spring', 'soft bodies'],
  about:
    'The wind grows. Weight and wind pull on every knot alike, so each row of the flag is a straight line, and its thread at the mast carries all of it. When that is more than a thread can bear, the flag tears off and is blown away. In gusts it flutters; an old flag, with some threads weaker than others, tears into rags.',
  duration: 16,
  ends: true,
  parameters: {
    growth: { label: 'Growth of the wind', unit: 'm/s²', initial: 1, min: 0.2, max: 4 },
    strength: { label: 'Strength of a thread', unit: 'N', initial: 3, min: 1, max: 8 },
    wear: { label: 'Wear: some threads are weaker', initial: 0, min: 0, max: 0.9 },
    gusts: { label: 'Gusts', unit: 'm/s', initial: 0, min: 0, max: 8 },
  },
  presets: [{ label: 'An old flag in gusts', values: { wear: 0.5, gusts: 2.5, strength: 6 } }],
  build({ growth, strength, wear, gusts }: Values, { seed, integrator = xpbd({ substeps: 4 }) }: BuildOptions) {
    const wind = (time: number) => ({ x: START + growth * time });
    const drag =
      gusts === 0 ? linearDrag(wind) : turbulentDrag({ mean: wind, deviation: gusts, largest: 1.5, modes: 24, seed });
    const forces = [uniformGravity({ y: -GRAVITY }), drag];
    const world = createPhysicsWorld({ capacity: 1200, forces, integrator });
    const pull = Math.sqrt(DRAG * START * (DRAG * START) + WEIGHT * WEIGHT);
    const flag = createCloth(world, {
      corner: MAST,
      columns: COLUMNS,
      rows: ROWS,
      spacing: SPACING,
      right: { x: (DRAG * START) / pull, y: -WEIGHT / pull },
      mass: KNOT * COLUMNS * ROWS,
      breakForce: strength,
      pins: Array.from({ length: ROWS }, (_, row) => [0, row] as const),
      components: { linearDrag: DRAG },
    });
    const random = createRandom(seed);
    for (const thread of flag.springs) world.components.Spring.breakForce[thread] *= 1 - wear * random.uniform();
    world.phases.finish.push(breakSprings);
    const end = flag.at(COLUMNS - 1, Math.floor(ROWS / 2));
    spawn(world, { position: { x: MAST.x, y: MAST.y + 0.15 }, appearance: { size: 0.06, color: rgba(1, 0.85, 0.4) } });
    const slope = () => {
      const [a, b] = [positionOf(world, flag.at(0, 6)), positionOf(world, end)];
      return (a.y - b.y) / (b.x - a.x);
    };
    return {
      world,
      dt: 1 / 120,
      end,
      wind: () => START + growth * world.time,
      slope,
      broken: () => brokenSprings(world).total,
    };
  },
  picture() {
    return {
      view: { minX: -2, maxX: 2.4, minY: -2, maxY: 1.6 },
      springs: 'lines',
      lines: [{ from: { x: MAST.x, y: -2 }, to: { x: MAST.x, y: MAST.y + 0.15 }, color: COLORS.grey, width: 6 }],
    };
  },
  plots: (plot) => [
    plot(
      'Wind, and the end of the flag',
      'v, m/s',
      { label: 'wind', value: ({ wind }) => wind() },
      { label: 'end of the flag', value: ({ world, end }) => velocityOf(world, end).x },
    ),
    plot('Torn threads', 'threads', { label: 'torn', value: ({ broken }) => broken() }),
  ],
  checks: ({ at }) => [
    // As it still rises it lags by an eighth of a second, in which the wind grows by 1 %.
    at(
      8,
      'Slope of the flag at 12 m/s, weight over drag',
      { exact: WEIGHT / (12 * DRAG), relative: 0.015 },
      ({ slope }) => slope(),
    ),
    {
      label: 'Wind that tears it: a row of 21 knots pulls as hard as a thread is strong',
      unit: 'm/s',
      exact: windAt(3),
      // A step of 1/120 s.
      tolerance: { relative: 1e-3 },
      at: { event: ({ broken }) => broken() - 0.5 },
      measure: ({ wind }) => wind(),
    },
    at(
      16,
      'How far the torn flag is behind the growing wind, m/c times its growth',
      { exact: KNOT / DRAG, unit: 'm/s', relative: 1e-6 },
      ({ world, end, wind }) => wind() - velocityOf(world, end).x,
    ),
  ],
  tryThis: [
    'Choose “An old flag in gusts”: the weakest threads go first, their neighbours must bear more, and a tear runs on.',
    'Make the threads twice as strong: the wind that tears them is a little more than twice as strong, as the weight counts less.',
  ],
});

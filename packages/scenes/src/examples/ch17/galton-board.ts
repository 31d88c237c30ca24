import {
  boxWalls,
  createPhysicsWorld,
  createRandom,
  exp,
  linearDrag,
  type PhysicsWorld,
  particleContacts,
  rgba,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { type Ends, linesOf } from '../support/walls.ts';

type Values = ValuesOf<'balls' | 'restitution' | 'drag'>;

const [ROWS, COUNT, GRAVITY] = [12, 400, 9.81];
/** Height of a row, radii of pegs and balls, height of the bins, m; pegs are 1 m apart. */
const [STEP, PEG, BALL, BINS] = [0.87, 0.12, 0.12, 5];
const TOP = BINS + 1 + ROWS * STEP;
/** Distance of two balls that fall one after the other, m. */
const FOLLOWING = 0.6;
/** Height of the bar of all balls, m. */
const SCALE = 18;
const HALF = ROWS / 2 + 0.5;
const WALLS: readonly Ends[] = Array.from({ length: ROWS + 2 }, (_, i) => [i - HALF, 0, i - HALF, BINS]);

/** Places of the balls that have reached the bins. */
function landed({ components: { Position } }: PhysicsWorld, balls: readonly number[]): number[] {
  return balls.filter((id) => Position.y[id] < BINS).map((id) => Position.x[id]);
}

const meanOf = (numbers: readonly number[]) => numbers.reduce((sum, x) => sum + x, 0) / numbers.length;

export default defineExample({
  id: 'ch17-galton-board',
  title: 'Galton’s board',
  chapter: 17,
  tags: ['collision', 'random', 'statistics', 'binomial distribution'],
  about:
    'A ball bounces through twelve rows of pegs, and at each it goes to the left or to the right. What one ball does is chance, what hundreds do is a law: of the 4096 ways down one leads into the outermost bin and 924 into the middle, and together they make the bell curve. Galton built such a board in 1873. Here the balls meet the pegs, but not each other.',
  duration: 100,
  parameters: {
    balls: { label: 'Balls', initial: COUNT, min: 1, max: 1000, integer: true },
    restitution: { label: 'Restitution e', initial: 0.6, min: 0, max: 0.9 },
    drag: { label: 'Drag of a ball', unit: 'kg/s', initial: 3, min: 1, max: 10 },
  },
  build({ balls: count, restitution, drag }: Values, { seed, ...options }: BuildOptions) {
    const walls = [boxWalls({ min: { x: -HALF }, max: { x: HALF } })];
    const forces = [uniformGravity({ y: -GRAVITY }), linearDrag()];
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 1200, walls, forces, ...options });
    for (const [ax, ay, bx, by] of WALLS) spawn(world, { segmentWall: { ax, ay, bx, by } });
    for (let row = 0; row < ROWS; row++) {
      for (let i = 0; i <= row; i++) {
        const position = { x: i - row / 2, y: TOP - row * STEP };
        spawn(world, { position, collider: { radius: PEG, restitution }, appearance: rgba(0.9, 0.9, 1) });
      }
    }
    const random = createRandom(seed);
    const balls = Array.from({ length: count }, (_, i) =>
      spawn(world, {
        position: { x: random.uniform(-0.05, 0.05), y: TOP + 2 + i * FOLLOWING },
        // They come down a high shaft, with the speed at which drag and weight balance.
        velocity: { y: -GRAVITY / drag },
        mass: 1,
        linearDrag: drag,
        collider: { radius: BALL, restitution, layers: 2, mask: 1 },
        appearance: rgba(1, 0.7 - 0.3 * random.uniform(), 0.28),
      }),
    );
    return { world, dt: 1 / 120, balls };
  },
  picture({ world, balls }) {
    const bar = (i: number) => {
      const share = landed(world, balls).filter((x) => Math.round(x) === i).length / balls.length;
      return { x: i, y: SCALE * share };
    };
    const bars = Array.from({ length: ROWS + 1 }, (_, i) => i - ROWS / 2).map((i) => ({
      from: { x: i, y: 0 },
      to: () => bar(i),
      color: COLORS.blue,
      width: 14,
    }));
    return {
      view: { minX: -HALF - 0.3, maxX: HALF + 0.3, minY: -0.3, maxY: TOP + 2 },
      lines: [...linesOf([...WALLS, [-HALF, 0, HALF, 0]]).map((line) => ({ ...line, color: COLORS.grey })), ...bars],
      fills: [{ shape: { minX: -HALF, maxX: HALF, minY: -50, maxY: 0 }, color: COLORS.ground, inFront: true }],
    };
  },
  plots: [],
  histograms: [
    {
      title: 'Balls in the bins',
      x: { label: 'x, m', min: -HALF, max: HALF },
      intervals: ROWS + 1,
      samples: ({ world, balls }) => landed(world, balls),
      exact: (x) => exp((-2 * x * x) / ROWS) / Math.sqrt((Math.PI * ROWS) / 2),
    },
  ],
  checks: ({ at }) => [
    at(
      100,
      'Balls that have reached the bins',
      { exact: COUNT, absolute: 0 },
      ({ world, balls }) => landed(world, balls).length,
    ),
    // Three errors of the mean of independent balls.
    at(
      100,
      'Mean place, the middle',
      { exact: 0, unit: 'm', absolute: 3 * Math.sqrt(ROWS / 4 / COUNT) },
      ({ world, balls }) => meanOf(landed(world, balls).map(Math.round)),
    ),
    // Three errors of the variance of a distribution that is nearly normal.
    at(
      100,
      'Variance of the bins, rows/4 where a ball forgets its path at each peg',
      { exact: ROWS / 4, unit: 'm²', relative: 3 * Math.sqrt(2 / COUNT) },
      ({ world, balls }) => meanOf(landed(world, balls).map((x) => Math.round(x) * Math.round(x))),
    ),
  ],
  tryThis: [
    'Set the drag to 4: the balls hardly bounce, remember where they came from, and most end in the middle. So real boards need care to be binomial.',
    'Set the drag to 2: the balls fly further, and the bell grows wide and flat.',
  ],
});

import { boxWalls, createPhysicsWorld, spawn, uniformGravity, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const [ROOF, GROUND, RADIUS] = [100, 300, 4];
const FALL = GROUND - ROOF;
type Values = ValuesOf<'scale' | 'slow'>;
/** Gravity of the picture: metres become pixels, and seconds of the model are longer. */
const gravityOf = ({ scale, slow }: Values) => (9.81 * scale) / (slow * slow);

export default defineExample({
  id: 'ch14-scale-model',
  title: 'A ball from a model house',
  chapter: 14,
  tags: ['units', 'scale', 'gravity'],
  about:
    'Why do model ships in old films look like toys? Because they bob too fast. A house of 200 px stands for one of 4.9 m if a metre is 41 px wide, and the ball is down after one second. For a tower of 49 m a metre is 4 px: the same picture, but gravity is only a tenth in pixels, and the ball takes √10 times as long.',
  duration: 8,
  parameters: {
    scale: { label: 'Pixels per metre', unit: 'px/m', initial: 400 / 9.81, min: 4, max: 80, scale: 'log' },
    slow: { label: 'Slow motion', unit: '×', initial: 1, min: 1, max: 4 },
  },
  presets: [{ label: 'A tower of 49 m', values: { scale: 40 / 9.81 } }],
  build({ scale, slow }: Values, { integrator = velocityVerlet }: BuildOptions) {
    const walls = [boxWalls({ max: { y: GROUND } })];
    const forces = [uniformGravity({ y: gravityOf({ scale, slow }) })];
    const world = createPhysicsWorld({ capacity: 4, forces, walls, integrator });
    const ball = spawn(world, { position: { x: 300, y: ROOF - RADIUS }, velocity: {}, mass: 1, collider: RADIUS });
    return { world, dt: 1 / 60, ball, fallen: () => positionOf(world, ball).y - ROOF + RADIUS };
  },
  picture: ({ world, ball, fallen }, { scale }) => ({
    yDown: true,
    view: { minX: 0, maxX: 550, minY: 40, maxY: 330 },
    fills: [
      { shape: { minX: 90, maxX: 290, minY: ROOF, maxY: GROUND }, color: 0x2b3354 },
      ...Array.from({ length: 12 }, (_, i) => ({
        shape: {
          minX: 110 + 45 * (i % 4),
          maxX: 135 + 45 * (i % 4),
          minY: 120 + 60 * Math.floor(i / 4),
          maxY: 150 + 60 * Math.floor(i / 4),
        },
        color: COLORS.yellow,
        opacity: 0.7,
      })),
      { shape: { minX: -900, maxX: 1500, minY: GROUND, maxY: 900 }, color: COLORS.ground },
    ],
    trails: [{ body: ball, length: 200 }],
    arrows: [velocityArrow(world, ball, 0.15)],
    labels: [
      { at: { x: 320, y: 120 }, text: () => `${(fallen() / scale).toFixed(1)} m of ${(FALL / scale).toFixed(1)} m` },
    ],
  }),
  plots: (plot) => [
    plot('Distance fallen', 'distance, px', {
      label: 'stepped',
      value: ({ fallen }) => fallen(),
      exact: (t, values) => Math.min(FALL, (gravityOf(values) / 2) * t * t),
    }),
  ],
  checks: ({ at }) => [
    at(
      1,
      'Distance in the first second',
      { exact: (values) => Math.min(FALL, gravityOf(values) / 2), unit: 'px', absolute: 1e-9 },
      ({ fallen }) => fallen(),
    ),
    at(
      59 / 60,
      'Speed a step before the impact, g t',
      { exact: 400 * (59 / 60), unit: 'px/s', relative: 1e-9 },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
    {
      label: 'Time of the fall from the tower, √10',
      unit: 's',
      exact: Math.sqrt(10),
      tolerance: { absolute: 1 / 60 },
      at: { event: ({ fallen }) => fallen() - FALL + 1e-6 },
      preset: 'A tower of 49 m',
    },
  ],
  tryThis: [
    'Choose the tower: nothing in the picture has changed but the time, and it looks much larger.',
    'Use slow motion for the small house: at 3.16, the root of 10, it looks like the tower. That is how films do it.',
  ],
});

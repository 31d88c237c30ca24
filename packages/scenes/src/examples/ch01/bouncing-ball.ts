import { particleContacts, spawn, wallContacts } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { type BallRun, positionOf, velocityOf } from '../support/read.ts';
import { comeBack, GROUND, RADIUS, STAGE, STAGE_VIEW, stageWorld } from '../support/stage.ts';

const START = { x: 50, y: 50 };
/** The centre of a ball on the floor, and the height of the fall to it. */
const FLOOR = STAGE.maxY - RADIUS;
const HEIGHT = FLOOR - START.y;

type Values = ValuesOf<'gravity' | 'restitution' | 'speed'>;

/** Height of the apex after a number of bounces: each leaves e² of the energy. */
function apex({ restitution: e }: Values, bounces: number): number {
  let height = HEIGHT;
  for (let i = 0; i < bounces; i++) height *= e * e;
  return height;
}

const impactSpeed = ({ gravity }: Values) => Math.sqrt(2 * gravity * HEIGHT);

export default defineExample({
  id: 'ch01-bouncing-ball',
  title: 'A bouncing ball',
  chapter: 1,
  tags: ['gravity', 'bounce', 'energy'],
  about:
    'Gravity pulls the ball down, and the floor throws it back with a little less speed each time: 80 % of it, and so 64 % of the height. The bounces become shorter and shorter, and although there are infinitely many of them, they are all over after 14 seconds. What leaves on the right comes back on the left.',
  duration: 16,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 360, min: 60, max: 900 },
    restitution: { label: 'Speed kept in a bounce', initial: 0.8, min: 0, max: 0.95 },
    speed: { label: 'Speed to the right', unit: 'px/s', initial: 120, min: 0, max: 300 },
  },
  presets: [
    { label: 'A lump of clay', values: { restitution: 0 } },
    { label: 'A rubber ball', values: { restitution: 0.9 } },
  ],
  build({ gravity, restitution, speed }: Values, options: BuildOptions) {
    const world = stageWorld(gravity, { preset: particleContacts, ...options });
    const collider = { radius: RADIUS, restitution };
    const ball = spawn(world, { position: START, velocity: { x: speed }, mass: 1, collider });
    comeBack(world, [ball]);
    const hitSpeed = () => {
      const { count, speed } = wallContacts(world);
      return count === 0 ? 0 : speed[0];
    };
    return { world, dt: 1 / 120, ball, hitSpeed };
  },
  picture({ world, ball }, values) {
    const heights = [1, 2, 3, 4].map((bounces) => ({ bounces, y: FLOOR - apex(values, bounces) }));
    return {
      yDown: true,
      view: STAGE_VIEW,
      fills: [GROUND],
      lines: heights.map(({ y }) => ({ from: { x: 0, y }, to: { x: 700, y }, color: COLORS.ground, width: 1 })),
      labels: heights.slice(0, 3).map(({ bounces, y }) => ({ at: { x: 610, y }, text: `bounce ${bounces}` })),
      trails: [{ body: ball, length: 500 }],
      arrows: [velocityArrow(world, ball, 0.2)],
    };
  },
  plots: (plot) => [
    plot('Height', 'height, px', { label: 'height', value: ({ world, ball }) => FLOOR - positionOf(world, ball).y }),
  ],
  checks: ({ largest }) => [
    largest(
      4,
      'Speed of the first impact, √(2 g h)',
      { exact: impactSpeed, unit: 'px/s', relative: 0.005 },
      ({ hitSpeed }) => hitSpeed(),
    ),
    {
      label: 'Time of the first impact, √(2h/g), in frames of 1/60 s',
      exact: 92.7,
      tolerance: { relative: 0.005 },
      at: { event: ({ world, ball }) => -velocityOf(world, ball).y },
      measure: ({ world }) => 60 * world.time,
    },
    ...[1, 2, 3, 4].map((bounces) => ({
      label: `Height after bounce ${bounces}, h e${['²', '⁴', '⁶', '⁸'][bounces - 1]}`,
      unit: 'px',
      exact: apex({ gravity: 360, restitution: 0.8, speed: 120 }, bounces),
      tolerance: { relative: 0.005 },
      at: { event: ({ world, ball }: BallRun) => velocityOf(world, ball).y, count: bounces },
      measure: ({ world, ball }: BallRun) => FLOOR - positionOf(world, ball).y,
    })),
    {
      label: 'Time until it lies still, t₁ (1 + e)/(1 − e)',
      unit: 's',
      exact: (values) => ((impactSpeed(values) / values.gravity) * (1 + values.restitution)) / (1 - values.restitution),
      tolerance: { relative: 0.005 },
      at: { event: ({ world, ball }) => (velocityOf(world, ball).y === 0 && world.time > 0.1 ? 1 : -1) },
    },
    {
      label: 'First time it leaves on the right',
      unit: 's',
      exact: ({ speed }) => (STAGE.maxX + RADIUS - START.x) / speed,
      tolerance: { absolute: 1e-9 },
      at: { event: ({ world, ball }) => positionOf(world, ball).x - STAGE.maxX - RADIUS },
    },
  ],
  tryThis: [
    'Set the speed that is kept to 0: the ball stays on the floor at once, and only slides on.',
    'Double the gravity: everything happens faster, but the heights stay the same.',
  ],
});

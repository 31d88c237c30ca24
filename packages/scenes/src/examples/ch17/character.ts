import {
  box,
  type ColumnsOf,
  columnsOf,
  createPhysicsWorld,
  type PhysicsWorld,
  polygon,
  rgba,
  rigidBodies,
  softStep,
  spawn,
  uniformGravity,
} from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { addWalker, GAP, moveWalkers, WALKER, Walker } from '../../walkers.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { held } from '../support/held.ts';
import { positionOf } from '../support/read.ts';

type Values = ValuesOf<'speed' | 'jump' | 'highestStep' | 'slope' | 'gravity'>;

const DEGREE = Math.PI / 180;
const [STONE, WOOD] = [rgba(0.29, 0.33, 0.47), rgba(0.75, 0.55, 0.35)];

/** Height of a stair, and number of stairs. */
const [RISE, STAIRS] = [0.22, 5];
const LANDING = RISE * STAIRS;

/** The lift: a column whose top goes from LOW to HIGH in half of the period. */
const LIFT = { x: -7, width: 2, height: 5, low: 0.1, high: 4.1, period: 10 } as const;

/** Places of the platforms that are solid from above. */
const PLATFORMS = [
  [0.3, 1.25],
  [-1.9, 2.45],
  [-4, 3.6],
] as const;

/** Where the lamp hangs. */
const LAMP = { x: -9.6, y: 5.1 };

interface CharacterRun extends SceneRun {
  /** Whom the reader moves, and the others. */
  readonly hero: number;
  readonly guide: number;
  readonly jumper: number;
  readonly rider: number;
  readonly walker: ColumnsOf<typeof Walker>;
  readonly values: Values;
  /** Height of somebody's feet. */
  feetOf(id: number): number;
}

/** Speed with which one rises by a height. */
const jumpSpeed = ({ jump, gravity }: Pick<Values, 'jump' | 'gravity'>) => Math.sqrt(2 * gravity * jump);

/** The course: static bodies, crates, and a lift. */
function addCourse(world: PhysicsWorld): number {
  const stone = (width: number, height: number) => ({
    collider: { shape: box(width, height), friction: 0.6 },
    appearance: STONE,
  });
  const block = (x: number, y: number, width: number, height: number) =>
    spawn(world, { position: { x, y }, ...stone(width, height) });
  // The lift comes first, so that the ground is drawn over it.
  const position = { x: LIFT.x, y: LIFT.low - LIFT.height / 2 };
  const lift = spawn(world, { position, velocity: {}, ...stone(LIFT.width, LIFT.height) });
  block(0, -3, 40, 6);
  for (let i = 1; i <= STAIRS; i++) block(5.25 + i / 4, (i - 0.5) * RISE, 3.5 - i / 2, RISE);
  const ramp = polygon([{ x: 7 }, { x: 9 }, { x: 7, y: LANDING }]);
  spawn(world, { position: ramp.centre, collider: { shape: ramp, friction: 0.6 }, appearance: STONE });
  block(10.4, 3, 0.3, 6);
  block(-10.4, 3, 0.3, 6);
  block(-9.3, 4.1, 2, 0.25);
  for (const [x, y] of PLATFORMS) {
    spawn(world, {
      position: { x, y },
      collider: { shape: box(1.8, 0.14), friction: 0.6, oneWay: true },
      appearance: STONE,
    });
  }
  for (const x of [-3.4, -2.6]) {
    const crate = { shape: box(0.7, 0.7), density: 40, friction: 0.6 };
    spawn(world, { position: { x, y: 0.35 }, velocity: {}, collider: crate, appearance: WOOD });
  }
  return lift;
}

export default defineExample({
  id: 'ch17-character',
  title: 'A character',
  chapter: 17,
  tags: ['rigid bodies', 'collision', 'game'],
  about:
    'The figure of a game obeys its player more than Newton: it stops at once, turns in the air and never falls over. So it is no body that forces move. Before each step it is asked where it wants to go, and what is in the way decides how far it gets: it slides along walls, climbs steps, is stopped by slopes that are too steep, rides on the lift, and passes through thin platforms from below. Walk with ← and →, jump with ↑, and get to the lamp. The others walk, jump and ride by themselves.',
  duration: 12,
  parameters: {
    speed: { label: 'Speed', unit: 'm/s', initial: 3, min: 1, max: 8 },
    jump: { label: 'Height of a jump', unit: 'm', initial: 1.5, min: 0.2, max: 4 },
    highestStep: { label: 'Highest step', unit: 'm', initial: 0.25, min: 0, max: 0.5 },
    slope: { label: 'Steepest slope', unit: '°', initial: 45, min: 5, max: 80 },
    gravity: { label: 'Gravity', unit: 'm/s²', initial: 9.81, min: 1, max: 25 },
  },
  presets: [
    { label: 'On the Moon', values: { gravity: 1.62, jump: 3 } },
    { label: 'Stiff knees', values: { highestStep: 0.1 } },
    { label: 'Smooth soles', values: { slope: 15 } },
  ],
  build(values: Values, { integrator = softStep() }: BuildOptions): CharacterRun {
    const { highestStep, slope, gravity } = values;
    const world = createPhysicsWorld({
      preset: rigidBodies,
      capacity: 60,
      components: [Walker],
      forces: [uniformGravity({ y: -gravity })],
      integrator,
    });
    const lift = addCourse(world);
    const hero = addWalker(world, { x: 2.4, y: 0 }, rgba(1, 0.71, 0.33));
    const guide = addWalker(world, { x: 2, y: 0 }, rgba(0.36, 0.55, 1), { wanted: 1.5, from: 2, to: 8.9 });
    const jumper = addWalker(world, { x: 9.7, y: 0 }, rgba(0.4, 0.75, 0.6), { jump: jumpSpeed(values) });
    const rider = addWalker(world, { x: LIFT.x, y: LIFT.low }, rgba(0.8, 0.5, 0.7));
    moveWalkers(world, [hero, guide, jumper, rider], {
      gravity,
      maxSlope: slope * DEGREE,
      stepHeight: highestStep,
    });
    world.phases.input.unshift((self) => {
      const half = LIFT.period / 2;
      const rises = Math.floor(self.time / half) % 2 === 0;
      self.components.Velocity.y[lift] = ((rises ? 1 : -1) * (LIFT.high - LIFT.low)) / half;
    });
    const walker = columnsOf(world, Walker);
    const feetOf = (id: number) => positionOf(world, id).y - WALKER.middle - GAP;
    return { world, dt: 1 / 120, hero, guide, jumper, rider, walker, values, feetOf };
  },
  actions: {
    left: held('←', 'arrowleft', 'walk to the left', ({ walker, hero, values }: CharacterRun, on) => {
      walker.wanted[hero] = -values.speed * on;
    }),
    right: held('→', 'arrowright', 'walk to the right', ({ walker, hero, values }: CharacterRun, on) => {
      walker.wanted[hero] = values.speed * on;
    }),
    up: held('↑', 'arrowup', 'jump', ({ walker, hero, values }: CharacterRun, on) => {
      walker.jump[hero] = jumpSpeed(values) * on;
    }),
  },
  picture({ world, hero }) {
    const at = () => positionOf(world, hero);
    const reached = () => Math.abs(at().x - LAMP.x) < 0.7 && at().y > LAMP.y - 1;
    return {
      view: { minX: -10.6, maxX: 10.6, minY: -0.6, maxY: 6 },
      fills: [{ shape: { centre: LAMP, radius: 0.22 }, color: COLORS.yellow }],
      labels: [
        {
          at: { x: LAMP.x + 0.6, y: LAMP.y + 0.45 },
          text: () => (reached() ? 'There!' : 'lamp'),
          color: COLORS.yellow,
        },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Height of the feet',
      'h, m',
      { label: 'you', value: ({ feetOf, hero }) => feetOf(hero) },
      { label: 'the blue one', value: ({ feetOf, guide }) => feetOf(guide) },
    ),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'Height of a jump, v²/2g',
      unit: 'm',
      exact: ({ jump }) => jump,
      tolerance: { absolute: 1e-3 },
      // The first one: the next begins as soon as the ground is near, a little above it.
      at: { event: ({ walker, jumper }) => -walker.velocityY[jumper] },
      measure: ({ feetOf, jumper }) => feetOf(jumper),
    },
    largest(6, 'Height on the stairs', { exact: LANDING, unit: 'm', absolute: 1e-4 }, ({ feetOf, guide }) =>
      feetOf(guide),
    ),
    at(
      4,
      'Height of the one on the lift',
      { exact: LIFT.low + (4 / 5) * (LIFT.high - LIFT.low), unit: 'm', absolute: 1e-4 },
      ({ feetOf, rider }) => feetOf(rider),
    ),
  ],
  tryThis: [
    'Choose “Stiff knees”: the stairs are walls now, but the platforms and the lift still lead to the lamp.',
    'Choose “Smooth soles”: the ramp behind the stairs is too steep to walk up.',
    'Push the crates to the stairs, or jump on them.',
  ],
});

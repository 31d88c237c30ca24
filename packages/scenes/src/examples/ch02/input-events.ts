import { createPhysicsWorld, keepState, linearDrag, rgba, spawn, thrust, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const DELAY = 120;
const VIEW = { minX: -350, maxX: 350, minY: -200, maxY: 200 };

/** Keys of the first seconds, so that there is something to be seen: step, and push to the right and upwards. */
const OPENING: readonly (readonly number[])[] = [
  [60, 1, 0],
  [120, 0, 1],
  [165, -1, 0],
  [240, 0, -1],
  [285, 0, 0],
];

export default defineExample({
  id: 'ch02-input-events',
  title: 'An echo of your keys',
  chapter: 2,
  tags: ['control', 'determinism', 'thrust'],
  about:
    'Each arrow key pushes the white puck, on ice that brakes it a little. All keys are written down with their time, and two seconds later the orange puck gets the same list. It does exactly what the white one did: a game that records keys can be shown again to the last digit.',
  duration: 10,
  parameters: {
    push: { label: 'Force of a key', unit: 'N', initial: 80, min: 10, max: 200 },
    drag: { label: 'Drag of the ice', unit: 'kg/s', initial: 0.3, min: 0, max: 2 },
  },
  build({ push, drag }: ValuesOf<'push' | 'drag'>, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [thrust(), linearDrag()], integrator });
    const puck = { position: {}, velocity: {}, mass: 1, linearDrag: drag, thrust: {} };
    const first = spawn(world, { ...puck, collider: 16, appearance: { color: rgba(0.91, 0.93, 0.98) } });
    const echo = spawn(world, { ...puck, collider: 10, appearance: { color: rgba(1, 0.7, 0.28) } });
    const keys = { log: OPENING.map((entry) => [...entry]), path: [] as number[], right: 0, up: 0 };
    keepState(world, keys);
    /** Writes down a change of the keys in this step. */
    const press = (right: number, up: number) => {
      keys.right += right;
      keys.up += up;
      keys.log.push([world.tick, keys.right, keys.up]);
    };
    const { Thrust } = world.components;
    world.phases.input.push(() => {
      for (const [tick, right, up] of keys.log) {
        for (const [id, start] of [
          [first, tick],
          [echo, tick + DELAY],
        ]) {
          if (start !== world.tick) continue;
          Thrust.x[id] = push * right;
          Thrust.y[id] = push * up;
        }
      }
      keys.path.push(positionOf(world, first).x, positionOf(world, first).y);
    });
    return { world, dt: 1 / 60, first, echo, keys, press };
  },
  picture: ({ world, first, echo }) => ({
    view: VIEW,
    trails: [
      { body: first, length: 400 },
      { body: echo, length: 400 },
    ],
    arrows: [velocityArrow(world, first, 1)],
    labels: [
      {
        at: () => ({ x: positionOf(world, echo).x + 14, y: positionOf(world, echo).y }),
        text: 'two seconds later',
        color: COLORS.orange,
      },
    ],
  }),
  actions: {
    left: {
      label: '←',
      about: 'push to the left',
      key: 'arrowleft',
      press: (run) => run.press(-1, 0),
      release: (run) => run.press(1, 0),
    },
    right: {
      label: '→',
      about: 'push to the right',
      key: 'arrowright',
      press: (run) => run.press(1, 0),
      release: (run) => run.press(-1, 0),
    },
    up: {
      label: '↑',
      about: 'push upwards',
      key: 'arrowup',
      press: (run) => run.press(0, 1),
      release: (run) => run.press(0, -1),
    },
    down: {
      label: '↓',
      about: 'push downwards',
      key: 'arrowdown',
      press: (run) => run.press(0, -1),
      release: (run) => run.press(0, 1),
    },
  },
  plots: (plot) => [
    plot(
      'Speed to the right',
      'v, px/s',
      { label: 'puck', value: ({ world, first }) => velocityOf(world, first).x },
      { label: 'echo', value: ({ world, echo }) => velocityOf(world, echo).x },
    ),
  ],
  checks: ({ at }) => [
    at(
      8,
      'Distance of the echo from where the puck was two seconds ago, after 8 s',
      { exact: 0, unit: 'px', absolute: 0 },
      ({ world, echo, keys: { path } }) => {
        const [{ x, y }, i] = [positionOf(world, echo), 2 * (world.tick - DELAY)];
        return Math.max(Math.abs(x - path[i]), Math.abs(y - path[i + 1]));
      },
    ),
  ],
  tryThis: [
    'Press the arrow keys in any rhythm, and watch the orange puck dance to it two seconds later.',
    'Set the drag to 0: the pucks keep the speed that the keys have given them.',
  ],
});

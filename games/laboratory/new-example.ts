/** What a reader starts an example of their own from: the first game of the README, a ball to keep up. */
import type { ExampleEntry } from '@principia/scenes/examples/list';
import { exampleFrom } from './run-code.ts';
import { WORDS } from './words.ts';

/** Its name in the address. */
export const NEW = 'new';

export const NEW_SOURCE = `import { boxWalls, createPhysicsWorld, keepState, quadraticDrag, spawn, uniformGravity } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { positionOf } from '../support/read.ts';

// A room with a ball in it. SI units throughout.
const ROOM = { minX: -8, maxX: 8, minY: 0, maxY: 9 };

export default defineExample({
  id: '${NEW}',
  title: 'Keep it up',
  chapter: 1,
  tags: ['my own'],
  about: 'Kick the ball before it touches the floor. Change what you like, and run it.',
  duration: 30,
  parameters: {
    gravity: { label: 'Gravity', unit: 'm/s²', initial: 9.81, min: 1, max: 25 },
    bounce: { label: 'Speed kept in a bounce', initial: 0.8, min: 0, max: 1 },
  },
  build({ gravity, bounce }, options) {
    const { minX, maxX, minY, maxY } = ROOM;
    const world = createPhysicsWorld({
      forces: [uniformGravity({ y: -gravity }), quadraticDrag()],
      walls: [boxWalls({ min: { x: minX, y: minY }, max: { x: maxX, y: maxY } })],
      ...options,
    });
    const collider = { radius: 0.5, restitution: bounce };
    const ball = spawn(world, { position: { y: 6 }, velocity: { x: 3 }, mass: 1, collider, quadraticDrag: 0.01 });
    const state = { score: 0 };
    keepState(world, state); // so that rewinding brings it back
    world.phases.events.push(() => {
      if (positionOf(world, ball).y < 0.7) state.score = 0;
    });
    return { world, dt: 1 / 120, ball, state };
  },
  picture: ({ ball, state }) => ({
    view: ROOM,
    lines: [{ from: { x: -8, y: 0 }, to: { x: 8, y: 0 }, width: 4 }],
    trails: [{ body: ball, length: 200 }],
    labels: [{ at: { x: -7.5, y: 8.2 }, text: () => state.score + ' kicks' }],
  }),
  actions: {
    action: {
      label: 'Kick',
      about: 'kick the ball upwards',
      key: 'e',
      press({ world, ball, state }) {
        world.components.Velocity.y[ball] = 9;
        state.score++;
      },
    },
  },
  plots: (plot) => [plot('Height', 'y, m', { label: 'ball', value: ({ world, ball }) => positionOf(world, ball).y })],
  checks: ({ at }) => [
    at(
      0.5,
      'Height after half a second, 6 − g t²/2 but for the drag',
      { exact: ({ gravity }) => 6 - gravity / 8, unit: 'm', relative: 0.01 },
      ({ world, ball }) => positionOf(world, ball).y,
    ),
  ],
  tryThis: ['Make gravity that of the Moon, 1.6 m/s².', 'Spawn a second ball, and trail it.'],
});
`;

/** As an entry of the list. */
export const NEW_ENTRY: ExampleEntry = {
  id: NEW,
  title: WORDS.list.new,
  chapter: 1,
  tags: [],
  about: '',
  dimensions: 2,
  load: () => exampleFrom(NEW_SOURCE),
};

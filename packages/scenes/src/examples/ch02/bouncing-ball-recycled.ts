import { bodies, createRandom, keepState, spawn, velocityVerlet } from '@principia/physics';
import { relaunchOutside, removeOutside, wrapAround } from '../../edges.ts';
import { teleport } from '../../teleport.ts';
import { choiceOf, defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';
import { GROUND, RADIUS, randomLaunch, STAGE, STAGE_VIEW, stageWorld } from '../support/stage.ts';

const START = { x: 50, y: 50 };
/** The stage with a ball's width beyond its right side; a ball that comes back does so beyond the left. */
const OPEN = { max: { x: STAGE.maxX + RADIUS } };
const RING = { ...OPEN, min: { x: STAGE.minX - RADIUS } };

export default defineExample({
  id: 'ch02-bouncing-ball-recycled',
  title: 'One ball, used again and again',
  chapter: 2,
  tags: ['bounce', 'random numbers', 'recycling'],
  about:
    'As soon as the ball has left on the right, it is put back to its start and thrown again, at random. It looks like an endless supply of balls, but it is always the same one: a game that recycles what nobody sees any more needs little memory, however long it runs. Other games let it come back on the other side, or remove it.',
  duration: 30,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 360, min: 60, max: 900 },
    restitution: { label: 'Speed kept in a bounce', initial: 0.8, min: 0, max: 0.95 },
    edge: choiceOf('On the right it is', ['thrown anew', 'moved to the left', 'removed']),
  },
  presets: [{ label: 'Removed', values: { edge: 2 } }],
  build({ gravity, restitution, edge }, { seed, integrator = velocityVerlet }) {
    const world = stageWorld(gravity, { seed, integrator });
    const random = createRandom(seed);
    const collider = { radius: RADIUS, restitution };
    const ball = spawn(world, { position: START, velocity: randomLaunch(random), mass: 1, collider });
    const launches = { count: 1 };
    keepState(world, launches, random.state);
    const throwAnew = relaunchOutside(OPEN, [ball], () => {
      teleport(world, ball, START, randomLaunch(random));
      launches.count++;
    });
    world.phases.input.push([throwAnew, wrapAround(RING), removeOutside(OPEN)][edge]);
    return { world, dt: 1 / 60, ball, launches };
  },
  picture: ({ world, ball, launches }) => ({
    yDown: true,
    view: STAGE_VIEW,
    fills: [GROUND],
    trails: [{ body: ball, length: 300 }],
    arrows: [velocityArrow(world, ball, 0.3)],
    labels: [{ at: { x: 20, y: 495 }, text: () => `throw ${launches.count}` }],
  }),
  plots: (plot) => [
    plot('Distance to the right', 'x, px', { label: 'x', value: ({ world, ball }) => positionOf(world, ball).x }),
  ],
  checks: ({ at, largest }) => [
    largest(30, 'Most balls at any time', { exact: 1, absolute: 0 }, ({ world }) => bodies(world).count),
    largest(
      30,
      'Furthest to the right, at most a step of 5 px beyond the edge',
      { exact: STAGE.maxX + RADIUS + 2.5, unit: 'px', absolute: 2.5 },
      ({ world, ball }) => positionOf(world, ball).x,
    ),
    at(
      30,
      'Balls that are left after 30 s',
      { exact: 0, absolute: 0, preset: 'Removed' },
      ({ world }) => bodies(world).count,
    ),
  ],
  tryThis: [
    'Choose “Removed”: the ball leaves, and the stage stays empty.',
    'Set the speed that is kept to 0: the ball slides out along the floor, and the next throw begins in the air again.',
    'Watch the second figure: the ball is put back in the first step after it has left.',
  ],
});

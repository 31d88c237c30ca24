import { keepState, spawn, velocityVerlet } from '@principia/physics';
import { teleport } from '../../teleport.ts';
import { defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';
import { comeBack, GROUND, RADIUS, STAGE_VIEW, stageWorld } from '../support/stage.ts';

const START = { x: 50, y: 50 };

/** When the ball is held without a key, s. */
const HELD = { from: 2, to: 3 };

export default defineExample({
  id: 'ch02-pause',
  title: 'Hold the ball, let it go on',
  chapter: 2,
  tags: ['bounce', 'time', 'control'],
  about:
    'From the second to the third second the ball stands still in the air, and then goes on as if nothing had happened: at the same place with the same velocity, only a second later. Hold H to stop it again. A pause must not change anything; else every pause would spoil the game.',
  duration: 12,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 360, min: 60, max: 900 },
    speed: { label: 'Speed to the right', unit: 'px/s', initial: 120, min: 10, max: 300 },
  },
  build({ gravity, speed }, { integrator = velocityVerlet }) {
    const world = stageWorld(gravity, { integrator });
    const collider = { radius: RADIUS, restitution: 0.8 };
    const ball = spawn(world, { position: START, velocity: { x: speed }, mass: 1, collider });
    const hold = { byKey: false, isOn: false, time: 0, change: 0, x: 0, y: 0, vx: 0, vy: 0 };
    keepState(world, hold);
    comeBack(world, [ball]);
    world.phases.input.push(() => {
      const { x, y } = positionOf(world, ball);
      const { x: vx, y: vy } = velocityOf(world, ball);
      const isHeld = hold.byKey || (world.time > HELD.from - 1e-6 && world.time < HELD.to - 1e-6);
      if (isHeld && !hold.isOn) Object.assign(hold, { x, y, vx, vy });
      hold.isOn = isHeld;
    });
    // A held ball takes part in the step, and is put back afterwards.
    world.phases.events.push(() => {
      if (!hold.isOn) return;
      hold.time += 1 / 60;
      teleport(world, ball, hold, { x: hold.vx, y: hold.vy });
    });
    return { world, dt: 1 / 60, ball, hold };
  },
  picture: ({ world, ball, hold }) => ({
    yDown: true,
    view: STAGE_VIEW,
    fills: [GROUND],
    trails: [{ body: ball, length: 300 }],
    arrows: [velocityArrow(world, ball, 0.2)],
    labels: [{ at: { x: 20, y: 495 }, text: () => (hold.isOn ? 'held' : `${hold.time.toFixed(1)} s held so far`) }],
  }),
  actions: {
    action: {
      label: 'Hold',
      about: 'hold the ball',
      key: 'h',
      press: ({ hold }) => void Object.assign(hold, { byKey: true }),
      release: ({ hold }) => void Object.assign(hold, { byKey: false }),
    },
  },
  pointer: 'action',
  plots: (plot) => [
    plot('Height', 'height, px', { label: 'height', value: ({ world, ball }) => 480 - positionOf(world, ball).y }),
  ],
  checks: ({ at }) => [
    at(
      HELD.to,
      'Velocity after the pause, less that before it',
      { exact: 0, unit: 'px/s', absolute: 0 },
      ({ world, ball, hold }) => velocityOf(world, ball).y - hold.vy,
    ),
    at(
      HELD.to,
      'Place after the pause, less that before it',
      { exact: 0, unit: 'px', absolute: 0 },
      ({ world, ball, hold }) => positionOf(world, ball).y - hold.y,
    ),
    at(
      5,
      'Time of moving and time of holding, at 5 s',
      { exact: 5, unit: 's', absolute: 1e-9 },
      ({ world, ball, hold }) => (positionOf(world, ball).x - START.x) / velocityOf(world, ball).x + hold.time,
    ),
  ],
  tryThis: [
    'Hold H while the ball is in the air: the curve of the height gets a level piece, and goes on behind it unchanged.',
    'Press the space bar instead: that stops the clock of the whole page, and the curves stop as well.',
  ],
});

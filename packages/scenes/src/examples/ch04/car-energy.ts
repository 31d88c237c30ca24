import { createPhysicsWorld, exp, linearDrag, motors, rgba, rungeKutta4, spawn } from '@principia/physics';
import { wrapAround } from '../../edges.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { speedOf } from '../support/read.ts';

type Values = ValuesOf<'power' | 'drag' | 'speed'>;
const ROAD = 700;

/** Speed with full throttle all the time: v² approaches P/c. */
function exactSpeed(t: number, { power, drag, speed }: Values): number {
  const limit = power / drag;
  return Math.sqrt(limit + (speed * speed - limit) * exp(-2 * drag * t));
}

const highestSpeed = ({ power, drag }: Values) => Math.sqrt(power / drag);

/** Whether the speed after a minute is as good as the highest. */
const hasSettled = (values: Values) => Math.abs(exactSpeed(60, values) / highestSpeed(values) - 1) < 5e-4;

export default defineExample({
  id: 'ch04-car-energy',
  title: 'Two cars and their energy',
  chapter: 4,
  tags: ['energy', 'power', 'drag'],
  about:
    'The blue car has its engine at full power: each second it adds 50 J, and the drag takes c v² away. The speed settles where both are equal. The orange car coasts with the engine off, and loses its energy little by little. Hold the up arrow to switch its engine on.',
  duration: 60,
  parameters: {
    power: { label: 'Power of the engine', unit: 'W', initial: 50, min: 10, max: 200 },
    drag: { label: 'Drag coefficient', unit: 'kg/s', initial: 0.1, min: 0.05, max: 0.5 },
    speed: { label: 'Speed at the start', unit: 'px/s', initial: 20, min: 5, max: 40 },
  },
  presets: [{ label: 'Too fast at first', values: { speed: 40 } }],
  build({ power, drag, speed }: Values, { integrator = rungeKutta4 }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [motors(), linearDrag()], integrator });
    const car = { velocity: { x: speed }, mass: 1, linearDrag: drag, collider: 18 };
    const ball = spawn(world, { ...car, position: { x: 50, y: 80 }, motor: { power } });
    const coasting = spawn(world, {
      ...car,
      position: { x: 50, y: 20 },
      motor: { power: 0 },
      appearance: rgba(1, 0.7, 0.28),
    });
    world.phases.input.push(wrapAround({ min: { x: 0 }, max: { x: ROAD } }, [ball, coasting]));
    return { world, dt: 1 / 60, ball, coasting };
  },
  picture: ({ world, ball, coasting }) => ({
    view: { minX: 0, maxX: ROAD, minY: -150, maxY: 250 },
    fills: [
      { shape: { minX: -2000, maxX: 2000, minY: 60, maxY: 63 }, color: COLORS.ground },
      { shape: { minX: -2000, maxX: 2000, minY: 0, maxY: 3 }, color: COLORS.ground },
    ],
    arrows: [ball, coasting].map((id) => velocityArrow(world, id, 3)),
    labels: [
      {
        at: () => ({ x: 10, y: 110 }),
        text: () => `engine on: ${speedOf(world, ball).toFixed(1)} px/s`,
        color: COLORS.blue,
      },
      {
        at: () => ({ x: 10, y: -40 }),
        text: () => `coasting: ${speedOf(world, coasting).toFixed(1)} px/s`,
        color: COLORS.orange,
      },
    ],
  }),
  actions: {
    up: {
      label: '↑',
      about: 'switch the engine of the orange car on',
      key: 'arrowup',
      press: ({ world, ball, coasting }) => {
        const { power } = world.components.Motor;
        power[coasting] = power[ball];
      },
      release: ({ world, coasting }) => {
        world.components.Motor.power[coasting] = 0;
      },
    },
  },
  pointer: 'up',
  plots: (plot) => [
    plot(
      'Speed',
      'v, px/s',
      { label: 'engine on', value: ({ world, ball }) => speedOf(world, ball), exact: exactSpeed },
      { label: 'coasting', value: ({ world, coasting }) => speedOf(world, coasting) },
    ),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Speed after 10 s with the engine on',
      { exact: (values) => exactSpeed(10, values), unit: 'px/s', relative: 1e-3 },
      ({ world, ball }) => speedOf(world, ball),
    ),
    at(
      60,
      'Highest speed, √(P/c)',
      { exact: highestSpeed, holds: hasSettled, unit: 'px/s', relative: 1e-3 },
      ({ world, ball }) => speedOf(world, ball),
    ),
    at(
      10,
      'Speed after 10 s of coasting, v₀ e^(−ct/m)',
      { exact: ({ speed, drag }) => speed * exp(-10 * drag), unit: 'px/s', relative: 1e-3 },
      ({ world, coasting }) => speedOf(world, coasting),
    ),
  ],
  tryThis: [
    'Give the engine four times the power: the car becomes only twice as fast, because drag eats c v² each second.',
    'Start too fast: the engine runs at full power, and yet the car slows down to the same speed.',
  ],
});

import {
  createPhysicsWorld,
  exp,
  linearDrag,
  positionFirstEuler,
  rungeKutta4,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'mass' | 'gravity' | 'drag'>;
const terminal = ({ mass, gravity, drag }: Values) => (mass * gravity) / drag;
const exactSpeed = (t: number, values: Values) => terminal(values) * (1 - exp((-values.drag * t) / values.mass));

export default defineExample({
  id: 'ch04-fall-with-drag',
  title: 'Falling in honey',
  chapter: 4,
  tags: ['gravity', 'drag', 'terminal velocity'],
  about:
    'The weight m g pulls down, and the drag k v pulls back, harder the faster the ball falls. What is left of the force shrinks as the drag grows, and with it the acceleration. In the end both are equal, and the ball falls evenly at the terminal velocity m g/k. Each two seconds the missing speed shrinks to 37 %.',
  duration: 30,
  parameters: {
    mass: { label: 'Mass', unit: 'kg', initial: 1, min: 0.5, max: 3 },
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 10, min: 1, max: 20 },
    drag: { label: 'Drag coefficient', unit: 'kg/s', initial: 0.5, min: 0.2, max: 2 },
  },
  presets: [{ label: 'A heavy ball', values: { mass: 3 } }],
  build({ mass, gravity, drag }, { integrator = rungeKutta4 }) {
    const forces = [uniformGravity({ y: gravity }), linearDrag()];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const ball = spawn(world, { position: { x: 75, y: 20 }, velocity: {}, mass, collider: 15, linearDrag: drag });
    return { world, dt: 1 / 60, ball, limit: terminal({ mass, gravity, drag }) };
  },
  picture({ world, ball }, { mass, gravity, drag }) {
    // The picture follows the ball: the marks of the shaft pass by.
    const depth = () => positionOf(world, ball).y - 20;
    const marks = Array.from({ length: 64 }, (_, i) => 20 + 25 * i);
    return {
      yDown: true,
      view: { minX: -250, maxX: 400, minY: 0, maxY: 600 },
      lines: marks.map((y) => ({ from: { x: 0, y }, to: { x: 20, y }, color: COLORS.grey, width: 1 })),
      labels: [{ at: { x: 110, y: 24 }, text: () => `depth ${depth().toFixed(0)} px` }],
      trails: [{ body: ball, length: 600 }],
      arrows: [
        {
          label: 'weight',
          from: () => positionOf(world, ball),
          vector: () => ({ x: 0, y: mass * gravity }),
          scale: 8,
          color: COLORS.orange,
        },
        {
          label: 'drag',
          from: () => positionOf(world, ball),
          vector: () => ({ x: 0, y: -drag * velocityOf(world, ball).y }),
          scale: 8,
          color: COLORS.red,
        },
      ],
    };
  },
  plots: (plot) => [
    plot('Velocity', 'v, px/s', {
      label: 'stepped',
      value: ({ world, ball }) => velocityOf(world, ball).y,
      exact: exactSpeed,
    }),
    plot('Velocity that is missing', 'vₜ − v, px/s', {
      label: 'missing',
      value: ({ world, ball, limit }) => limit - velocityOf(world, ball).y,
    }),
  ],
  checks: ({ at }) => [
    at(
      5,
      'Velocity after 5 s',
      { exact: (values) => exactSpeed(5, values), unit: 'px/s', relative: 1e-5 },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
    at(
      30,
      'Terminal velocity, m g/k',
      { exact: 20, unit: 'px/s', relative: 1e-5 },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
    at(
      5,
      'Velocity after 5 s by the simplest scheme',
      { exact: 18.3583, unit: 'px/s', absolute: 0.02, integrator: positionFirstEuler },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
  ],
  tryThis: [
    'Make the ball three times as heavy: it falls three times as fast in the end, and needs three times as long to get there.',
    'Without air, heavy and light fall alike; with drag, the heavy one wins.',
  ],
});

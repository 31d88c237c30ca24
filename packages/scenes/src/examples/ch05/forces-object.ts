import {
  createPhysicsWorld,
  linearDrag,
  quadraticDrag,
  spawn,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { distanceBetween, lengthOf, positionOf, velocityOf } from '../support/read.ts';

const MASS = 2;
const DT = 1 / 240;
const LINEAR = 0.2;
type Values = ValuesOf<'gravity' | 'wind' | 'drag'>;

export default defineExample({
  id: 'ch05-forces-object',
  title: 'All forces together',
  chapter: 5,
  tags: ['forces', 'drag', 'wind'],
  about:
    'Three forces act on the ball: its weight; a linear drag, against its velocity; and a quadratic drag, against its velocity relative to the wind, which so pushes it along. Each is computed by itself, as if the others were not there, and then their arrows are added. The white arrow is the sum, and it alone says how the velocity changes. In the end it vanishes.',
  duration: 10,
  parameters: {
    gravity: { label: 'Gravity', unit: 'm/s²', initial: 10, min: 0, max: 20 },
    wind: { label: 'Wind to the right', unit: 'm/s', initial: 6, min: -12, max: 12 },
    drag: { label: 'Quadratic drag', unit: 'kg/m', initial: 0.1, min: 0.02, max: 0.5 },
  },
  presets: [{ label: 'No wind', values: { wind: 0 } }],
  build({ gravity, wind, drag }: Values, { integrator = velocityVerlet }: BuildOptions) {
    const forces = [uniformGravity({ y: -gravity }), linearDrag(), quadraticDrag({ x: wind })];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const body = { mass: MASS, linearDrag: LINEAR, quadraticDrag: drag, collider: 1.5 };
    const ball = spawn(world, { position: { y: 60 }, velocity: { x: 3, y: 8 }, ...body });
    const weight = (): Point => ({ x: 0, y: -MASS * gravity });
    const friction = (): Point => {
      const v = velocityOf(world, ball);
      return { x: -LINEAR * v.x, y: -LINEAR * v.y };
    };
    const push = (): Point => {
      const v = velocityOf(world, ball);
      const w = { x: v.x - wind, y: v.y };
      return { x: -drag * lengthOf(w) * w.x, y: -drag * lengthOf(w) * w.y };
    };
    const sum = (): Point => [weight(), friction(), push()].reduce((a, b) => ({ x: a.x + b.x, y: a.y + b.y }));
    const first = sum();
    return { world, dt: DT, ball, weight, friction, push, sum, first };
  },
  picture({ world, ball, weight, friction, push, sum }) {
    const at = () => positionOf(world, ball);
    return {
      view: { minX: -40, maxX: 80, minY: -35, maxY: 75 },
      trails: [{ body: ball, length: 1500 }],
      arrows: [
        { label: 'weight', from: at, vector: weight, scale: 0.7, color: COLORS.orange },
        { label: 'linear drag', from: at, vector: friction, scale: 0.7, color: COLORS.red },
        { label: 'drag in the wind', from: at, vector: push, scale: 0.7, color: COLORS.blue },
        { label: 'sum', from: at, vector: sum, scale: 0.7, color: COLORS.white },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Sum of the forces',
      'F, N',
      { label: 'to the right', value: ({ sum }) => sum().x },
      { label: 'upwards', value: ({ sum }) => sum().y },
    ),
  ],
  checks: ({ at }) => [
    // The mean of the sums before and after the step, which is off by some dt² of the change of the forces.
    at(
      DT,
      'Mass times acceleration in the first step, less the sum',
      { exact: 0, unit: 'N', absolute: 1e-3 },
      ({ world, ball, first, sum }) => {
        const [v, last] = [velocityOf(world, ball), sum()];
        const mean = { x: (first.x + last.x) / 2, y: (first.y + last.y) / 2 };
        return distanceBetween({ x: (MASS * (v.x - 3)) / DT, y: (MASS * (v.y - 8)) / DT }, mean);
      },
    ),
    at(
      10,
      'Sum of the forces after 10 s, when the velocity has settled',
      { exact: 0, unit: 'N', absolute: 0.01 },
      ({ sum }) => lengthOf(sum()),
    ),
  ],
  tryThis: [
    'Turn the wind round: the ball is blown to the other side, and its path bends back.',
    'Take the wind away: the blue arrow stays, for still air brakes as well.',
  ],
});

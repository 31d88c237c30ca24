import { bodies, createPhysicsWorld, createRandom, rgba, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';

const DT = 1 / 60;

export default defineExample({
  id: 'ch04-ball',
  title: 'A particle gets a face',
  chapter: 4,
  tags: ['components', 'velocity'],
  about:
    'A particle is a bare point with a mass and a velocity; a ball is a particle with a size and a colour. Eleven of them are on their way here, one red and ten blue ones of any size. The size matters to the eye only: as long as no two touch and no air brakes, large and small balls move alike.',
  duration: 10,
  parameters: {
    speed: { label: 'Speed to the right', unit: 'px/s', initial: 25, min: 0, max: 60 },
    balls: { label: 'Number of blue balls', initial: 10, min: 0, max: 40, integer: true },
  },
  build({ speed, balls }: ValuesOf<'speed' | 'balls'>, { seed, integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 64, integrator });
    const random = createRandom(seed);
    const velocity = { x: speed, y: 15 };
    const red = { collider: 20, appearance: rgba(1, 0.35, 0.3) };
    const ball = spawn(world, { position: { x: 150, y: 50 }, velocity, mass: 1, ...red });
    const others = Array.from({ length: balls }, () =>
      spawn(world, {
        position: { x: random.uniform(30, 400), y: random.uniform(80, 330) },
        velocity,
        mass: 1,
        collider: random.uniform(10, 30),
        appearance: rgba(0.3, 0.55, 1),
      }),
    );
    // How far the distance of a blue ball from the red one has changed at most.
    const gap = (id: number) => positionOf(world, id).x - positionOf(world, ball).x;
    const starts = others.map(gap);
    const largestChange = () => Math.max(0, ...others.map((id, i) => Math.abs(gap(id) - starts[i])));
    return { world, dt: DT, ball, largestChange };
  },
  picture: ({ world, ball }) => ({
    yDown: true,
    view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
    trails: [{ body: ball, length: 400 }],
    arrows: [velocityArrow(world, ball, 2)],
  }),
  plots: (plot) => [
    plot('Place of the red ball', 'x, px', {
      label: 'x',
      value: ({ world, ball }) => positionOf(world, ball).x,
      exact: (t, { speed }) => 150 + speed * t,
    }),
  ],
  checks: ({ at }) => [
    at(0, 'Balls that are drawn', { exact: ({ balls }) => balls + 1, absolute: 0 }, ({ world }) => bodies(world).count),
    at(
      DT,
      'Place of the red ball after one step, x + v dt',
      { exact: ({ speed }) => 150 + speed * DT, unit: 'px', absolute: 1e-12 },
      ({ world, ball }) => positionOf(world, ball).x,
    ),
    at(
      10,
      'Largest change of a distance from the red ball in 10 s',
      { exact: 0, unit: 'px', absolute: 1e-9 },
      ({ largestChange }) => largestChange(),
    ),
  ],
  tryThis: [
    'Start again with another seed: the blue balls have other sizes and places, but all fly side by side.',
    'Drag one of them and throw it: nothing holds the group together but equal velocities.',
  ],
});

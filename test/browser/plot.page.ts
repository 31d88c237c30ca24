/** The page of `plot.test.ts`: a mass that swings far faster than the frames, at a thousand steps a second. */
import { createPhysicsWorld, defineLaw, energy, scalar, spawn, velocityVerlet } from '@principia/physics';
import { startGame } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import { paintBodies } from '../support/paint-bodies.ts';

/** Angular frequency of 19 Hz, rad/s. */
const OMEGA = 2 * Math.PI * 19;

const bowl = defineLaw({
  name: 'bowl',
  formula: 'a = -ω² r',
  parameters: { square: scalar('1/s²', { min: 0 }) },
  acceleration: ({ position }, { square }) => position.mul(square).negate(),
  potential: ({ position, mass }, { square }) => mass.mul(square).mul(position.lengthSquared()).div(2),
});

startGame({
  title: 'A fast oscillation',
  settings: {},
  create({ seed }) {
    const world = createPhysicsWorld({
      seed,
      precision: 'f64',
      integrator: velocityVerlet,
      forces: [bowl({ square: OMEGA * OMEGA })],
    });
    spawn(world, { position: { x: 1 }, velocity: {}, mass: 2, collider: { radius: 0.1 } });
    return { world, dt: 1 / 1000 };
  },
  apply: () => true,
  // In place of the energy of every world.
  quantities: { perMass: { label: 'Energy', unit: 'J/kg', value: ({ world }) => energy(world).total / 2 } },
  renderers: {
    pixi: {
      label: '2D',
      dimensions: 2,
      open: (context) =>
        openPixiView(context, {
          bounds: () => ({ minX: -2, minY: -2, maxX: 2, maxY: 2 }),
          paint: paintBodies,
        }),
    },
  },
});

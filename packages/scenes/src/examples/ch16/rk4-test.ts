import { createPhysicsWorld, explicitEuler, rungeKutta4, spawn, uniformGravity } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { positionOf } from '../support/read.ts';
import { point } from '../support/space.ts';

export default defineExample({
  id: 'ch16-rk4-test',
  title: 'Runge-Kutta falls exactly',
  chapter: 16,
  tags: ['3D', 'integrators', 'gravity'],
  about:
    'Before planets are entrusted to a scheme, it is tried where the answer is known: a ball falls from rest, s = g t²/2. Runge-Kutta 4 follows polynomials up to the fourth degree without any error, so twenty steps of a twentieth of a second give 5 m to the last digit; Euler’s steps give 4.75 m.',
  dimensions: 3,
  duration: 2,
  ends: true,
  parameters: { gravity: { label: 'Gravity', unit: 'm/s²', initial: 10, min: 1, max: 30 } },
  build({ gravity }: ValuesOf<'gravity'>, { integrator = rungeKutta4 }: BuildOptions) {
    const world = createPhysicsWorld({
      dimensions: 3,
      capacity: 2,
      forces: [uniformGravity({ y: -gravity })],
      integrator,
    });
    const ball = spawn(world, { position: {}, velocity: {}, mass: 1, collider: 0.3 });
    return { world, dt: 0.05, fallen: () => -positionOf(world, ball).y, ball };
  },
  // As deep as the ball falls in 2 s.
  picture: ({ ball }, { gravity }) => ({
    view: { minX: -4, maxX: 4, minY: -2 * gravity - 1, maxY: 1, minZ: -4, maxZ: 4 },
    camera: { eye: point(12, 2, 30), target: point(0, -9, 0) },
    trails: [{ body: ball, length: 60 }],
  }),
  plots: (plot) => [
    plot('Distance fallen', 's, m', {
      label: 'fallen',
      value: ({ fallen }) => fallen(),
      exact: (t, { gravity }) => 0.5 * gravity * t * t,
    }),
  ],
  checks: ({ at }) => [
    // Twenty sums of numbers up to 5, each rounded to one part in 10¹⁶.
    at(
      1,
      'Fallen after 1 s, g t²/2',
      { exact: ({ gravity }) => gravity / 2, unit: 'm', absolute: 1e-14 },
      ({ fallen }) => fallen(),
    ),
    at(
      1,
      'Explicit Euler after 1 s, g t (t − dt)/2',
      { exact: ({ gravity }) => (gravity * 0.95) / 2, unit: 'm', absolute: 1e-12, integrator: explicitEuler },
      ({ fallen }) => fallen(),
    ),
  ],
  tryThis: ['Choose another integrator: those of second order and more are exact here as well.'],
});

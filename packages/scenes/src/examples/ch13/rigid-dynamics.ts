import { angularDrag, box, constantTorque, createPhysicsWorld, exp, linearDrag, rgba, spawn } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { cornersOf } from '../support/outline.ts';
import { positionOf } from '../support/read.ts';

type Values = ValuesOf<'torque' | 'inertia' | 'drag'>;

/** Angular velocity of a body that starts at rest: it tends to τ/k. */
const spinAt = (t: number, { torque, inertia, drag }: Values) => (torque / drag) * (1 - exp((-drag * t) / inertia));

export default defineExample({
  id: 'ch13-rigid-dynamics',
  title: 'A torque sets a square spinning',
  chapter: 13,
  tags: ['rotation', 'torque', 'drag', 'moment of inertia'],
  about:
    'A torque does to turning what a force does to moving: angular acceleration is torque by moment of inertia. The damping grows with the angular velocity, so that this approaches τ/k, as a falling body approaches its terminal speed. At the same time the square glides to a stop by its drag.',
  duration: 50,
  parameters: {
    torque: { label: 'Torque τ', unit: 'N px', initial: 1, min: 0, max: 5 },
    inertia: { label: 'Moment of inertia I', unit: 'kg px²', initial: 5, min: 1, max: 50 },
    drag: { label: 'Angular damping k', unit: 'N px s', initial: 0.5, min: 0.1, max: 2 },
  },
  presets: [{ label: 'Four times the inertia', values: { inertia: 20 } }],
  build({ torque, inertia, drag }, options) {
    const forces = [constantTorque({ z: torque }), angularDrag(), linearDrag()];
    const world = createPhysicsWorld({ capacity: 4, forces, ...options });
    const square = spawn(world, {
      position: { x: 200, y: 200 },
      velocity: { x: 10 },
      mass: 1,
      inertia,
      rotation: 0,
      angularVelocity: 0,
      angularDrag: drag,
      linearDrag: 0.05,
      collider: { shape: box(200, 200) },
      appearance: rgba(0.25, 0.5, 0.95),
    });
    return { world, dt: 1 / 600, square, spin: () => world.components.AngularVelocity.z[square] };
  },
  picture({ world, square }) {
    return {
      view: { minX: 30, maxX: 570, minY: 40, maxY: 360 },
      dots: [{ at: () => cornersOf(world, square)[0] }],
      trails: [{ body: square, length: 1000, interval: 20, color: 0xffffff }],
      arrows: [velocityArrow(world, square, 8)],
    };
  },
  plots: (plot) => [
    plot('Angular velocity', 'ω, rad/s', { label: 'stepped', value: ({ spin }) => spin(), exact: spinAt }),
    plot('Place', 'x, px', {
      label: 'stepped',
      value: ({ world, square }) => positionOf(world, square).x,
      exact: (t) => 400 - 200 * exp(-0.05 * t),
    }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Angular velocity after 10 s, τ/k (1 − e^(−kt/I))',
      { exact: 1.26424, unit: 'rad/s', relative: 1e-4 },
      ({ spin }) => spin(),
    ),
    at(
      20,
      'Place after 20 s, 200 + 200 (1 − e^(−0.05 t))',
      { exact: 326.424, unit: 'px', relative: 1e-4 },
      ({ world, square }) => positionOf(world, square).x,
    ),
    at(
      10,
      'Angular velocity after 10 s with four times the inertia',
      { exact: (values) => spinAt(10, values), unit: 'rad/s', relative: 1e-4, preset: 'Four times the inertia' },
      ({ spin }) => spin(),
    ),
  ],
  tryThis: [
    'Choose “Four times the inertia”: the square reaches the same angular velocity, but four times as slowly.',
    'Double the torque: the final angular velocity doubles.',
  ],
});

import {
  angularDrag,
  box,
  constantTorque,
  createPhysicsWorld,
  exp,
  restrictForce,
  rgba,
  spawn,
} from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { addSwitch } from '../support/force-switch.ts';
import { cornersOf } from '../support/outline.ts';

const [INERTIA, DRAG] = [5, 0.5];

/** It tends to τ/k while the torque acts, and then slows down by the factor e in 10 s. */
function spinAt(t: number, { torque, until }: ValuesOf<'torque' | 'until'>): number {
  const rate = DRAG / INERTIA;
  const end = (torque / DRAG) * (1 - exp(-rate * Math.min(t, until)));
  return t <= until ? end : end * exp(-rate * (t - until));
}

export default defineExample({
  id: 'ch13-rigid-dynamics-mouse',
  title: 'Spin the square yourself',
  chapter: 13,
  tags: ['rotation', 'torque', 'drag', 'control'],
  about:
    'A torque acts for the first twenty seconds, and whenever you hold the key. While it acts the angular velocity comes nearer and nearer to 4 rad/s; when it stops it falls by the same law: in ten seconds to 37 per cent.',
  duration: 60,
  parameters: {
    torque: { label: 'Torque τ', unit: 'N px', initial: 2, min: 0, max: 5 },
    until: { label: 'It acts for', unit: 's', initial: 20, min: 0.5, max: 60 },
  },
  presets: [{ label: 'A short push', values: { until: 2 } }],
  build({ torque, until }, options) {
    const forces = [restrictForce(constantTorque({ z: torque }), { until }), angularDrag()];
    const world = createPhysicsWorld({ capacity: 4, forces, ...options });
    const held = addSwitch(world, constantTorque({ z: torque }));
    const square = spawn(world, {
      position: { x: 0, y: 0 },
      velocity: {},
      mass: 1,
      inertia: INERTIA,
      rotation: 0,
      angularVelocity: 0,
      angularDrag: DRAG,
      collider: { shape: box(200, 200) },
      appearance: rgba(0.25, 0.5, 0.95),
    });
    return { world, dt: 1 / 600, square, held, spin: () => world.components.AngularVelocity.z[square] };
  },
  picture({ world, square, held }, { until }) {
    const isPushed = () => held.isOn || world.time < until;
    return {
      view: { minX: -240, maxX: 240, minY: -170, maxY: 170 },
      dots: [{ at: () => cornersOf(world, square)[0] }],
      labels: [{ at: { x: 130, y: -150 }, text: () => (isPushed() ? 'the torque acts' : 'it runs down') }],
    };
  },
  actions: {
    action: {
      label: '↻',
      about: 'hold to turn',
      key: 'h',
      press({ held }) {
        held.isOn = true;
      },
      release({ held }) {
        held.isOn = false;
      },
    },
  },
  pointer: 'action',
  plots: (plot) => [
    plot('Angular velocity', 'ω, rad/s', { label: 'stepped', value: ({ spin }) => spin(), exact: spinAt }),
  ],
  checks: ({ at }) => [
    at(
      20,
      'Angular velocity after 20 s; its limit is τ/k = 4',
      { exact: (values) => spinAt(20, values), unit: 'rad/s', relative: 1e-3 },
      ({ spin }) => spin(),
    ),
    at(30, 'Ten seconds later', { exact: (values) => spinAt(30, values), unit: 'rad/s', relative: 1e-3 }, ({ spin }) =>
      spin(),
    ),
  ],
  tryThis: [
    'Hold the key when the square has slowed down: the curve of the beginning comes again.',
    'Choose “A short push”: after it the square turns ever more slowly, but never quite stops.',
  ],
});

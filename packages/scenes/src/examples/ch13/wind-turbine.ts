import { angularDrag, constantTorque, createPhysicsWorld, exp } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { addSwitch } from '../support/force-switch.ts';
import { addTurbine, turbineLines } from '../support/turbine.ts';

const DRAG = 0.5;

const spinAt = (t: number, { torque, inertia }: ValuesOf<'torque' | 'inertia'>) =>
  (torque / DRAG) * (1 - exp((-DRAG * t) / inertia));

export default defineExample({
  id: 'ch13-wind-turbine',
  title: 'A wind turbine starts',
  chapter: 13,
  tags: ['rotation', 'torque', 'energy'],
  about:
    'The wind blows at the rotor from the front, along its axis, and turns the blades with a steady torque. The faster they turn, the harder the generator brakes them. They approach the angular velocity at which both are equal. Stop the wind with the key: the turbine runs down as slowly as it started.',
  duration: 60,
  parameters: {
    torque: { label: 'Torque of the wind', unit: 'N px', initial: 2, min: 0.5, max: 5 },
    inertia: { label: 'Moment of inertia', unit: 'kg px²', initial: 5, min: 1, max: 50 },
  },
  presets: [{ label: 'Heavy blades', values: { inertia: 30 } }],
  build({ torque, inertia }, options) {
    const force = constantTorque({ z: torque });
    const world = createPhysicsWorld({ capacity: 4, forces: [angularDrag(), force], ...options });
    const wind = addSwitch(world, force, true);
    const turbine = addTurbine(world, 200, 200, 1, inertia);
    const spin = () => world.components.AngularVelocity.z[turbine];
    return { world, dt: 1 / 600, turbine, wind, spin };
  },
  picture({ world, turbine, wind, spin }) {
    const sky = { minX: -2000, maxX: 3000, minY: -60, maxY: 2000 };
    return {
      view: { minX: -60, maxX: 460, minY: -100, maxY: 370 },
      fills: [
        { shape: sky, color: 0x274a7a },
        { shape: { ...sky, minY: -2000, maxY: -60 }, color: 0x2f6b45 },
      ],
      lines: turbineLines(world, turbine, 150, -60),
      labels: [
        { at: { x: -40, y: -85 }, text: () => (wind.isOn ? 'wind, into the picture' : 'calm') },
        // The generator turns the work of the damping into current, k ω².
        { at: { x: 250, y: -85 }, text: () => `power ${(DRAG * spin() * spin()).toFixed(1)} W` },
      ],
    };
  },
  actions: {
    action: {
      label: 'Wind',
      about: 'stop the wind, or let it blow',
      key: 'w',
      press({ wind }) {
        wind.isOn = !wind.isOn;
      },
    },
  },
  pointer: 'action',
  plots: (plot) => [
    plot('Angular velocity', 'ω, rad/s', { label: 'stepped', value: ({ spin }) => spin(), exact: spinAt }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Angular velocity after 10 s, τ/k (1 − e^(−kt/I))',
      { exact: (values) => spinAt(10, values), unit: 'rad/s', relative: 1e-3 },
      ({ spin }) => spin(),
    ),
    at(
      60,
      'Angular velocity after 60 s; its limit is 4',
      { exact: (values) => spinAt(60, values), unit: 'rad/s', relative: 1e-3 },
      ({ spin }) => spin(),
    ),
  ],
  tryThis: [
    'Double the torque: the turbine turns twice as fast, and gives four times the power.',
    'Choose “Heavy blades”: it takes minutes to start, and goes on for minutes in a calm.',
  ],
});

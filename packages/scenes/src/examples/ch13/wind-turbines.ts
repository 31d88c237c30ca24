import { angularDrag, constantTorque, createPhysicsWorld, exp } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { defineExample } from '../define-example.ts';
import { addTurbine, turbineLines } from '../support/turbine.ts';

const DRAG = 0.5;
/** The inertia of thin blades grows as the fourth power of their radius; the book rounds it. */
const TURBINES = [
  { name: 'small', radius: 50, inertia: 1, mass: 1, x: 80, after: 3.6717 },
  { name: 'middle', radius: 75, inertia: 5, mass: 2.25, x: 250, after: 1.5739 },
  { name: 'large', radius: 150, inertia: 81, mass: 9, x: 520, after: 0.1216 },
] as const;

interface Run extends SceneRun {
  readonly turbines: readonly number[];
}

const spinOf = ({ world, turbines }: Run, i: number) => world.components.AngularVelocity.z[turbines[i]];

export default defineExample({
  id: 'ch13-wind-turbines',
  title: 'Large turbines start slowly',
  chapter: 13,
  tags: ['rotation', 'torque', 'moment of inertia'],
  about:
    'Three turbines feel the same torque and the same damping, and in the end all turn at 4 rad/s. But the blades of the large one are three times as long as those of the small one, which makes their moment of inertia 81 times as large: it needs minutes for what the small one does in seconds.',
  duration: 60,
  parameters: {
    torque: { label: 'Torque of the wind', unit: 'N px', initial: 2, min: 0.5, max: 5 },
    heavier: { label: 'Inertia of all', unit: '×', initial: 1, min: 0.2, max: 5, scale: 'log' },
  },
  presets: [{ label: 'Light blades', values: { heavier: 0.2 } }],
  build({ torque, heavier }, options): Run {
    const forces = [angularDrag(), constantTorque({ z: torque })];
    const world = createPhysicsWorld({ capacity: 8, forces, ...options });
    const turbines = TURBINES.map(({ x, mass, inertia }) => addTurbine(world, x, 200, mass, heavier * inertia));
    return { world, dt: 1 / 600, turbines };
  },
  picture({ world, turbines }) {
    const sky = { minX: -2000, maxX: 3000, minY: 0, maxY: 2000 };
    return {
      view: { minX: 0, maxX: 700, minY: -40, maxY: 370 },
      fills: [
        { shape: sky, color: 0x274a7a },
        { shape: { ...sky, minY: -2000, maxY: 0 }, color: 0x2f6b45 },
      ],
      lines: TURBINES.flatMap(({ radius }, i) => turbineLines(world, turbines[i], radius, 0)),
    };
  },
  plots: (plot) => [
    plot(
      'Angular velocities',
      'ω, rad/s',
      ...TURBINES.map(({ name, inertia }, i) => ({
        label: name,
        value: (run: Run) => spinOf(run, i),
        exact: (t: number, { torque, heavier }: { torque: number; heavier: number }) =>
          (torque / DRAG) * (1 - exp((-DRAG * t) / (heavier * inertia))),
      })),
    ),
  ],
  checks: TURBINES.map(({ name, after }, i) => ({
    label: `Angular velocity of the ${name} one after 5 s`,
    unit: 'rad/s',
    exact: after,
    tolerance: { relative: 1e-3 },
    at: { time: 5 },
    measure: (run: Run) => spinOf(run, i),
  })),
  tryThis: [
    'Read from the plot when each has reached 2 rad/s: after 1.4 s, after 7 s, and the large one not within a minute.',
    'Choose “Light blades”: all start five times as fast.',
  ],
});

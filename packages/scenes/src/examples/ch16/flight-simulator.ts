import {
  type ColumnsOf,
  columnsOf,
  createPhysicsWorld,
  type PhysicsWorld,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import type { Check } from '../check.ts';
import { type BuildOptions, defineExample, type ExampleAction, type ValuesOf } from '../define-example.ts';
import { COLORS, type Line } from '../picture.ts';
import {
  AEROPLANE,
  aeroplaneForces,
  DEGREE,
  headingAndPitch,
  levelFlight,
  Steering,
  steadyFlight,
} from '../support/aeroplane.ts';
import { positionOf, velocityOf } from '../support/read.ts';
import { orientationOf, type Point3, point, rotate, times } from '../support/space.ts';

type Values = ValuesOf<'push' | 'elevator' | 'aileron' | 'start'>;

/** Metres that are drawn for each metre of the aeroplane, so that it is seen in its landscape. */
const ENLARGED = 5;
const GRID = 250;
const REACH = 1000;

/** Fuselage, wing, tail and fin, m in the body's axes. */
const OUTLINE: readonly (readonly [Point3, Point3])[] = [
  [point(17, 0, 0), point(-35, 0, 0)],
  [point(0, 0, -20), point(2, 0, 0)],
  [point(0, 0, 20), point(2, 0, 0)],
  [point(-35, 0, -7), point(-35, 0, 7)],
  [point(-35, 0, 0), point(-37, 9, 0)],
];

interface FlightRun {
  readonly world: PhysicsWorld;
  readonly dt: number;
  readonly plane: number;
  readonly steering: ColumnsOf<typeof Steering>;
}

/** A key that moves a control surface; it stays where it is put. Degrees. */
function deflect(
  label: string,
  about: string,
  key: string,
  field: 'aileron' | 'elevator' | 'rudder',
  by: number,
  limit: number,
): ExampleAction<FlightRun> {
  return {
    label,
    about,
    key,
    press({ steering, plane }) {
      const angle = steering[field][plane] / DEGREE + by;
      steering[field][plane] = Math.max(-limit, Math.min(limit, angle)) * DEGREE;
    },
  };
}

/** A key that changes the thrust, kN. */
function throttle(label: string, about: string, key: string, by: number): ExampleAction<FlightRun> {
  return {
    label,
    about,
    key,
    press({ world: { components }, plane }) {
      const { x } = components.Thrust;
      x[plane] = Math.max(0, Math.min(AEROPLANE.maxThrust, x[plane] + 1000 * by));
    },
  };
}

/** Speeds over the ground and climbs that were measured in the published program with its attitude held level, m/s. */
const MEASURED = [
  { preset: '200 kN', speed: 71.997, climb: 1.324 },
  { preset: '400 kN', speed: 99.371, climb: 8.493 },
  { preset: '500 kN', speed: 111.102, climb: 11.149 },
  { preset: 'Engine off', speed: 51.203, climb: -21.335 },
  { preset: 'Exactly level', speed: 67.703, climb: undefined },
];

/** Speed and climb after a minute, in which the oscillation after the fall has died away. */
function steady(preset?: string): Check<FlightRun, Values>[] {
  const measured = MEASURED.find((each) => each.preset === preset);
  const figures = [
    ['Speed over the ground', measured?.speed ?? ((values: Values) => steadyFlight(1000 * values.push).forwards), 'x'],
    ['Climb', measured?.climb ?? ((values: Values) => steadyFlight(1000 * values.push).climb), 'y'],
  ] as const;
  return figures
    .slice(0, measured !== undefined && measured.climb === undefined ? 1 : 2)
    .map(([label, exact, axis]) => ({
      label: preset === undefined ? label : `${label}, ${preset}`,
      unit: 'm/s',
      exact,
      // With the controls in the middle.
      holds: ({ elevator, aileron }) => elevator === 0 && aileron === 0,
      tolerance: { relative: 5e-3 },
      at: { time: 60 },
      measure: ({ world, plane }) => velocityOf(world, plane)[axis],
      ...(preset === undefined ? {} : { preset }),
    }));
}

export default defineExample({
  id: 'ch16-flight-simulator',
  title: 'Fly an aeroplane',
  chapter: 16,
  tags: ['3D', 'lift', 'drag', 'thrust', 'rotation', 'project'],
  about:
    'Thirty tonnes with 300 kN of thrust begin at rest in the air, drop until the wing carries, and then climb by themselves. Elevator, ailerons and rudder turn the aeroplane; the wing lifts across the flow by its angle of attack, up to 20°, where it stalls. Deflections stay where you put them.',
  dimensions: 3,
  duration: 62,
  parameters: {
    push: { label: 'Thrust', unit: 'kN', initial: 300, min: 0, max: 500 },
    elevator: { label: 'Elevator', unit: '°', initial: 0, min: -5, max: 5 },
    aileron: { label: 'Ailerons', unit: '°', initial: 0, min: -2, max: 2 },
    start: { label: 'Speed at the start', unit: 'm/s', initial: 0, min: 0, max: 120 },
  },
  presets: [
    { label: '400 kN', values: { push: 400 } },
    { label: '500 kN', values: { push: 500 } },
    { label: '200 kN', values: { push: 200 } },
    { label: 'Engine off', values: { push: 0, start: 52 } },
    { label: 'Exactly level', values: { push: levelFlight().thrust / 1000, start: levelFlight().speed } },
  ],
  build({ push, elevator, aileron, start }: Values, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({
      dimensions: 3,
      capacity: 4,
      components: [Steering],
      forces: aeroplaneForces(),
      integrator,
    });
    const { mass, inertiaTensor, drag } = AEROPLANE;
    const plane = spawn(world, {
      position: { y: 400 },
      velocity: { x: start },
      mass,
      inertiaTensor,
      orientation: {},
      angularVelocity: {},
      thrust: { x: 1000 * push },
      quadraticDrag: drag,
    });
    addComponent(
      world,
      plane,
      set(columnsOf(world, Steering), { aileron: aileron * DEGREE, elevator: elevator * DEGREE, rudder: 0 }),
    );
    return { world, dt: 1 / 480, plane, steering: columnsOf(world, Steering) };
  },
  picture({ world, plane }) {
    const at = () => positionOf(world, plane);
    const place = (local: Point3) => () => rotate(orientationOf(world, plane), times(local, ENLARGED));
    // The ground moves below the aeroplane, which stays in the middle.
    const across = (i: number) => {
      const { x } = at();
      return i * GRID - (x - GRID * Math.floor(x / GRID));
    };
    const along = (i: number) => {
      const { z } = at();
      return i * GRID - (z - GRID * Math.floor(z / GRID));
    };
    const ground: Line[] = Array.from({ length: (2 * REACH) / GRID + 1 }, (_, k) => k - REACH / GRID).flatMap((i) => [
      {
        from: () => point(across(i), -at().y, -REACH),
        to: () => point(across(i), -at().y, REACH),
        color: COLORS.green,
        width: 1,
      },
      {
        from: () => point(-REACH, -at().y, along(i)),
        to: () => point(REACH, -at().y, along(i)),
        color: COLORS.green,
        width: 1,
      },
    ]);
    return {
      view: { minX: -330, maxX: 330, minY: -420, maxY: 160, minZ: -330, maxZ: 330 },
      camera: { eye: point(-700, 260, 500), target: point(0, 0, 0) },
      lines: [...ground, ...OUTLINE.map(([from, to]) => ({ from: place(from), to: place(to), width: 4 }))],
      arrows: [
        {
          label: 'v',
          from: point(0, 0, 0),
          vector: () => times(velocityOf(world, plane), 2.5),
          color: COLORS.yellow,
        },
      ],
      labels: [
        {
          at: point(-160, 90, 0),
          text: () => {
            const { y } = at();
            const v = velocityOf(world, plane);
            return `${y.toFixed(0)} m, ${Math.sqrt(v.x * v.x + v.z * v.z).toFixed(1)} m/s, climb ${v.y.toFixed(1)} m/s`;
          },
        },
      ],
    };
  },
  actions: {
    up: deflect('▲', 'lower the elevator: nose down', 'arrowup', 'elevator', -0.5, 20),
    left: deflect('◀', 'roll to the left', 'arrowleft', 'aileron', 0.1, 10),
    right: deflect('▶', 'roll to the right', 'arrowright', 'aileron', -0.1, 10),
    down: deflect('▼', 'raise the elevator: nose up', 'arrowdown', 'elevator', 0.5, 20),
    leftRudder: deflect('↶', 'turn the rudder to the left', 'q', 'rudder', 0.5, 20),
    rightRudder: deflect('↷', 'turn the rudder to the right', 'd', 'rudder', -0.5, 20),
    more: throttle('+10 kN', 'more thrust', 't', 10),
    less: throttle('−10 kN', 'less thrust', 'g', -10),
  },
  plots: (plot) => [
    plot('Height', 'y, m', { label: 'stepped', value: ({ world, plane }) => positionOf(world, plane).y }),
    plot('Climb', 'climb, m/s', {
      label: 'stepped',
      value: ({ world, plane }) => velocityOf(world, plane).y,
      exact: (_, { push: kilonewtons }) => steadyFlight(1000 * kilonewtons).climb,
    }),
  ],
  checks: ({ at, smallest }) => [
    // Measured in the published program with its attitude held level.
    smallest(
      60,
      'Lowest height',
      { exact: 242.8, unit: 'm', relative: 5e-3 },
      ({ world, plane }) => positionOf(world, plane).y,
    ),
    ...steady(),
    ...MEASURED.flatMap(({ preset }) => steady(preset)),
    at(
      60,
      'Speed over the ground, 300 kN, as measured',
      { exact: 86.404, unit: 'm/s', relative: 5e-3 },
      ({ world, plane }) => velocityOf(world, plane).x,
    ),
    at(
      60,
      'Thrust of exactly level flight',
      { exact: 171.887, unit: 'kN', relative: 5e-3, preset: 'Exactly level' },
      ({ world, plane }) => world.components.Thrust.x[plane] / 1000,
    ),
    at(
      60,
      'Height after a minute of exactly level flight',
      { exact: 400, unit: 'm', absolute: 1e-6, preset: 'Exactly level' },
      ({ world, plane }) => positionOf(world, plane).y,
    ),
    at(
      60,
      'Pitch that it keeps by itself',
      { exact: 0, unit: '°', absolute: 1e-9 },
      ({ world, plane }) => headingAndPitch(rotate(orientationOf(world, plane), point(1, 0, 0))).pitch / DEGREE,
    ),
  ],
  tryThis: [
    'Press ▼ once or twice and watch the climb; then ▲ as often, or the nose keeps rising until the wing stalls.',
    'Roll with ◀: the lift leans over and pulls the aeroplane round. Stop the roll with ▶, and raise the elevator a little.',
    'Switch the engine off: the glide is steep, 22°, since the drag of this aeroplane is that of a brick.',
  ],
});

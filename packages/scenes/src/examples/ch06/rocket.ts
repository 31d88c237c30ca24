import {
  attractors,
  createPhysicsWorld,
  createRandom,
  keepState,
  log,
  type PhysicsWorld,
  rocketEngines,
  rungeKutta4,
  spawn,
  thrust,
} from '@principia/physics';
import { teleport } from '../../teleport.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { held } from '../support/held.ts';
import { distanceBetween, positionOf, speedOf, velocityOf } from '../support/read.ts';

const PLANET = { x: 400, y: 400 };
const RADIUS = 100;
const GM = 1e5;
const DT = 1 / 120;
/** Force of the side thruster, N, and the mass that it burns, kg/s. */
const SIDE = { force: 10, rate: 0.1 };
/** The nose and the two ends of the tail, from the centre of the rocket. */
const HULL: readonly Point[] = [
  { x: 0, y: -14 },
  { x: 6, y: 6 },
  { x: -6, y: 6 },
];
const random = createRandom(7);
const STARS = Array.from({ length: 90 }, () => ({ x: random.uniform(-200, 1000), y: random.uniform(0, 560) }));

interface ThrusterState {
  /** -1 to the left, 1 to the right, 0 for off. */
  side: number;
  fuel: number;
  hasLanded: boolean;
  /** Where the rocket came down. */
  x: number;
  y: number;
}

/** Burns fuel of the side thruster while a key is held, and stops a rocket that has come down on the planet. */
function control(world: PhysicsWorld, rocket: number, state: ThrusterState): void {
  const { Mass, Thrust } = world.components;
  world.phases.input.push(() => {
    const isFiring = state.side !== 0 && state.fuel > 0 && !state.hasLanded;
    Thrust.x[rocket] = isFiring ? SIDE.force * state.side : 0;
    if (!isFiring) return;
    state.fuel -= SIDE.rate * DT;
    Mass.value[rocket] -= SIDE.rate * DT;
  });
  world.phases.events.push(() => {
    const { x, y } = positionOf(world, rocket);
    if (!state.hasLanded && distanceBetween({ x, y }, PLANET) < RADIUS - 0.01)
      Object.assign(state, { hasLanded: true, x, y });
    if (state.hasLanded) teleport(world, rocket, state);
  });
}

function push({ state }: { readonly state: ThrusterState }, side: number): void {
  state.side = side;
}

export default defineExample({
  id: 'ch06-rocket',
  title: 'Launch of a rocket',
  chapter: 6,
  tags: ['rocket', 'gravity', 'thrust'],
  about:
    'The engine throws gas downwards, and the rocket is pushed upwards. At first thrust and weight are just equal; but as the fuel burns the rocket becomes lighter, and rises faster and faster. After seven seconds the fuel is gone, too early for an escape. Fire the side thruster with ← and → in time, and it may fall around the planet instead of onto it.',
  duration: 75,
  parameters: {
    exhaust: { label: 'Speed of the exhaust', unit: 'px/s', initial: 200, min: 200, max: 300 },
    fuel: { label: 'Fuel', unit: 'kg', initial: 3.5, min: 1, max: 6 },
    gravity: { label: 'Gravity of the planet', initial: 1, min: 0, max: 1 },
  },
  presets: [
    { label: 'Fast enough to escape', values: { exhaust: 300 } },
    { label: 'Far from any planet', values: { gravity: 0 } },
  ],
  build(
    { exhaust, fuel, gravity }: ValuesOf<'exhaust' | 'fuel' | 'gravity'>,
    { integrator = rungeKutta4 }: BuildOptions,
  ) {
    const forces = [attractors(), rocketEngines({ frame: 'world' }), thrust()];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    spawn(world, { position: PLANET, attractor: GM * gravity });
    const engine = { exhaustSpeed: exhaust, burnRate: 0.5, fuel, y: -1 };
    const position = { x: PLANET.x, y: PLANET.y - RADIUS };
    const rocket = spawn(world, { position, velocity: {}, mass: 10, engine, thrust: {} });
    const state: ThrusterState = { side: 0, fuel: 3.5, hasLanded: false, x: 0, y: 0 };
    keepState(world, state);
    control(world, rocket, state);
    const height = () => distanceBetween(positionOf(world, rocket), PLANET) - RADIUS;
    return { world, dt: DT, rocket, state, height };
  },
  picture({ world, rocket, state }, { gravity }) {
    const { Engine, Thrust, Mass } = world.components;
    const corner = (i: number) => () => {
      const { x, y } = positionOf(world, rocket);
      return { x: x + HULL[i % 3].x, y: y + HULL[i % 3].y };
    };
    const at = () => positionOf(world, rocket);
    const weight = () => {
      const [{ x, y }, r] = [at(), distanceBetween(at(), PLANET)];
      const pull = (GM * gravity * Mass.value[rocket]) / (r * r * r);
      return { x: pull * (PLANET.x - x), y: pull * (PLANET.y - y) };
    };
    return {
      yDown: true,
      view: { minX: 100, maxX: 700, minY: 30, maxY: 510 },
      fills: [{ shape: { centre: PLANET, radius: RADIUS }, color: 0x3f7f4f }],
      dots: STARS.map((star) => ({ at: star, radius: 1, color: COLORS.white })),
      lines: [0, 1, 2].map((i) => ({ from: corner(i), to: corner(i + 1), color: COLORS.white, width: 3 })),
      trails: [{ body: rocket, length: 1500, interval: 2 }],
      arrows: [
        {
          label: '',
          from: () => ({ x: at().x, y: at().y + 7 }),
          vector: () => ({ x: -Engine.thrustX[rocket], y: -Engine.thrustY[rocket] }),
          scale: 0.3,
          color: COLORS.yellow,
        },
        { label: '', from: at, vector: () => ({ x: -Thrust.x[rocket], y: 0 }), scale: 2, color: COLORS.yellow },
        { label: 'weight', from: at, vector: weight, scale: 0.3, color: COLORS.red },
        { label: 'v', from: at, vector: () => velocityOf(world, rocket), scale: 1 },
      ],
      labels: [
        {
          at: { x: 110, y: 505 },
          text: () => `main ${Engine.fuel[rocket].toFixed(1)} kg, side ${Math.max(0, state.fuel).toFixed(1)} kg`,
        },
      ],
    };
  },
  actions: {
    left: held('←', 'arrowleft', 'push to the left', push, -1),
    right: held('→', 'arrowright', 'push to the right', push),
  },
  plots: (plot) => [
    plot('Height above the ground', 'height, px', { label: 'height', value: ({ height }) => height() }),
    plot('Speed', 'v, px/s', { label: 'speed', value: ({ world, rocket }) => speedOf(world, rocket) }),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'The fuel lasts',
      unit: 's',
      exact: ({ fuel }) => fuel / 0.5,
      // It is gone within a step.
      tolerance: { absolute: DT },
      at: { event: ({ world, rocket }) => 1e-9 - world.components.Engine.fuel[rocket] },
    },
    at(7, 'Height when it is gone', { exact: 50.87, unit: 'px', relative: 1e-3 }, ({ height }) => height()),
    at(7, 'Speed when it is gone', { exact: 27.145, unit: 'px/s', relative: 1e-3 }, ({ world, rocket }) =>
      speedOf(world, rocket),
    ),
    at(7, 'Escape speed at that height, √(2 GM/r)', { exact: 36.41, unit: 'px/s', relative: 1e-3 }, ({ height }) =>
      Math.sqrt((2 * GM) / (RADIUS + height())),
    ),
    at(DT, 'Thrust by weight at lift-off', { exact: 1, relative: 1e-3 }, ({ world, rocket, height }) => {
      const r = RADIUS + height();
      return (-world.components.Engine.thrustY[rocket] * r * r) / (GM * world.components.Mass.value[rocket]);
    }),
    at(
      8,
      'Speed without gravity, v ln(10/6.5)',
      { exact: 86.157, unit: 'px/s', absolute: 5e-4, preset: 'Far from any planet' },
      ({ world, rocket }) => speedOf(world, rocket),
    ),
    // Momentum of rocket and exhaust: m dv = -v_e dm, summed up to the logarithm.
    at(
      8,
      'The same by its exact value, 200 ln(10/6.5)',
      { exact: 1, absolute: 1e-6, preset: 'Far from any planet' },
      ({ world, rocket }) => speedOf(world, rocket) / (200 * log(10 / 6.5)),
    ),
    largest(
      70,
      'Largest distance from the centre',
      { exact: 339.69, unit: 'px', relative: 1e-3 },
      ({ height }) => RADIUS + height(),
    ),
  ],
  tryThis: [
    'Do nothing: the rocket comes down again exactly where it stood.',
    'Hold → for twelve seconds after the burn-out: the rocket falls around the planet instead of onto it.',
  ],
});

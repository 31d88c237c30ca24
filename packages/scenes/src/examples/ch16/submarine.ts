import {
  buoyancy,
  createPhysicsWorld,
  immersedDrag,
  spawn,
  thrust,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { held } from '../support/held.ts';
import { positionOf, velocityOf } from '../support/read.ts';
import {
  FILL_RATE,
  massOf,
  SEA,
  SUBMARINE,
  type SubmarineRun,
  subPicture,
  tank,
  waterHeight,
} from '../support/submarine.ts';

const { gravity, level } = SEA;
const { halfHeight, drag, thrust: push, emptyMass } = SUBMARINE;
type Values = ValuesOf<'fill' | 'engine'>;

/** Height of the centre below the surface at rest: the immersed fraction of the box is its mass. */
const restOf = (fill: number) => level + halfHeight * (2 * massOf(fill) - 1);
const REST = restOf(0.4);

function drive({ world, sub }: SubmarineRun, force: number): void {
  world.components.Thrust.x[sub] = force;
}

function flood({ state }: SubmarineRun, rate: number): void {
  state.change = rate;
}

export default defineExample({
  id: 'ch16-submarine',
  title: 'A submarine',
  chapter: 16,
  tags: ['buoyancy', 'drag', 'thrust', 'project'],
  about:
    'Water in the ballast tank makes the submarine heavier. Half full it weighs as much as the water whose place it takes, and hovers; with less it floats, with more it sinks, until drag balances what is left of its weight. The propeller pushes it to 20 px/s. Hold ↓ to flood the tank, ↑ to blow it out, ← and → to drive.',
  duration: 60,
  parameters: {
    fill: { label: 'Water in the tank', initial: 0.4, min: 0, max: 1 },
    engine: { label: 'Engine at the start', unit: 'N', initial: 0, min: 0, max: push },
  },
  presets: [
    { label: 'Full tank: a dive', values: { fill: 1 } },
    { label: 'Neutral, full ahead', values: { fill: 0.5, engine: push } },
  ],
  build({ fill, engine }: Values, { integrator = velocityVerlet }: BuildOptions): SubmarineRun {
    const water = { density: SEA.density, gravity: { y: gravity }, level: -level };
    const forces = [uniformGravity({ y: gravity }), buoyancy(water), immersedDrag(water), thrust()];
    const world = createPhysicsWorld({ capacity: 6, forces, integrator });
    const hull = { volume: SUBMARINE.volume, halfHeight, shape: 1 };
    const boat = (x: number, y: number, share: number, own: object = {}) =>
      spawn(world, {
        position: { x, y },
        velocity: {},
        mass: massOf(share),
        hull,
        quadraticDrag: drag,
        thrust: {},
        ...own,
      });
    const sub = boat(330, 330, fill, { velocity: { x: 40, y: -20 }, thrust: { x: engine } });
    // Others tell what the figures ask for: a small bob without drag, a dive, a rise, and a run at neutral weight.
    const bob = boat(-2000, REST + 1, 0.4, { quadraticDrag: 0 });
    const dive = boat(-3000, 1000, 1);
    const rise = boat(-4000, 3000, 0);
    const run = boat(-9000, 1000, 0.5, { thrust: { x: push } });
    const state = { fill, change: 0 };
    tank(world, sub, state);
    return { world, dt: 1 / 60, sub, bob, dive, rise, run, state };
  },
  picture: subPicture,
  actions: {
    left: held('◀', 'arrowleft', 'full astern', drive, -push),
    right: held('▶', 'arrowright', 'full ahead', drive, push),
    down: held('▼', 'arrowdown', 'flood the tank', flood, FILL_RATE),
    up: held('▲', 'arrowup', 'blow the tank out', flood, -FILL_RATE),
  },
  plots: (plot) => [
    plot('Depth of the centre', 'depth, px', {
      label: 'depth',
      value: ({ world, sub }) => positionOf(world, sub).y - level,
    }),
    plot('Density by that of water', 'ratio', {
      label: 'ratio',
      value: ({ world, sub }) => world.components.Mass.value[sub] / SUBMARINE.volume,
    }),
  ],
  checks: ({ at, mean }) => [
    mean(
      60,
      'It comes to rest 90 % under water, its centre at',
      { exact: REST, unit: 'px', relative: 0.005 },
      ({ world, bob }) => positionOf(world, bob).y,
    ),
    {
      label: 'Small bob, 2π √(m H/ρ V g)',
      unit: 's',
      exact: 14.6,
      tolerance: { relative: 0.005 },
      at: { event: ({ world, bob }) => positionOf(world, bob).y - REST, from: 1, to: 2 },
    },
    at(
      10,
      'Full tank: speed of the dive after 10 s',
      { exact: 9.9746, unit: 'px/s', relative: 1e-4 },
      ({ world, dive }) => velocityOf(world, dive).y,
    ),
    at(
      30,
      'Empty tank: final speed of the rise',
      { exact: 10, unit: 'px/s', relative: 1e-4 },
      ({ world, rise }) => -velocityOf(world, rise).y,
    ),
    at(
      5,
      'Neutral: speed after 5 s of full thrust, 20 tanh t',
      { exact: 19.998, unit: 'px/s', relative: 1e-4 },
      ({ world, run }) => velocityOf(world, run).x,
    ),
    at(
      30,
      'Neutral: depth does not change',
      { exact: 1000, unit: 'px', absolute: 1e-9 },
      ({ world, run }) => positionOf(world, run).y,
    ),
    at(
      0,
      'Height of the water in the tank, a fraction of 30 px',
      { exact: ({ fill }) => 30 * fill, unit: 'px', absolute: 1e-12 },
      ({ state }) => waterHeight(state.fill),
    ),
    at(
      0,
      'Water in the tank for neutral weight',
      { exact: 0.5, absolute: 1e-12 },
      () => SUBMARINE.volume * SEA.density - emptyMass,
    ),
  ],
  tryThis: [
    'Flood the tank to the half, and wait until it hovers: it stays at any depth.',
    'Choose the full tank: it sinks, faster and faster, to 10 px/s.',
  ],
});

import {
  centreOfMass,
  cos,
  createPhysicsWorld,
  energy,
  type PhysicsWorld,
  replaceForce,
  rgba,
  semiImplicitEuler,
  sin,
  spawn,
  uniformGravity,
} from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import type { Point } from '../picture.ts';
import { held } from '../support/held.ts';
import { cosh, sinh, tanh } from '../support/hyperbolic.ts';
import { particleMass, type WaterOptions, water } from '../support/water.ts';

type Values = ValuesOf<'depth' | 'wave' | 'gravity' | 'viscosity'>;

/** The tank, and the distance of particles, m. */
const [LENGTH, HEIGHT, SPACING] = [1.2, 0.75, 0.03];

/** Wave number of the slowest standing wave. */
const K = Math.PI / LENGTH;

/** Speed of sound, m/s: the water is that stiff. */
const SOUND = 12;

/** Layers of particles that a wall is made of, which is as far as water sees. */
const LAYERS = 3;

/** How far from the pointer water is pushed, m. */
const HAND = 0.15;

/** 2π/√(g k tanh k d): Lamb, Hydrodynamics, section 228. */
function periodOf({ depth, gravity }: Pick<Values, 'depth' | 'gravity'>): number {
  return (2 * Math.PI) / Math.sqrt(gravity * K * tanh(K * depth));
}

interface WaterRun extends SceneRun {
  readonly drops: readonly number[];
  readonly values: Values;
  /** The middle of all water from the middle of the tank, m. */
  shift(): number;
}

/** The floor and two sides, of particles without mass. */
function addTank(world: PhysicsWorld): void {
  const [columns, rows] = [Math.round(LENGTH / SPACING), Math.round(HEIGHT / SPACING)];
  for (let i = -LAYERS; i < columns + LAYERS; i++) {
    for (let j = -LAYERS; j < rows; j++) {
      if (i >= 0 && i < columns && j >= 0) continue;
      const position = { x: (i + 0.5) * SPACING - LENGTH / 2, y: (j + 0.5) * SPACING };
      spawn(world, { position, collider: { radius: SPACING / 2 }, appearance: rgba(0.29, 0.33, 0.47) });
    }
  }
}

/** Fills the tank. The water flows as at the moment when a standing wave is flat, which changes no density. */
function addWater(world: PhysicsWorld, { depth, wave, gravity }: Values, mass: number): number[] {
  const drops: number[] = [];
  const frequency = (2 * Math.PI) / periodOf({ depth, gravity });
  for (let j = 0; (j + 0.5) * SPACING < depth; j++) {
    for (let i = 0; i < Math.round(LENGTH / SPACING); i++) {
      const [x, y] = [(i + 0.5) * SPACING, (j + 0.5) * SPACING];
      const speed = (wave * frequency) / sinh(K * depth);
      drops.push(
        spawn(world, {
          position: { x: x - LENGTH / 2, y },
          velocity: { x: speed * sin(K * x) * cosh(K * y), y: -speed * cos(K * x) * sinh(K * y) },
          mass,
          collider: { radius: SPACING / 2 },
          appearance: rgba(0.25, 0.55 + 0.15 * (j % 2), 1),
        }),
      );
    }
  }
  return drops;
}

function push({ world, drops }: WaterRun, at: Point, from: Point): void {
  const { Position, Velocity } = world.components;
  for (const id of drops) {
    const [dx, dy] = [Position.x[id] - at.x, Position.y[id] - at.y];
    if (dx * dx + dy * dy > HAND * HAND) continue;
    Velocity.x[id] += 0.2 * (4 * (at.x - from.x) - Velocity.x[id]);
    Velocity.y[id] += 0.2 * (4 * (at.y - from.y) - Velocity.y[id]);
  }
}

const lean = ({ world, values }: WaterRun, sideways: number) =>
  replaceForce(world, uniformGravity({ x: 0.3 * sideways * values.gravity, y: -values.gravity }));

export default defineExample({
  id: 'ch17-water',
  title: 'Water of particles',
  chapter: 17,
  tags: ['fluid', 'waves', 'neighbours', 'interactive'],
  about:
    'Each of these particles is a drop of water, which only looks at its neighbours. Where they are too close the pressure is higher, and drives them apart: that alone makes it a fluid, which is level at rest, and sloshes to and fro with the period that the theory of waves says. Lean the tank with ← and →, or stir the water with the pointer.',
  duration: 6,
  parameters: {
    depth: { label: 'Depth', unit: 'm', initial: 0.3, min: 0.1, max: 0.5 },
    wave: { label: 'Height of the wave', unit: 'm', initial: 0.04, min: 0, max: 0.15 },
    gravity: { label: 'Gravity', unit: 'm/s²', initial: 9.81, min: 1, max: 20 },
    viscosity: { label: 'Viscosity', initial: 0.03, min: 0.01, max: 0.5 },
  },
  presets: [
    { label: 'Shallow', values: { depth: 0.15, wave: 0.02 } },
    { label: 'A storm', values: { wave: 0.15 } },
    { label: 'Honey', values: { viscosity: 0.5 } },
  ],
  build(values: Values, { integrator = semiImplicitEuler }: BuildOptions): WaterRun {
    const options: WaterOptions = { spacing: SPACING, density: 1000, sound: SOUND, viscosity: values.viscosity };
    const forces = [uniformGravity({ y: -values.gravity }), water(options)];
    const world = createPhysicsWorld({ capacity: 2000, forces, integrator });
    addTank(world);
    const drops = addWater(world, values, particleMass(options));
    return { world, dt: 1 / 1000, drops, values, shift: () => centreOfMass(world).x };
  },
  actions: {
    left: held('←', 'arrowleft', 'lean the tank to the left', lean, -1),
    right: held('→', 'arrowright', 'lean the tank to the right', lean, 1),
  },
  pointer: { about: 'stir the water', move: push },
  picture: () => ({ view: { minX: -LENGTH / 2 - 0.1, maxX: LENGTH / 2 + 0.1, minY: -0.1, maxY: HEIGHT } }),
  plots: (plot) => [
    plot('Middle of the water', 'x, m', { label: 'x', value: ({ shift }) => shift() }),
    plot('Energy of motion', 'E, J', { label: 'kinetic', value: ({ world }) => energy(world).kinetic }),
  ],
  checks: ({ mean }) => [
    {
      label: 'Period of the wave, 2π/√(g k tanh k d)',
      unit: 's',
      exact: periodOf,
      // Ten layers of particles and more: shallow water is too coarse for this tolerance.
      holds: ({ depth }) => depth >= 10 * SPACING,
      tolerance: { relative: 0.03 },
      at: { event: ({ shift }) => shift() - 1e-6, from: 1, to: 3 },
      measure: ({ world }) => world.time / 2,
    },
    mean(
      6,
      'Mean height of the water, half of the depth',
      {
        exact: ({ depth }) => (SPACING * Math.round(depth / SPACING)) / 2,
        // Its weight presses it together by g d/c² at the floor.
        holds: ({ depth, gravity }) => gravity * depth < 0.03 * SOUND * SOUND,
        unit: 'm',
        relative: 0.03,
      },
      ({ world }) => centreOfMass(world).y,
    ),
  ],
  tryThis: [
    'Choose “Shallow”: the wave is slower, because it feels the floor.',
    'Choose “Honey”, and lean the tank: it is level again, without sloshing.',
    'Lean it to and fro at the right moments: how high can you drive the wave?',
  ],
});

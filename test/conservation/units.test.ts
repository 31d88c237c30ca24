/**
 * Nature does not know our units: where lengths, masses, times and charges are all measured in others, everything moves as
 * before. Units that are powers of four of the old ones change no digit, neither of a number nor of its root, so that a
 * constant with a unit that hides anywhere shows in the last bit.
 */
import {
  boxWalls,
  COMPONENTS,
  createEmitter,
  createPhysicsWorld,
  createRope,
  type Force,
  INTEGRATORS,
  type Law,
  linearDrag,
  mutualGravity,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  particleContacts,
  quadraticDrag,
  spawn,
  springs,
  step,
  uniformGravity,
  xpbd,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { LAW_CASES, type LawRecord, type LawWorld, lawWorld } from '../support/law-records.ts';
import { forceOn } from '../support/laws.ts';

const AXES = ['x', 'y', 'z'] as const;

/** Exponents of metre, kilogram, second and coulomb. */
const UNITS: Readonly<Record<string, readonly number[]>> = {
  '1': [0, 0, 0, 0],
  rad: [0, 0, 0, 0],
  m: [1, 0, 0, 0],
  kg: [0, 1, 0, 0],
  s: [0, 0, 1, 0],
  C: [0, 0, 0, 1],
  Hz: [0, 0, -1, 0],
  N: [1, 1, -2, 0],
  J: [2, 1, -2, 0],
  W: [2, 1, -3, 0],
  Pa: [-1, 1, -2, 0],
  V: [2, 1, -2, -1],
  T: [0, 1, -1, -1],
};

/** Our metre, kilogram, second and coulomb in the other units. */
const [METRE, KILOGRAM, SECOND, COULOMB] = [2 ** 4, 2 ** -6, 2 ** 2, 2 ** -2];
const SCALES = [METRE, KILOGRAM, SECOND, COULOMB];

/** How many of the other units one of ours is, such as `m³/(kg s²)`; with `n` for the n in `m⁻ⁿ`. */
function scaleOf(unit: string, n = 0): number {
  const [above, below = ''] = unit.split('/');
  const product = (names: string) =>
    names
      .replace(/[()]/g, '')
      .split(' ')
      .filter((name) => name !== '')
      .reduce((scale, name) => {
        const [, symbol, power] = /^(.*?)(²|³|⁻ⁿ|)$/.exec(name) as unknown as [string, string, string];
        const exponent = { '': 1, '²': 2, '³': 3, '⁻ⁿ': -n }[power] as number;
        return UNITS[symbol].reduce((value, e, i) => value * SCALES[i] ** (e * exponent), scale);
      }, 1);
  return product(above) / product(below);
}

/** Writes what the world's columns hold in the other units. */
function rescaleColumns(world: PhysicsWorld): void {
  for (const [name, { fields }] of Object.entries(COMPONENTS)) {
    const columns = world.components[name as keyof typeof world.components] as unknown as Record<string, Float64Array>;
    for (const [field, { kind, unit }] of Object.entries(fields)) {
      if (kind !== 'real' || unit === '') continue;
      const scale = scaleOf(unit);
      for (let id = 1; id <= world.lastId; id++) columns[field][id] *= scale;
    }
  }
}

/** The same force with its parameters in the other units. */
function rescaled(force: Force, exponent: number): Force {
  const { law, sources = [] } = force;
  const scaled = sources.map((source, i): typeof source => {
    const { unit, size } = (law as Law).parameters[i];
    const scale = scaleOf(unit, exponent);
    return {
      ...source,
      write(world, into, at, time) {
        source.write(world, into, at, time / SECOND);
        for (let k = 0; k < size; k++) into[at + k] *= scale;
      },
    };
  });
  return { ...force, sources: scaled };
}

const GRAVITATIONAL = 'm³/(kg s²)';

/** Units of the options of forces without a law, and of laws that keep some of theirs in tables. */
const OPTIONS: Readonly<Record<string, Readonly<Record<string, string>>>> = {
  mutualGravity: { G: GRAVITATIONAL, softening: 'm' },
  'mutualGravity, 1/r': { G: 'm²/(kg s²)' },
  postNewtonian: { G: GRAVITATIONAL, speedOfLight: 'm/s' },
  enclosedMassGravity: { radii: 'm', masses: 'kg', gravitationalConstant: GRAVITATIONAL },
  mutualCoulomb: { k: 'N m²/C²', softening: 'm' },
  springs: {},
  turbulentDrag: { mean: 'm/s', deviation: 'm/s', largest: 'm', smallest: 'm', time: 's' },
  polygonBuoyancy: { density: 'kg/m³', gravity: 'm/s²', level: 'm', vertices: 'm' },
  'enclosedGas in a ring': { amount: 'J', ambient: 'N/m', reference: 'm²' },
  'enclosedGas in a skin': { amount: 'J', ambient: 'Pa', reference: 'm³' },
  clothWind: { velocity: 'm/s', density: 'kg/m³' },
};

/** A number, or all in an object or an array, times a factor. */
function times(value: unknown, factor: number): unknown {
  if (typeof value === 'number') return value * factor;
  if (Array.isArray(value)) return value.map((each) => times(each, factor));
  return Object.fromEntries(Object.entries(value as object).map(([key, each]) => [key, times(each, factor)]));
}

/** A world under a law of which everything is in the other units. */
function otherWorld(record: LawRecord, dimensions: 2 | 3): LawWorld {
  const units = OPTIONS[record.title] ?? OPTIONS[record.maker];
  const [first] = record.args as readonly { exponent?: number }[];
  const args = record.args.map((options) =>
    Object.fromEntries(
      Object.entries(options as object).map(([name, value]) => {
        const unit = units?.[name];
        return [name, unit === undefined ? value : times(value, scaleOf(unit))];
      }),
    ),
  );
  const made =
    units === undefined
      ? lawWorld(record, dimensions, { wrap: (force) => rescaled(force, first?.exponent ?? 0) })
      : lawWorld({ ...record, args }, dimensions);
  rescaleColumns(made.world);
  return made;
}

/** Forces that a function of the user gives, and one that is held at a point, which no unit is known of. */
const OTHERS = ['accelerationField', 'forceField', 'pointerPull'];

describe('each law gives the same force in other units', () => {
  const cases = LAW_CASES.filter(({ record }) => !OTHERS.includes(record.maker));
  it.each(cases)('$name', ({ record, dimensions }) => {
    const [ours, other] = [lawWorld(record, dimensions), otherWorld(record, dimensions)];
    const [newton, newtonMetre] = [scaleOf('N'), scaleOf('N m')];
    for (const body of ours.moving) {
      const expected = forceOn(ours.world, body, 0.375, 2 ** -10);
      const { x, y, z, torque } = forceOn(other.world, body, 0.375 * SECOND, 2 ** -10 * SECOND);
      expect({ x: x / newton, y: y / newton, z: z / newton, torque: torque / newtonMetre }).toEqual(expected);
    }
  });
});

/** Our units in those in which a world is made. */
interface Units {
  readonly m: number;
  readonly kg: number;
  readonly s: number;
}

type Make = (units: Units, options: PhysicsWorldOptions) => PhysicsWorld;

const gravityOf = ({ m, s }: Units) => uniformGravity({ y: (-10 * m) / (s * s) });

/** Balls of several sizes that fall on each other in a box. */
const heap: Make = (units, options) => {
  const { m, kg, s } = units;
  const walls = [
    boxWalls({ min: { x: 0, y: 0, z: 0 }, max: { x: 10 * m, z: 10 * m }, restitution: 0.5, friction: 0.3 }),
  ];
  const world = createPhysicsWorld({ ...options, preset: particleContacts, forces: [gravityOf(units)], walls });
  for (let i = 0; i < 80; i++) {
    spawn(world, {
      position: { x: (0.7 + 1.2 * (i % 8)) * m, y: (0.7 + 1.2 * Math.floor(i / 8)) * m },
      velocity: { x: (((i * 7) % 5) * m) / s },
      mass: (0.5 + ((i * 3) % 7) / 7) * kg,
      rotation: 0,
      collider: { radius: (0.2 + ((i * 5) % 11) / 40) * m, restitution: 0.4, friction: 0.5 },
    });
  }
  return world;
};

/** An elastic chain that hangs by its end in air, with the scheme of `options`. */
const chain: Make = (units, options) => {
  const { m, kg, s } = units;
  const forces = [gravityOf(units), springs(), linearDrag(), quadraticDrag()];
  const world = createPhysicsWorld({ ...options, forces });
  const links = Array.from({ length: 12 }, (_, i) =>
    spawn(world, {
      position: { x: i * m },
      velocity: { y: (i * m) / s },
      linearDrag: (0.01 * kg) / s,
      quadraticDrag: (0.001 * kg) / m,
      ...(i === 0 ? {} : { mass: kg }),
    }),
  );
  const spring = { stiffness: (200 * kg) / (s * s), damping: kg / s, length: m };
  for (let i = 1; i < links.length; i++) spawn(world, { spring: { a: links[i - 1], b: links[i], ...spring } });
  return world;
};

/** A rope between two pins, inextensible. */
const rope: Make = (units, options) => {
  const { m, kg } = units;
  const forces = [gravityOf(units), springs()];
  const world = createPhysicsWorld({ ...options, forces, integrator: xpbd({ substeps: 4, iterations: 4 }) });
  createRope(world, { from: {}, to: { x: 10 * m }, nodes: 24, mass: kg, length: 12 * m, pins: 'both' });
  return world;
};

/** A cluster of stars, by the tree. */
const stars: Make = ({ m, kg, s }, options) => {
  const G = (m * m * m) / (kg * s * s);
  const world = createPhysicsWorld({ ...options, forces: [mutualGravity({ G, softening: 0.05 * m, method: 'tree' })] });
  for (let i = 0; i < 200; i++) {
    const [x, y, z] = [7, 11, 13].map((prime) => ((i * prime) % 17) + i / 40 - 10);
    const position = world.dimensions === 2 ? { x: x * m, y: y * m } : { x: x * m, y: y * m, z: z * m };
    spawn(world, { position, velocity: {}, mass: 0.05 * kg });
  }
  return world;
};

/** Sparks of an emitter, in air. */
const sparks: Make = (units, options) => {
  const { m, kg, s } = units;
  const world = createPhysicsWorld({ ...options, forces: [gravityOf(units), linearDrag()] });
  createEmitter(world, {
    capacity: 200,
    rate: 60 / s,
    lifetime: 2 * s,
    speed: (5 * m) / s,
    direction: { y: 1 },
    spread: 1,
    mass: kg,
    linearDrag: (0.2 * kg) / s,
  });
  return world;
};

interface Case {
  readonly name: string;
  readonly make: Make;
  readonly options?: PhysicsWorldOptions;
  /** The world has a time of its own: overlaps are pushed out by some radii a second. */
  readonly hasTime?: boolean;
}

const CASES: readonly Case[] = [
  { name: 'balls', make: heap, hasTime: true },
  { name: 'balls in space', make: heap, options: { precision: 'f32', dimensions: 3 }, hasTime: true },
  { name: 'a rope', make: rope },
  { name: 'a rope in f32', make: rope, options: { precision: 'f32' } },
  { name: 'stars', make: stars },
  { name: 'stars in space', make: stars, options: { precision: 'f32', dimensions: 3 } },
  { name: 'sparks', make: sparks, options: { precision: 'f32' } },
  ...Object.entries(INTEGRATORS)
    // It has a central mass and its gravity.
    .filter(([name]) => name !== 'wisdomHolman')
    .map(([name, { create }]) => ({ name: `a chain by ${name}`, make: chain, options: { integrator: create() } })),
];

describe('worlds move the same in other units', () => {
  /** Coordinates and velocities after 60 steps of 1/64 s, in metres and seconds. */
  function motion(make: Make, units: Units, options: PhysicsWorldOptions): number[] {
    const world = make(units, { capacity: 300, ...options });
    for (let i = 0; i < 60; i++) step(world, units.s / 64);
    const { Position, Velocity } = world.components;
    const ids = Array.from({ length: world.lastId }, (_, i) => i + 1);
    return ids.flatMap((id) =>
      AXES.flatMap((axis) => [Position[axis][id] / units.m, (Velocity[axis][id] * units.s) / units.m]),
    );
  }

  it.each(CASES)('$name', ({ make, options = {}, hasTime = false }) => {
    const ours = motion(make, { m: 1, kg: 1, s: 1 }, options);
    const other = { m: METRE, kg: KILOGRAM, s: hasTime ? 1 : SECOND };
    expect(motion(make, other, options)).toEqual(ours);
    expect(ours.some((value) => Math.abs(value) > 1)).toBe(true);
  });
});

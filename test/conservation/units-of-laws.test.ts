/**
 * Each law gives the same force in other units: so what it states about those of its parameters and columns is right, and it
 * has no hidden constant.
 */
import { COMPONENTS, type Force, type Law, type PhysicsWorld } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { LAW_CASES, type LawRecord, type LawWorld, lawWorld } from '../support/law-records.ts';
import { forceOn } from '../support/laws.ts';
import { COULOMB, KILOGRAM, METRE, SECOND } from '../support/other-units.ts';

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
  // Of the gas in a ring a depth of one metre is meant.
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
  const made =
    units === undefined
      ? lawWorld(record, dimensions, { wrap: (force) => rescaled(force, first?.exponent ?? 0) })
      : lawWorld({ ...record, args: record.args.map((options) => optionsIn(units, options)) }, dimensions);
  rescaleColumns(made.world);
  return made;
}

/** Options of these units in the other ones. */
function optionsIn(units: Readonly<Record<string, string>>, options: unknown): object {
  const scaled = Object.entries(options as object).map(([name, value]) => [
    name,
    name in units ? times(value, scaleOf(units[name])) : value,
  ]);
  return Object.fromEntries(scaled);
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

/** The quantities of a world that can be plotted. */
import {
  angularMomentum,
  bodies,
  COMPONENT_NAMES,
  COMPONENTS,
  type ComponentName,
  energy,
  momentum,
  type PhysicsWorld,
} from '@principia/physics';
import { words } from './words.ts';

/** Units of a world that is not in SI, by the SI units that they stand for: `{ m: 'km', 'm/s': 'km/s' }`. */
export type OwnUnits = Readonly<Record<string, string>>;

/** A plot of the same values under the units of the world. */
export function inUnits(source: PlotSource, units: OwnUnits): PlotSource {
  return { ...source, unit: units[source.unit] ?? source.unit };
}

/** Quantities that share a plot. */
export interface PlotSource {
  readonly unit: string;
  /** Label of each line. */
  readonly series: readonly string[];
  /** Writes the present values to `out`. */
  read(world: PhysicsWorld, out: Float64Array): void;
}

/** Quantities of a game's own by their names in the address. */
export type OwnQuantities = Readonly<
  Record<string, { readonly label: string; readonly unit: string; readonly value: () => number }>
>;

const axes = (dimensions: 2 | 3) => (dimensions === 2 ? ['x', 'y'] : ['x', 'y', 'z']);

/** Reused for each sample. */
const energies = { kinetic: 0, potential: 0, total: 0 };

export const energySource: PlotSource = {
  unit: 'J',
  series: ['kinetic', 'potential', 'total'],
  read(world, out) {
    energy(world, energies);
    out[0] = energies.kinetic;
    out[1] = energies.potential;
    out[2] = energies.total;
  },
};

export function momentumSource(dimensions: 2 | 3): PlotSource {
  return {
    unit: 'kg m/s',
    series: axes(dimensions),
    read(world, out) {
      const { x, y, z } = momentum(world);
      out[0] = x;
      out[1] = y;
      if (dimensions === 3) out[2] = z;
    },
  };
}

/** Total angular momentum about the origin; in 2D it has one component. */
export function angularMomentumSource(dimensions: 2 | 3): PlotSource {
  return {
    unit: 'kg m²/s',
    series: dimensions === 2 ? ['z'] : axes(3),
    read(world, out) {
      const { x, y, z } = angularMomentum(world);
      out[0] = dimensions === 2 ? z : x;
      if (dimensions === 2) return;
      out[1] = y;
      out[2] = z;
    },
  };
}

/** A game's own quantity; its one line has no name, as the plot is called by it. */
function ownSource({ unit, value }: OwnQuantities[string]): PlotSource {
  return {
    unit,
    series: [''],
    read(_world, out) {
      out[0] = value();
    },
  };
}

/** Quantities of the whole world that a plot can have along its horizontal axis; columns come after them. */
export function totalsOf(dimensions: 2 | 3): string[] {
  return TOTALS.flatMap((plot) => sourceOf(plot, 0, dimensions).series.map((name) => `${plot}.${name}`));
}

export const TOTALS = ['Energy', 'Momentum', 'Angular momentum'] as const;

/**
 * One quantity: a component of a total such as `Energy.kinetic`, or a column such as `Position.x`, of all bodies the mean;
 * or a quantity of the game's own.
 * @param body number of the body that a column is of; 0 for all
 */
export function quantitySource(name: string, body: number, dimensions: 2 | 3, own: OwnQuantities = {}): PlotSource {
  const [plot, part] = name.split('.');
  const source = sourceOf(name, body, dimensions, own);
  const isTotal = (TOTALS as readonly string[]).includes(plot);
  const index = isTotal ? source.series.indexOf(part) : source.series.length >> 1;
  const values = new Float64Array(source.series.length);
  return {
    unit: source.unit,
    series: [own[name]?.label ?? name],
    read(world, out) {
      source.read(world, values);
      out[0] = values[index];
    },
  };
}

/**
 * What a choice of the reader's plots: a total of the world or one of its components, a column such as `Position.y`, or a
 * quantity of the game's own.
 */
export function sourceOf(name: string, body: number, dimensions: 2 | 3, own: OwnQuantities = {}): PlotSource {
  if (Object.hasOwn(own, name)) return ownSource(own[name]);
  const [first, field] = name.split('.');
  if (first === 'Energy') return energySource;
  if (first === 'Momentum') return momentumSource(dimensions);
  if (first === 'Angular momentum') return angularMomentumSource(dimensions);
  return columnSource({ component: first as ComponentName, field }, body);
}

/** Pairs of columns, vertical and horizontal, and the body whose motion they show. */
export interface PathChoice {
  readonly y: string;
  readonly x: string;
  readonly body: number;
}

/**
 * The path of the first body that moves; of a body that only turns there is none.
 * @param body number of a body to prefer, or 0
 */
export function pathChoice(world: PhysicsWorld, body: number): PathChoice {
  const isMoving = (id: number) => speedAlong(world, id, 'x') !== 0 || speedAlong(world, id, 'y') !== 0;
  return { y: 'Position.y', x: 'Position.x', body: body || firstBody(world, isMoving) };
}

/** Velocity against position along the axis on which the body is faster, or angular velocity against angle. */
export function phaseChoice(world: PhysicsWorld, body: number): PathChoice {
  const isMoving = (id: number) => speedAlong(world, id, 'x') !== 0 || speedAlong(world, id, 'y') !== 0;
  const number = body || firstBody(world, (id) => isMoving(id) || isTurning(world, id));
  const id = bodies(world).ids[number - 1];
  if (id !== undefined && !isMoving(id) && isTurning(world, id)) {
    return { y: 'AngularVelocity.z', x: 'Rotation.angle', body: number };
  }
  const axis = id !== undefined && speedAlong(world, id, 'y') > speedAlong(world, id, 'x') ? 'y' : 'x';
  return { y: `Velocity.${axis}`, x: `Position.${axis}`, body: number };
}

const speedAlong = ({ components: { Velocity } }: PhysicsWorld, id: number, axis: 'x' | 'y') =>
  Math.abs(Velocity[axis][id]);

const isTurning = ({ components: { AngularVelocity } }: PhysicsWorld, id: number) => AngularVelocity.z[id] !== 0;

/** Number of the first body with a property, or 1. */
function firstBody(world: PhysicsWorld, has: (id: number) => boolean): number {
  const { ids, count } = bodies(world);
  for (let i = 0; i < count; i++) if (has(ids[i])) return i + 1;
  return 1;
}

/** A field of a component. */
export interface ColumnName {
  readonly component: ComponentName;
  readonly field: string;
}

/** The columns that have non-zero values, as `Position.y`. */
export function columnsInUse(world: PhysicsWorld): ColumnName[] {
  const list = bodies(world);
  return COMPONENT_NAMES.flatMap((component) =>
    Object.keys(COMPONENTS[component].fields)
      .filter((field) => !(world.dimensions === 2 && component !== 'AngularVelocity' && field === 'z'))
      .filter((field) => isInUse(world, list.ids, list.count, { component, field }))
      .map((field) => ({ component, field })),
  );
}

function isInUse(world: PhysicsWorld, ids: Uint32Array, count: number, name: ColumnName): boolean {
  const column = columnOf(world, name);
  for (let i = 0; i < count; i++) if (column[ids[i]] !== 0) return true;
  return false;
}

function columnOf(world: PhysicsWorld, { component, field }: ColumnName): ArrayLike<number> {
  return (world.components[component] as unknown as Record<string, ArrayLike<number>>)[field];
}

/**
 * A column of the `body`-th body in ascending order of ids from 1; for body 0, the minimum, mean and maximum of all
 * bodies.
 */
export function columnSource(name: ColumnName, body: number): PlotSource {
  const fields = COMPONENTS[name.component].fields as Readonly<Record<string, { readonly unit: string }>>;
  const { unit } = fields[name.field];
  return {
    unit,
    series: body > 0 ? [words().bodyNumber(body)] : ['minimum', 'mean', 'maximum'],
    read(world, out) {
      const { ids, count } = bodies(world);
      const column = columnOf(world, name);
      if (body > 0) out[0] = body <= count ? column[ids[body - 1]] : Number.NaN;
      else readAll(column, ids, count, out);
    },
  };
}

function readAll(column: ArrayLike<number>, ids: Uint32Array, count: number, out: Float64Array): void {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const value = column[ids[i]];
    if (value < low) low = value;
    if (value > high) high = value;
    sum += value;
  }
  out[0] = count === 0 ? Number.NaN : low;
  out[1] = sum / count;
  out[2] = count === 0 ? Number.NaN : high;
}

// A cloth: a grid of nodes with structural springs along rows and columns, and optionally shear springs along the
// diagonals and bending springs between second neighbours.

import { ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { belongsTo } from '../ecs/id-lists.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import {
  checkFlag,
  checkKeys,
  checkNumber,
  checkVector,
  checkWhole,
  type Vector,
  type VectorInput,
} from '../errors/validate.ts';
import { unit } from '../forces/support/unit-vector.ts';
import type { PhysicsWorld } from '../world/types.ts';
import {
  COUNT_BOUNDS,
  checkStiffness,
  type Network,
  SPRING_OPTIONS,
  SpringList,
  type SpringOptions,
  spawnNetwork,
} from './network.ts';
import { markWoven } from './woven.ts';

/** Options of `createCloth`. */
export interface ClothOptions extends SpringOptions {
  /** Position of the node of column 0 and row 0, m. */
  readonly corner: VectorInput;
  readonly columns: number;
  readonly rows: number;
  /** Distance between neighbours in a row or column, m. */
  readonly spacing: number;
  /** Mass of the whole cloth, kg, divided equally among its nodes. */
  readonly mass: number;
  /** Direction along a row; any length but 0; default +x. */
  readonly right?: VectorInput;
  /** Direction down a column; default -y. A cloth whose directions are not perpendicular is at rest when skewed so. */
  readonly down?: VectorInput;
  /** Stiffness of the springs along rows and columns, N/m; default Infinity, which needs the integrator `xpbd`. */
  readonly structural?: number;
  /** Stiffness of the diagonal springs, N/m; default 0: none. */
  readonly shear?: number;
  /** Stiffness of the springs between second neighbours, N/m; default 0: none. */
  readonly bend?: number;
  /**
   * Adds an inextensible tension-only spring from every node to the nearest pinned node, to unload the structural
   * springs; default false.
   */
  readonly tethers?: boolean;
  /** The nodes to pin: the first row, its two corners, none, or pairs [column, row]; default 'top'. */
  readonly pins?: 'none' | 'top' | 'corners' | readonly (readonly [number, number])[];
}

/** A cloth: its nodes, springs and triangles. */
export interface Cloth extends Network {
  readonly columns: number;
  readonly rows: number;
  /** Returns the node at a position of the grid. @throws PhysicsError E_TYPE, E_RANGE */
  at(column: number, row: number): number;
  /** Entity ids of the corners of its triangles, three each, as `clothWind` takes them. */
  readonly triangles: Uint32Array;
}

const OPTION_NAMES = [
  'corner',
  'columns',
  'rows',
  'spacing',
  'mass',
  'right',
  'down',
  'structural',
  'shear',
  'bend',
  'tethers',
  'pins',
  ...SPRING_OPTIONS,
];

/**
 * Creates a cloth, flat and at rest. Its nodes are numbered row by row.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_REENTRANT (during a step), E_DESTROYED
 */
export function createCloth(world: PhysicsWorld, options: ClothOptions): Cloth {
  assertUsable(world);
  checkKeys(options, 'createCloth', OPTION_NAMES);
  const columns = checkNumber(options.columns, 'cloth.columns', COUNT_BOUNDS);
  const rows = checkNumber(options.rows, 'cloth.rows', COUNT_BOUNDS);
  // All is counted first, because the lists of a cloth that is too large would fill the heap.
  ensureCapacity(world, columns * rows + springCount(options, columns, rows));
  const list = new SpringList();
  if (checkFlag(options.tethers, 'cloth.tethers')) addTethers(list, options, columns, rows);
  addBraces(list, options, columns, rows);
  // Structural springs come last, because the constraints solved last have the smallest error.
  addPolylines(list, options, columns, rows);
  const bodies = placeNodes(options, columns, rows);
  const { nodes, springs } = spawnNetwork(world, columns * rows, bodies, list, options);
  const at = (column: number, row: number) => nodes[placeOf('cloth.at', column, row, columns, rows)];
  const triangles = belongsTo(world, trianglesOf(nodes, columns, rows));
  if ((options.structural ?? Infinity) > 0) markWoven(triangles, columns - 1);
  return { nodes, springs, columns, rows, at, triangles };
}

/** The number of springs but the tethers, of which a node has one at most. */
function springCount({ shear = 0, bend = 0, structural = Infinity }: ClothOptions, columns: number, rows: number) {
  const straight = structural > 0 ? columns * (rows - 1) + rows * (columns - 1) : 0;
  const diagonal = shear > 0 ? 2 * (columns - 1) * (rows - 1) : 0;
  const second = bend > 0 ? columns * (rows - 2) + rows * (columns - 2) : 0;
  return straight + diagonal + second;
}

function placeNodes(options: ClothOptions, columns: number, rows: number) {
  const corner = checkVector(options.corner, 'cloth.corner');
  const { right, down } = directionsOf(options);
  const spacing = checkNumber(options.spacing, 'cloth.spacing', { above: 0 });
  const count = columns * rows;
  const mass = checkNumber(options.mass, 'cloth.mass', { above: 0 }) / count;
  const coordinates = (axis: keyof Vector) =>
    Float64Array.from({ length: count }, (_, i) => {
      const [column, row] = [i % columns, Math.floor(i / columns)];
      return corner[axis] + spacing * (right[axis] * column + down[axis] * row);
    });
  const masses = new Float64Array(count).fill(mass);
  for (const node of pinnedNodes(options.pins ?? 'top', columns, rows)) masses[node] = Infinity;
  const position = { x: coordinates('x'), y: coordinates('y'), z: coordinates('z') };
  return { position, mass: masses };
}

/** Of the angle between rows and columns. */
const MAX_COSINE = 0.99;

function directionsOf(options: ClothOptions) {
  const right = unit(checkVector(options.right ?? { x: 1 }, 'cloth.right'), 'cloth.right');
  const down = unit(checkVector(options.down ?? { y: -1 }, 'cloth.down'), 'cloth.down');
  const cosine = right.x * down.x + right.y * down.y + right.z * down.z;
  if (Math.abs(cosine) <= MAX_COSINE) return { right, down, cosine };
  throw new PhysicsError('E_RANGE', 'cloth.down must not be parallel to cloth.right.', {
    field: 'cloth.down',
    value: down,
    hint: 'Give both directions: down is -y unless it is given.',
  });
}

function pinnedNodes(pins: NonNullable<ClothOptions['pins']>, columns: number, rows: number): number[] {
  if (pins === 'none') return [];
  if (pins === 'top') return Array.from({ length: columns }, (_, column) => column);
  if (pins === 'corners') return [0, columns - 1];
  if (!Array.isArray(pins) || !pins.every((pair) => Array.isArray(pair))) {
    throw new PhysicsError(
      'E_TYPE',
      "cloth.pins must be 'none', 'top', 'corners' or an array of pairs [column, row].",
      {
        field: 'cloth.pins',
        value: pins,
      },
    );
  }
  return pins.map(([column, row]) => placeOf('cloth.pins', column, row, columns, rows));
}

/** Returns the number of a node. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE */
function placeOf(field: string, column: number, row: number, columns: number, rows: number): number {
  return (
    checkWhole(row, `${field}: row`, 0, rows - 1) * columns + checkWhole(column, `${field}: column`, 0, columns - 1)
  );
}

/** Adds springs in sequence, so that the solver recognizes a polyline. */
function addPolyline(
  list: SpringList,
  [first, stride, nodes]: readonly [number, number, number],
  stiffness: number,
  length: number,
): void {
  for (let i = 1; i < nodes; i++) list.add(first + stride * (i - 1), first + stride * i, stiffness, length);
}

function addPolylines(list: SpringList, options: ClothOptions, columns: number, rows: number): void {
  const stiffness = checkStiffness(options.structural ?? Infinity, 'cloth.structural');
  if (stiffness === 0) return;
  for (let column = 0; column < columns; column++) {
    addPolyline(list, [column, columns, rows], stiffness, options.spacing);
  }
  for (let row = 0; row < rows; row++) addPolyline(list, [row * columns, 1, columns], stiffness, options.spacing);
}

/**
 * Adds shear and bending springs, row by row, so that their nodes are in the cache while they are solved. Springs
 * along a row come in two interleaved sets, since neighbours in a set share no node and the solver need not wait for
 * the previous result.
 */
function addBraces(list: SpringList, options: ClothOptions, columns: number, rows: number): void {
  const shear = checkStiffness(options.shear ?? 0, 'cloth.shear');
  const bend = checkStiffness(options.bend ?? 0, 'cloth.bend');
  const { cosine } = directionsOf(options);
  const [diagonal, other] = [diagonalOf(cosine) * options.spacing, diagonalOf(-cosine) * options.spacing];
  const straight = 2 * options.spacing;
  const add = (column: number, row: number, right: number, down: number, stiffness: number, length: number) => {
    const [toColumn, toRow] = [column + right, row + down];
    if (stiffness === 0 || toColumn < 0 || toColumn >= columns || toRow >= rows) return;
    list.add(row * columns + column, toRow * columns + toColumn, stiffness, length);
  };
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) add(column, row, 1, 1, shear, diagonal);
    for (let column = 0; column < columns; column++) add(column, row, -1, 1, shear, other);
    for (let column = 0; column < columns; column++) if (column % 4 < 2) add(column, row, 2, 0, bend, straight);
    for (let column = 0; column < columns; column++) if (column % 4 > 1) add(column, row, 2, 0, bend, straight);
    for (let column = 0; column < columns; column++) add(column, row, 0, 2, bend, straight);
  }
}

/** The length of the diagonal of a rhombus with sides of 1 that are at an angle with this cosine. */
function diagonalOf(cosine: number): number {
  return cosine === 0 ? Math.SQRT2 : Math.sqrt(2 + 2 * cosine);
}

/**
 * Adds tethers as long as the path to the nearest pinned node along rows and columns: shear can straighten that path
 * (Kim, Chentanez, Müller: Long Range Attachments, SCA 2012). With shear springs the straight distance counts.
 */
function addTethers(list: SpringList, options: ClothOptions, columns: number, rows: number): void {
  const pins = pinnedNodes(options.pins ?? 'top', columns, rows);
  const pinned = new Set(pins);
  const canShear = (options.shear ?? 0) === 0;
  for (let node = 0; node < columns * rows; node++) {
    let nearest = -1;
    let minDistance = Infinity;
    for (const pin of pins) {
      const across = Math.abs((node % columns) - (pin % columns));
      const down = Math.abs(Math.floor(node / columns) - Math.floor(pin / columns));
      const distance = canShear ? across + down : Math.sqrt(across * across + down * down);
      if (distance >= minDistance) continue;
      minDistance = distance;
      nearest = pin;
    }
    if (nearest >= 0 && !pinned.has(node)) list.add(nearest, node, Infinity, minDistance * options.spacing, 1);
  }
}

/**
 * Lists the triangles row by row, first those with an edge above, then those with an edge below, so that corners
 * have consecutive ids.
 */
function trianglesOf(nodes: Uint32Array, columns: number, rows: number): Uint32Array {
  const at = (column: number, row: number) => nodes[row * columns + column];
  const triangles: number[] = [];
  for (let row = 0; row + 1 < rows; row++) {
    for (let c = 0; c + 1 < columns; c++) triangles.push(at(c, row), at(c, row + 1), at(c + 1, row));
    for (let c = 0; c + 1 < columns; c++) triangles.push(at(c + 1, row), at(c, row + 1), at(c + 1, row + 1));
  }
  return Uint32Array.from(triangles);
}

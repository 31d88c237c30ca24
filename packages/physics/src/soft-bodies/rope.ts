// A rope: nodes in a line, with a spring from each to the next.
//
// A rope of N links of stiffness k stretches like a single spring of stiffness k/N. Under `xpbd` it is a chain and
// solved directly: an inextensible rope (stiffness Infinity) of thousands of links keeps its length to rounding in a
// few sub-steps. `tethers` are tension-only springs over 2, 4, 8… links, and from every node to each pinned end (Kim,
// Chentanez, Müller: Long Range Attachments, SCA 2012). A rope of fixed length satisfies all of them, so they carry the
// load of its own nodes without changing its motion; but the rope is no longer a chain. What hangs on it is held better
// by a rope whose springs, and the spring to the load after them, are one sequence (xpbd.ts).

import { ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { checkChoice, checkFlag, checkKeys, checkNumber, checkPoint, type VectorInput } from '../errors/validate.ts';
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

/** Options of `createRope`. */
export interface RopeOptions extends SpringOptions {
  /** Positions of the first and last node, m. */
  readonly from: VectorInput;
  readonly to: VectorInput;
  /** Number of nodes, both ends included. */
  readonly nodes: number;
  /** Mass of the whole rope, kg, divided equally among its nodes. */
  readonly mass: number;
  /** Natural length of the whole rope, m; default the distance of its ends. */
  readonly length?: number;
  /** Stiffness of a link, N/m; default Infinity, which needs the integrator `xpbd`. */
  readonly stiffness?: number;
  /** Links pull and never push; default false. */
  readonly tensionOnly?: boolean;
  /**
   * Adds inextensible tension-only springs, about log2(nodes) per node, which help a rope that is no chain a little to
   * bear its own weight, but not what hangs on it; default false.
   */
  readonly tethers?: boolean;
  /** The ends to pin; default 'start'. */
  readonly pins?: 'none' | 'start' | 'end' | 'both';
}

const OPTIONS = [
  'from',
  'to',
  'nodes',
  'mass',
  'length',
  'stiffness',
  'tensionOnly',
  'tethers',
  'pins',
  ...SPRING_OPTIONS,
];

/**
 * Creates a rope, straight from one end to the other, at rest.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_REENTRANT (during a step), E_DESTROYED
 */
export function createRope(world: PhysicsWorld, options: RopeOptions): Network {
  assertUsable(world);
  checkKeys(options, 'createRope', OPTIONS);
  const from = checkPoint(options.from, 'rope.from');
  const to = checkPoint(options.to, 'rope.to');
  const count = checkNumber(options.nodes, 'rope.nodes', COUNT_BOUNDS);
  ensureCapacity(world, 2 * count - 1);
  const mass = checkNumber(options.mass, 'rope.mass', { above: 0 }) / count;
  const [dx, dy, dz] = [to.x - from.x, to.y - from.y, to.z - from.z];
  const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
  const length = checkNumber(options.length ?? distance, 'rope.length', { min: 0, max: 1e12 }) / (count - 1);
  const stiffness = checkStiffness(options.stiffness ?? Infinity, 'rope.stiffness');
  const pins = checkChoice(options.pins ?? 'start', 'rope.pins', ['none', 'start', 'end', 'both']);
  const tensionOnly = checkFlag(options.tensionOnly, 'rope.tensionOnly');
  const coordinates = (start: number, extent: number) =>
    Float64Array.from({ length: count }, (_, i) => start + (extent * i) / (count - 1));
  const isPinned = (i: number) =>
    (i === 0 && (pins === 'start' || pins === 'both')) || (i === count - 1 && (pins === 'end' || pins === 'both'));
  const list = new SpringList();
  for (let i = 1; i < count; i++) list.add(i - 1, i, stiffness, length, tensionOnly ? 1 : 0);
  if (checkFlag(options.tethers, 'rope.tethers')) addTethers(list, isPinned, count, length);
  const position = { x: coordinates(from.x, dx), y: coordinates(from.y, dy), z: coordinates(from.z, dz) };
  const masses = Float64Array.from({ length: count }, (_, i) => (isPinned(i) ? Infinity : mass));
  return spawnNetwork(world, count, { position, mass: masses }, list, options);
}

function addTethers(list: SpringList, isPinned: (node: number) => boolean, count: number, link: number): void {
  const add = (a: number, b: number) => list.add(a, b, Infinity, Math.abs(b - a) * link, 1);
  for (const end of [0, count - 1]) {
    if (!isPinned(end)) continue;
    for (let i = 0; i < count; i++) if (Math.abs(i - end) > 1 && !isPinned(i)) add(end, i);
  }
  // Springs are solved in this order, and short tethers must come first: with long tethers first a rope converges a
  // hundred times slower.
  for (let links = 2; links < count; links *= 2) {
    for (let i = 0; i + links < count; i++) add(i, i + links);
  }
}

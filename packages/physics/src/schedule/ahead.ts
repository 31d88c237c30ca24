// What the next tile's rows are, so that a kernel that waits for divisions fetches them meanwhile (kernels/ahead.ts).
import { COMPONENTS, type ComponentName } from '../components/all';
import { AXES } from '../store/axes';
import { realAddresses, realBytes } from '../store/columns';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';

/** Where the table stands in the world's memory: bytes to the next tile, number of columns, their addresses. */
const TABLE_ADDRESS = 256;

/** Most columns read ahead; more would no longer fit beside the divisions. */
const MAX_COLUMNS = 24;

const WORDS = 2;

/** The table of a world. */
export type Ahead = Uint32Array;

/** Fills the table with the columns that a tile of this world reads: moves, what its forces read, radii at walls. */
export function aheadOf(world: PhysicsWorld): Ahead {
  const { addresses, previousAddresses, forces, phases, memory } = world;
  const columns = new Set<number>();
  for (const axis of AXES[world.dimensions]) {
    columns.add(addresses.Position[axis]).add(addresses.Velocity[axis]).add(previousAddresses.Position[axis]);
  }
  columns.add(addresses.Mass.value);
  if (phases.walls.length > 0) columns.add(addresses.Collider.radius);
  for (const { reads } of forces) {
    if (!Array.isArray(reads)) continue;
    for (const name of reads.filter(isComponent)) for (const start of realAddresses(world, name)) columns.add(start);
  }
  const list = [...columns].slice(0, MAX_COLUMNS);
  const table = new Uint32Array(memory.buffer, TABLE_ADDRESS, WORDS + list.length);
  table.set(list, WORDS);
  return table;
}

/** Whether it is one, and not place or velocity, whose axes are there already. */
function isComponent(name: unknown): name is ComponentName {
  return name !== 'Position' && name !== 'Velocity' && Object.hasOwn(COMPONENTS, name as string);
}

/** Tells kernels where the tile after rows [first, last) of run `r` is, if it is as long as this one. */
export function lookAhead(world: PhysicsWorld, ahead: Ahead, { bounds, count }: Spans, r: number): void {
  const { tile } = world.internal;
  const first = tile.bounds[0];
  const last = tile.bounds[1];
  const follows = last < bounds[2 * r + 1] || r + 1 >= count;
  const next = follows ? last : bounds[2 * r + 2];
  const end = bounds[follows ? 2 * r + 1 : 2 * r + 3];
  ahead[0] = (next - first) * realBytes(world.precision);
  ahead[1] = end - next < last - first ? 0 : ahead.length - WORDS;
}

/** Nothing lies ahead. */
export function lookNowhere(ahead: Ahead): void {
  ahead[1] = 0;
}

// The boxes by which the broad phase of rigid bodies finds pairs, and the islands in which bodies sleep, as lists, for pictures and logs.
import { rigidKernels } from '../collision/kernels.ts';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { rigidTable } from '../solver/rigid-table.ts';
import { ASLEEP, COLLIDES } from '../solver/row-flags.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { checkLists } from './check-lists.ts';

/** The boxes of all shapes that collide; entry i of each list is valid for i < `count`. */
export interface BodyBoxes {
  count: number;
  /** Entity ids of bodies, parts of compound bodies and walls, ascending. */
  readonly body: number[];
  /** The box, m: that of the shape and a margin, so that it stays while the body moves a little. */
  readonly minX: number[];
  readonly minY: number[];
  readonly maxX: number[];
  readonly maxY: number[];
  /** Whether the body sleeps. */
  readonly asleep: boolean[];
  /** The smallest id among the bodies of its island, which touch or are joined; 0 for what no contact moves. */
  readonly island: number[];
}

/**
 * Lists the boxes of a world with the preset `rigidBodies`, as the last step left them.
 * @param into a list of an earlier call, which is written anew and returned: then nothing is allocated
 * @throws PhysicsError E_TYPE, E_CAPACITY, E_DESTROYED
 */
export function bodyBoxes(world: PhysicsWorld, into: BodyBoxes = emptyList()): BodyBoxes {
  const { at, words } = rigidTable(world);
  const kernels = rigidKernels(world);
  checkLists(
    into,
    [into?.body, into?.minX, into?.minY, into?.maxX, into?.maxY, into?.asleep, into?.island],
    'bodyBoxes',
  );
  const { buffer } = world.memory;
  const rows = words[Word.rows];
  const Reals = world.precision === 'f32' ? Float32Array : Float64Array;
  const boxes = new Reals(buffer, words[Word.boxes], 4 * rows);
  const flags = new Uint32Array(buffer, words[Word.flags], rows);
  kernels.labelIslands(at);
  let count = 0;
  for (let row = 1; row < rows; row++) {
    if ((flags[row] & COLLIDES) === 0) continue;
    into.body[count] = row;
    into.minX[count] = boxes[4 * row];
    into.minY[count] = boxes[4 * row + 1];
    into.maxX[count] = boxes[4 * row + 2];
    into.maxY[count] = boxes[4 * row + 3];
    into.asleep[count] = (flags[row] & ASLEEP) !== 0;
    into.island[count] = kernels.islandAt(at, row);
    count++;
  }
  into.count = count;
  return into;
}

function emptyList(): BodyBoxes {
  return { count: 0, body: [], minX: [], minY: [], maxX: [], maxY: [], asleep: [], island: [] };
}

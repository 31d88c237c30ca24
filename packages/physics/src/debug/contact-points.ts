// The contact points of rigid bodies as lists, for pictures and logs: copying them costs some 50 ns each.

import { rigidKernels } from '../collision/kernels.ts';
import { assertUsable } from '../ecs/guards.ts';
import { allocate } from '../memory/arena.ts';
import { realBytes } from '../memory/columns.ts';
import { CONTACT_VIEW_BYTES } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import { rigidTable } from '../solver/rigid-table.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { checkLists } from './check-lists.ts';

/** Points at which rigid bodies touch or nearly touch; entry i of each list is valid for i < `count`. */
export interface ContactPoints {
  count: number;
  /** Entity ids, a < b. */
  readonly a: number[];
  readonly b: number[];
  /** Point, m, where the bodies are now. */
  readonly x: number[];
  readonly y: number[];
  /** Unit normal from a to b. */
  readonly nx: number[];
  readonly ny: number[];
  /** Distance of the surfaces when the last step began, m; negative where they overlapped. */
  readonly separation: number[];
  /** Impulse along the normal in the last step, N s. */
  readonly impulse: number[];
  /**
   * Speed at which the surface of b slides along that of a in the direction (n_y, -n_x), m/s: 0 where they rest or roll on each other, and
   * where a conveyor belt takes the body along. Sliding sounds are as loud as impulse × |slip|.
   */
  readonly slip: number[];
  /**
   * Colour in the last step, 0 to 30: the solver takes contacts of one colour side by side, because no two of them move the
   * same body. 31 for contacts that found no colour and were taken one at a time, -1 for those between bodies that sleep.
   */
  readonly color: number[];
}

/** Bytes of ids and colour at the start of the record. */
const WORD_BYTES = 16;

const viewOf = namedResource('contact points', (world) => {
  const { internal, memory, precision } = world;
  const bytes = CONTACT_VIEW_BYTES[precision];
  const at = allocate(internal.arena, bytes, 'contact points');
  const Reals = precision === 'f32' ? Float32Array : Float64Array;
  const reals = new Reals(memory.buffer, at + WORD_BYTES, (bytes - WORD_BYTES) / realBytes(precision));
  return { at, words: new Int32Array(memory.buffer, at, WORD_BYTES / 4), reals };
});

/**
 * Lists the contact points of a world with the preset `rigidBodies`. They are those of the last step; other worlds have
 * none.
 * @param into a list of an earlier call, which is written anew and returned: then nothing is allocated
 * @throws PhysicsError E_TYPE, E_CAPACITY, E_DESTROYED
 */
export function contactPoints(world: PhysicsWorld, into: ContactPoints = emptyList()): ContactPoints {
  assertUsable(world);
  const lists = [
    into?.a,
    into?.b,
    into?.x,
    into?.y,
    into?.nx,
    into?.ny,
    into?.separation,
    into?.impulse,
    into?.slip,
    into?.color,
  ];
  checkLists(into, lists, 'contactPoints');
  into.count = 0;
  if (!isSoftStep(world.integrator)) return into;
  const table = rigidTable(world).at;
  const { at, words, reals } = viewOf(world);
  const kernels = rigidKernels(world);
  let count = 0;
  for (let cursor = kernels.nextContactPoint(table, at, 0); cursor > 0; count++) {
    into.a[count] = words[0];
    into.b[count] = words[1];
    into.color[count] = words[2];
    into.x[count] = reals[0];
    into.y[count] = reals[1];
    into.nx[count] = reals[2];
    into.ny[count] = reals[3];
    into.separation[count] = reals[4];
    into.impulse[count] = reals[5];
    into.slip[count] = reals[6];
    cursor = kernels.nextContactPoint(table, at, cursor);
  }
  into.count = count;
  return into;
}

function emptyList(): ContactPoints {
  return { count: 0, a: [], b: [], x: [], y: [], nx: [], ny: [], separation: [], impulse: [], slip: [], color: [] };
}

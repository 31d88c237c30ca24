import { shapePool } from '../collision/shapes/shape-pool.ts';
import { COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all.ts';
import { isInFirstWord } from '../components/membership.ts';
import { assertUsable } from '../ecs/guards.ts';
import { SHAPE_BYTES } from '../memory/layouts.gen.ts';
import type { PhysicsWorld } from '../world/types.ts';

function usesSecondWord(counts: Readonly<Record<ComponentName, number>>): boolean {
  return COMPONENT_NAMES.some((name) => !isInFirstWord(name) && counts[name] > 0);
}

/**
 * Returns a 64-bit hash of the world's state, which covers membership, every component column up to the highest
 * entity in use, and the shapes, as 16 hexadecimal digits. Equal states give equal hashes on every JavaScript engine; -0 counts as 0.
 * @throws PhysicsError E_DESTROYED
 */
export function stateHash(world: PhysicsWorld): string {
  assertUsable(world);
  const { kernels, addresses, internal } = world;
  const rows = world.lastId + 1;
  kernels.hashBegin();
  kernels.hashWords(internal.membersAt, rows);
  if (usesSecondWord(internal.counts)) kernels.hashWords(internal.moreMembersAt, rows);
  for (const name of COMPONENT_NAMES) {
    if (internal.counts[name] === 0) continue;
    for (const [field, spec] of Object.entries(COMPONENTS[name].fields)) {
      const address = (addresses[name] as Record<string, number>)[field] as number;
      if (spec.kind === 'real') kernels.hashReals(address, rows);
      else kernels.hashWords(address, rows);
    }
  }
  const { at, count } = shapePool(world);
  if (count > 1) kernels.hashWords(at, (count * SHAPE_BYTES[world.precision]) / 4);
  const hex = (word: number) => (word >>> 0).toString(16).padStart(8, '0');
  return hex(kernels.hashHigh()) + hex(kernels.hashLow());
}

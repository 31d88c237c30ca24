import { shapePool, shapesOfBodies } from '../collision/shapes/shape-pool.ts';
import { COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all.ts';
import type { ComponentSpec } from '../components/define.ts';
import { isInFirstWord } from '../components/membership.ts';
import { assertUsable } from '../ecs/guards.ts';
import { SHAPE_BYTES } from '../memory/layouts.gen.ts';
import type { PhysicsWorld } from '../world/types.ts';

function usesSecondWord(counts: Readonly<Record<ComponentName, number>>): boolean {
  return COMPONENT_NAMES.some((name) => !isInFirstWord(name) && counts[name] > 0);
}

/**
 * Returns a 64-bit hash of the state of the bodies as 16 hexadecimal digits: which components each entity has, every column up to the
 * highest entity in use, of the package's components and of your own, and the shapes that bodies have. Equal states give equal hashes on every JavaScript
 * engine; -0 counts as 0. Time, emitters, random streams, contacts, sleep, forces and kept objects are not in it: docs/determinism.md says how
 * players compare their worlds.
 * @throws PhysicsError E_DESTROYED
 */
export function stateHash(world: PhysicsWorld): string {
  assertUsable(world);
  const { kernels, addresses, internal } = world;
  const rows = world.lastId + 1;
  kernels.hashBegin();
  kernels.hashWords(internal.membersAt, rows);
  const { ownComponents } = internal;
  if (ownComponents.size > 0 || usesSecondWord(internal.counts)) kernels.hashWords(internal.moreMembersAt, rows);
  for (const name of COMPONENT_NAMES) {
    if (internal.counts[name] === 0) continue;
    hashColumns(world, COMPONENTS[name], addresses[name], rows);
  }
  ownComponents.forEach((own, component) => {
    hashColumns(world, component, own.addresses, rows);
  });
  hashShapes(world);
  const hex = (word: number) => (word >>> 0).toString(16).padStart(8, '0');
  return hex(kernels.hashHigh()) + hex(kernels.hashLow());
}

/** A world that once had other shapes hashes as one that never had. */
function hashShapes(world: PhysicsWorld): void {
  const { at, count } = shapePool(world);
  if (count === 1) return;
  const used = shapesOfBodies(world);
  if (used.size === 1) return;
  const bytes = SHAPE_BYTES[world.precision];
  for (let i = 0; i < count; i++) if (used.has(i)) world.kernels.hashWords(at + i * bytes, bytes / 4);
}

function hashColumns({ kernels }: PhysicsWorld, { fields }: ComponentSpec, addresses: object, rows: number): void {
  for (const [field, { kind }] of Object.entries(fields)) {
    const address = (addresses as Record<string, number>)[field] as number;
    if (kind === 'real') kernels.hashReals(address, rows);
    else kernels.hashWords(address, rows);
  }
}

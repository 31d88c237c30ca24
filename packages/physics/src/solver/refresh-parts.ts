// The list of all parts of compound bodies, for the kernels, kept until components come or go.
import { hasLiveBody, removeOrphanedParts } from '../bodies/parts.ts';
import { rigidKernels } from '../collision/kernels.ts';
import { bitOf } from '../components/membership.ts';
import { noId } from '../ecs/body-references.ts';
import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { isOpen } from '../ecs/rows.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { rigidTable } from './rigid-table.ts';

const partList = namedResource('part list', (): EntityList => emptyEntityList());

/** What a part needs besides its Attachment. */
const NEEDED = ['Position', 'Rotation', 'Collider'] as const;

/**
 * Brings the list of parts up to date. Parts whose body was removed through bitECS are removed here.
 * @throws PhysicsError E_RANGE for a part of a part, a part without one of its components or of what is no id, and a joint or a spring
 *   to a part; E_CAPACITY
 */
export function refreshParts(world: PhysicsWorld): void {
  const { words } = rigidTable(world);
  const { internal } = world;
  if (internal.counts.Attachment === 0 && words[Word.partCount] === 0) return;
  const list = partList(world);
  if (list.version === world.versions.membership) {
    checkBodies(world, list);
    return;
  }
  const { buffer } = world.memory;
  refreshEntityList(world, list, 'Attachment', 0);
  // A copy, because each that is removed changes the list.
  removeOrphanedParts(world, new Uint32Array(buffer, list.ids, list.count).slice());
  refreshEntityList(world, list, 'Attachment', 0);
  words[Word.partIds] = list.ids;
  words[Word.partCount] = list.count;
  const ids = new Uint32Array(buffer, list.ids, list.count);
  try {
    for (const id of ids) checkPart(world, id);
    if (list.count > 0) for (const name of ['Joint', 'Spring'] as const) checkEnds(world, name);
  } catch (error) {
    // The next step checks again.
    list.version = -1;
    throw error;
  }
}

/**
 * Moves the parts of compound bodies to where their bodies are now, for queries between two steps.
 * @throws PhysicsError E_RANGE as `refreshParts`, E_CAPACITY
 */
export function placeParts(world: PhysicsWorld): void {
  if (world.internal.counts.Attachment === 0 || world.state !== 'idle' || !isSoftStep(world.integrator)) return;
  refreshParts(world);
  rigidKernels(world).writeParts(rigidTable(world).at, 1);
}

/** The kernels read the rows of the bodies, which user code may have written to the column. @throws PhysicsError E_RANGE */
function checkBodies({ memory, capacity, components }: PhysicsWorld, { ids: at, count }: EntityList): void {
  const { body } = components.Attachment;
  const ids = new Uint32Array(memory.buffer, at, count);
  for (let i = 0; i < count; i++) {
    if (body[ids[i]] > capacity) throw noId(ids[i], 'attachment.body', body[ids[i]], capacity);
  }
}

function checkPart(world: PhysicsWorld, part: number): void {
  const body = world.components.Attachment.body[part];
  const details = { entity: part, field: 'attachment.body', value: body };
  for (const name of NEEDED) {
    if (isOpen(world, part, name)) continue;
    throw new PhysicsError('E_RANGE', `part ${part} of body ${body} has no ${name}.`, {
      ...details,
      field: name,
      hint: `A part has ${NEEDED.join(', ')} and Attachment: spawnCompound adds all four.`,
    });
  }
  if (part === body || (world.internal.members[body] & bitOf('Attachment')) !== 0 || !hasLiveBody(world, part)) {
    throw new PhysicsError('E_RANGE', `part ${part} is attached to ${body}, which is a part itself.`, {
      ...details,
      hint: 'Attach all parts to the body: parts of parts are not supported.',
    });
  }
}

/** Forces on a part do not reach its body: what pulls at two bodies names these. */
function checkEnds(world: PhysicsWorld, name: 'Joint' | 'Spring'): void {
  const { counts, members } = world.internal;
  if (counts[name] === 0) return;
  const { a, b } = world.components[name];
  const kind = name.toLowerCase();
  for (let id = 1; id <= world.lastId; id++) {
    if (!isOpen(world, id, name)) continue;
    const part = [a[id], b[id]].find((end) => (members[end] & bitOf('Attachment')) !== 0);
    if (part === undefined) continue;
    throw new PhysicsError('E_RANGE', `${kind} ${id} joins ${part}, which is a part of a compound body.`, {
      entity: id,
      field: kind,
      value: part,
      hint: ENDS[name],
    });
  }
}

const ENDS = {
  Joint: 'Join the body: bodyOf(world, part) is its id.',
  Spring: 'Join the body: bodyOf(world, part) is its id. A spring away from its centre is distance({ …, spring }).',
} as const;

// The system of the `emit` phase.
import { removeComponent } from 'bitecs';
import { bitOf } from '../components/all.ts';
import { MAX_POSITION } from '../components/position.ts';
import { isAlive } from '../ecs/entity-ref.ts';
import type { MemoryRecord } from '../memory/record.ts';
import { resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { emitterKernels } from './kernels.ts';
import { dropIncomplete } from './pool.ts';
import { N, W } from './record.ts';
import type { Emitter } from './types.ts';

/** The emitters of a world, in the order they were made, and how many there ever were: the stream of the next. */
export const emittersOf = resource(() => ({ list: [] as Emitter[], made: 0 }));

/** Ages, ends and bears the particles of all emitters. */
export function emitParticles(world: PhysicsWorld, dt: number): void {
  const { list } = emittersOf(world);
  for (let i = 0; i < list.length; i++) {
    const emitter = list[i];
    const { record } = emitter.internal.block;
    if (emitter.internal.membership !== world.versions.membership) {
      emitter.internal.membership = world.versions.membership;
      dropIncomplete(world, record);
    }
    if (emitter.internal.followed !== undefined) follow(world, emitter, record);
    carry(record);
    const born = record.numbers[N.born];
    emitterKernels(world).stepEmitter(record.at, dt);
    if (record.words[W.changed] !== 0) world.versions.style++;
    // Its previous pose is the place of its birth, and not where the row's last life ended.
    if (record.numbers[N.born] !== born) world.versions.pose++;
    if (world.internal.counts.Quarantined > 0) releaseInert(world, emitter);
  }
}

/** Puts the emitter where its body was at the last step and is now; without the body it stops. */
function follow(world: PhysicsWorld, { internal }: Emitter, { words, numbers }: MemoryRecord): void {
  if (internal.followed === undefined || !isAlive(world, internal.followed)) {
    words[W.emits] = 0;
    return;
  }
  const eid = internal.entity;
  const { x, y, z } = world.components.Position;
  // Nobody has looked at the body in this step yet: what is no place is not gone to.
  if (!isPlace(x[eid]) || !isPlace(y[eid]) || !isPlace(z[eid])) return;
  const from = world.previous.Position;
  numbers[N.x] = x[eid];
  numbers[N.y] = y[eid];
  numbers[N.z] = z[eid];
  numbers[N.lastX] = from.x[eid];
  numbers[N.lastY] = from.y[eid];
  numbers[N.lastZ] = from.z[eid];
}

function isPlace(coordinate: number): boolean {
  return Math.abs(coordinate) <= MAX_POSITION;
}

/** The velocity particles inherit: that of the emitter's way since the last step. */
function carry({ numbers }: MemoryRecord): void {
  const pending = numbers[N.pending];
  const factor = pending > 0 ? numbers[N.inheritVelocity] / pending : 0;
  numbers[N.velocityX] = (numbers[N.x] - numbers[N.lastX]) * factor;
  numbers[N.velocityY] = (numbers[N.y] - numbers[N.lastY]) * factor;
  numbers[N.velocityZ] = (numbers[N.z] - numbers[N.lastZ]) * factor;
}

/** A particle's quarantine ends with its life. */
function releaseInert(world: PhysicsWorld, { ids }: Emitter): void {
  const { members } = world.internal;
  const mass = world.components.Mass.value;
  const bit = bitOf('Quarantined');
  for (let i = 0; i < ids.length; i++) {
    if ((members[ids[i]] & bit) !== 0 && mass[ids[i]] === 0) {
      removeComponent(world, ids[i], world.components.Quarantined);
    }
  }
}

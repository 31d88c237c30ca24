// The slots of a pool: a first-in-first-out queue of free slots, and a linked list of living ones by age.
import { columns, get, put } from '../memory/columns';
import { Emitter, putWord, word } from './record';

export const NONE: u32 = 0xffffffff;

// Marks all slots free, in order of id.
export function openPool(emitter: usize): void {
  const e = changetype<Emitter>(emitter);
  for (let slot: i32 = 0; slot < e.capacity; slot++) {
    putWord(e.free, slot, slot);
    putWord(e.generation, slot, word(e.generations, word(e.ids, slot)));
    store<f32>(e.lifetime + ((<usize>slot) << 2), 0);
    deactivate(e, word(e.ids, slot));
    wait(e, word(e.ids, slot));
  }
  e.freeHead = 0;
  e.freeCount = e.capacity;
  e.oldest = NONE;
  e.newest = NONE;
}

// Clears a row so that nothing moves, touches or draws it.
function deactivate(e: Emitter, row: u32): void {
  const c = columns();
  put(c.mass, row, 0);
  put(c.radius, row, 0);
  put(c.velocityX, row, 0);
  put(c.velocityY, row, 0);
  put(c.velocityZ, row, 0);
  put(e.size, row, 0);
}

// Notes that a row waits to be a particle, until its generation changes.
function wait(e: Emitter, row: u32): void {
  putWord(columns().waiting, row, word(e.generations, row) + 1);
}

// Tests whether the pool still owns the entity of a slot: it may have been removed, and its id reused.
// @ts-ignore: decorator
@inline export function ownsEntity(e: Emitter, slot: u32): bool {
  return word(e.generations, word(e.ids, slot)) == word(e.generation, slot);
}

// Increments the generation, so that references to the row's last life become stale.
export function nextGeneration(e: Emitter, slot: u32): void {
  const row = word(e.ids, slot);
  const generation = word(e.generations, row) + 1;
  putWord(e.generations, row, generation);
  putWord(e.generation, slot, generation);
}

function unlink(e: Emitter, slot: u32): void {
  const older = word(e.older, slot);
  const newer = word(e.newer, slot);
  if (older == NONE) e.oldest = newer;
  else putWord(e.newer, older, newer);
  if (newer == NONE) e.newest = older;
  else putWord(e.older, newer, older);
  store<f32>(e.lifetime + ((<usize>slot) << 2), 0);
  e.alive--;
}

export function link(e: Emitter, slot: u32): void {
  putWord(e.older, slot, e.newest);
  putWord(e.newer, slot, NONE);
  if (e.newest == NONE) e.oldest = slot;
  else putWord(e.newer, e.newest, slot);
  e.newest = slot;
  e.alive++;
}

// Ends the particle of a slot. A slot whose entity was removed is dropped: its particle has ended, too.
export function end(e: Emitter, slot: u32): void {
  unlink(e, slot);
  e.ended += 1;
  if (!ownsEntity(e, slot)) return;
  const row = word(e.ids, slot);
  report(e, row);
  deactivate(e, row);
  nextGeneration(e, slot);
  wait(e, row);
  let tail = e.freeHead + e.freeCount;
  if (tail >= e.capacity) tail -= e.capacity;
  putWord(e.free, tail, slot);
  e.freeCount++;
  e.changed = 1;
}

function report(e: Emitter, row: u32): void {
  if (e.endedIds == 0 || e.endedThisStep >= e.capacity) return;
  const c = columns();
  putWord(e.endedIds, e.endedThisStep, row);
  const at = e.endedAt + <usize>e.endedThisStep * 48;
  store<f64>(at, get(c.positionX, row));
  store<f64>(at, get(c.positionY, row), 8);
  store<f64>(at, get(c.positionZ, row), 16);
  store<f64>(at, get(c.velocityX, row), 24);
  store<f64>(at, get(c.velocityY, row), 32);
  store<f64>(at, get(c.velocityZ, row), 40);
  e.endedThisStep++;
}

// Returns the slot that has been free for longest, or that of the oldest particle, or NONE.
export function takeSlot(e: Emitter): u32 {
  for (;;) {
    if (e.freeCount == 0) {
      if (e.recyclesOldest == 0 || e.oldest == NONE) return NONE;
      end(e, e.oldest);
      continue;
    }
    const slot = word(e.free, e.freeHead);
    e.freeHead = e.freeHead + 1 == e.capacity ? 0 : e.freeHead + 1;
    e.freeCount--;
    if (ownsEntity(e, slot)) return slot;
  }
  return NONE;
}

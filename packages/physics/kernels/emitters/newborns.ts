// What forces did to particles between their birth and the step at which they appear.
//
// A particle of age t has moved at the velocity of its birth. With the acceleration a at its present place it gets
//     x += a t^2 / 2,   v += a t,
// which is exact for a constant acceleration and of second order for any other. The forces are evaluated between
// `nextNewborns` and `advanceNewborns` by src/emitters/newborns.ts.
import { columns, get, put } from '../memory/columns';
import { NONE } from './pool';
import { Emitter, word } from './record';

// Rows of one call of the loop of laws.
const CHUNK: i32 = 16;

// Begins the search of `nextNewborns`.
export function findNewborns(emitter: usize): void {
  const e = changetype<Emitter>(emitter);
  e.cursor = e.newest;
  e.remaining = e.newborns;
}

// Returns the first of the next rows with newborn particles, or -1; the record has their end. Rows are taken together
// as long as they are neighbours: a pool that gives its slots in turn has few such groups.
export function nextNewborns(emitter: usize): i32 {
  const e = changetype<Emitter>(emitter);
  let first: i32 = -1;
  for (; e.cursor != NONE && e.remaining > 0; e.cursor = word(e.older, e.cursor), e.remaining--) {
    if (ageOf(e, e.cursor) == 0) continue;
    const chunk = <i32>word(e.ids, e.cursor) & ~(CHUNK - 1);
    if (first < 0) {
      first = chunk;
      e.newbornEnd = chunk + CHUNK;
    } else if (chunk + CHUNK == first) {
      first = chunk;
    } else if (chunk == e.newbornEnd) {
      e.newbornEnd += CHUNK;
    } else if (chunk < first || chunk > e.newbornEnd) {
      break;
    }
  }
  return first;
}

// @ts-ignore: decorator
@inline function ageOf(e: Emitter, slot: u32): f64 {
  return e.clock - load<f64>(e.bornAt + ((<usize>slot) << 3));
}

// Moves all newborn particles by the forces in the columns at these addresses. A force that is not finite is left to the
// step, which reports it.
export function advanceNewborns(emitter: usize, forceX: usize, forceY: usize, forceZ: usize): void {
  const e = changetype<Emitter>(emitter);
  const c = columns();
  let remaining = e.newborns;
  for (let slot = e.newest; slot != NONE && remaining > 0; slot = word(e.older, slot), remaining--) {
    const row = word(e.ids, slot);
    const age = ageOf(e, slot);
    const perMass = age / <f64>get(c.mass, row);
    const dx = perMass * <f64>get(forceX, row);
    const dy = perMass * <f64>get(forceY, row);
    const dz = e.dimensions == 2 ? 0 : perMass * <f64>get(forceZ, row);
    const sum = dx + dy + dz;
    if (age == 0 || sum - sum != 0) continue;
    push(c.positionX, c.velocityX, e.previousX, row, dx, age);
    push(c.positionY, c.velocityY, e.previousY, row, dy, age);
    if (e.dimensions == 3) push(c.positionZ, c.velocityZ, e.previousZ, row, dz, age);
  }
}

function push(position: usize, velocity: usize, previous: usize, row: i32, change: f64, age: f64): void {
  const x = <real>(<f64>get(position, row) + 0.5 * change * age);
  put(position, row, x);
  put(previous, row, x);
  put(velocity, row, <real>(<f64>get(velocity, row) + change));
}

// The impacts of a phase, for src/particle-contacts/impact-list.ts: under forces that depend on position or velocity the
// steps of their bodies are taken again. The list shares memory with the blocks, which are packed later.
import { ContactTable } from './table';

// Bytes of an entry: two words, then NUMBERS numbers.
const NUMBERS: usize = 12;
const WORDS_SIZE: usize = 8;

// An impact after which a body rests has this in place of its restitution.
export const RESTS: real = -1;

// Under such forces elastic impacts act at the end of the step (impacts.ts), up to this depth, in sums of the radii.
export const MAX_DEPTH: real = 0.25;

// Notes an impact with restitution `e` a `time` ago. Returns the address of the next number, 0 if there is no place or
// no need for it.
export function noteImpact(t: ContactTable, a: i32, b: i32, e: real, time: real): usize {
  if (t.impactCapacity == 0 || t.impactCount > t.impactCapacity) return 0;
  const k = t.impactCount++;
  if (k == t.impactCapacity) return 0;
  const at = t.blocks + <usize>k * (WORDS_SIZE + NUMBERS * sizeof<real>());
  store<i32>(at, a);
  store<i32>(at, b, 4);
  store<real>(at + WORDS_SIZE, e);
  store<real>(at + WORDS_SIZE, time, sizeof<real>());
  return at + WORDS_SIZE + 2 * sizeof<real>();
}

// Stores the three numbers of a vector from address `at` on, and returns the address behind them.
export function noteVector(at: usize, x: real, y: real, z: real): usize {
  store<real>(at, x);
  store<real>(at, y, sizeof<real>());
  store<real>(at, z, 2 * sizeof<real>());
  return at + 3 * sizeof<real>();
}

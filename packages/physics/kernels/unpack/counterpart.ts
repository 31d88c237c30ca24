// Where the second build of a module stands in the first: its functions are the same in the same order, but here and
// there it has other instructions. So the instruction expected next is the one after that met last, and where they
// part, the nearest one after the same three as here.
import { BODIES, FAMILIES, FIRST, STARTS } from './memory';

const SEARCH: i32 = 200;
const MOST_FUNCTIONS: i32 = 1024;

let count: i32 = 0;
let functions: i32 = 0;
let next: i32 = 0;
/** The latest three families here, a byte each. */
let trace: u32 = 0;
/** How many instructions in a row came as expected. */
export let agreed: i32 = 0;

/** Opcodes of 32-bit reals for those of 64 bits: all SIMD is one, since it differs in the opcode that follows. */
function family(op: u32): u32 {
  if (op > 0xff) return 0xff;
  if (op - 0x99 <= 13) return op - 14;
  if (op - 0x61 <= 5) return op - 6;
  return op == 0x2b || op == 0x39 || op == 0x44 ? op - 1 : op;
}

/** A function of the first build begins. */
export function noteFunction(start: i32): void {
  store<i32>(BODIES + (functions << 2), start);
  store<i32>(FIRST + (functions << 2), count);
  functions = (functions + 1) % MOST_FUNCTIONS;
}

/** An instruction of the first build was read. */
export function noteInstruction(start: i32, op: u32): void {
  store<i32>(STARTS + (count << 2), start);
  store<u8>(FAMILIES + count, family(op));
  count++;
}

/** A function of the second build begins: where it did in the first. */
export function enterFunction(index: i32): i32 {
  index %= MOST_FUNCTIONS;
  next = load<i32>(FIRST + (index << 2));
  agreed = 3;
  return load<i32>(BODIES + (index << 2));
}

/** Where in the first build the instruction stands that is expected next, and the one after it. */
export function expectedStart(): i32 {
  return load<i32>(STARTS + (next << 2));
}

export function expectedEnd(): i32 {
  return load<i32>(STARTS + (next << 2) + 4);
}

/** An instruction of the second build was read. */
export function follow(op: u32): void {
  const met = family(op);
  trace = ((trace << 8) | met) & 0xffffff;
  agreed = load<u8>(FAMILIES + next) == met ? agreed + 1 : 0;
  next++;
  if (agreed > 2) return;
  for (let away = 0; away < SEARCH; away++) {
    if (traceBefore(next + away) == trace) next += away;
    else if (traceBefore(next - away) == trace) next -= away;
    else continue;
    return;
  }
}

// @ts-ignore: decorator
@inline function traceBefore(place: i32): u32 {
  return (
    ((<u32>load<u8>(FAMILIES + place - 3)) << 16) |
    ((<u32>load<u8>(FAMILIES + place - 2)) << 8) |
    load<u8>(FAMILIES + place - 1)
  );
}

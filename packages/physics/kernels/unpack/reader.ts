// Reads two builds of a WebAssembly module. What a byte can be depends on the instruction it belongs to and on the
// instructions before it, far more than on the bytes before it; so this follows the grammar of modules (WebAssembly Core
// Specification 2.0, section 5) and guesses each byte from what it knows. The size of a function body is not read but worked
// out, and has two bytes.
import * as counterpart from './counterpart';
import { skipBytes } from './coder';
import { BYTES, CONTEXT_SLOTS, CUSTOMS, HABITS, OPERANDS, PLACES, SLOT_BITS, SLOTS } from './memory';
import { choose, nextByte, prepareTables } from './predictor';

/** What a byte is. */
const OPCODE = 0;
const PREFIXED = 1;
const NUMBER = 2;
const RAW = 3;
const OUTSIDE = 4;
const HEADER = 5;

const EXPORT_SECTION = 7;
const CODE_SECTION = 10;
/** Holds nothing. */
const NONE: usize = OPERANDS + 0x800;
/** Bytes that went the same way, after which the next is expected to do so too. */
const ENOUGH = 7;
/** How often in a row the same must have come after two instructions to be expected. */
const CUSTOM: u8 = 9;

let at: i32 = 0;
let begin: i32 = 0;
let end: i32 = 0;
/** The function, its latest instructions, and the latest local it used. */
let fn: i32 = 0;
let op1: i32 = 0;
let op2: i32 = 0;
let op3: i32 = 0;
let op4: i32 = 0;
let op5: i32 = 0;
let local: i32 = 0;
/** The instruction that is being read. */
let op: i32 = 0;
/** A place here, the place in the first build that it goes by, and where that ends. */
let here: i32 = 0;
let there: i32 = 0;
let thereEnd: i32 = 0;
/** One more than the byte that stands here in the first build, or would if its real were a shorter one; or 0. */
let other: i32 = 0;
/** Where it is held what came in the second build for such a byte of the first. */
let habit: usize = 0;
/** Where it is held what came last after the same two instructions. */
let custom: usize = 0;
/** The place that went the same way before, and for how many bytes it did. */
let match: i32 = 0;
let matched: i32 = 0;

export function readModules(first: i32, second: i32): void {
  prepareTables();
  readModule(first);
  readModule(first + second);
}

function readModule(until: i32): void {
  begin = at;
  end = until;
  compare(0, begin);
  for (let i = 0; i < 8; i++) byte(OUTSIDE, i);
  while (at < end) {
    fn = 0;
    op = 0;
    const section = byte(OUTSIDE, 0);
    op = section;
    const size = number(OUTSIDE, 0);
    if (section == CODE_SECTION) {
      for (let left = number(OUTSIDE, 0); left > 0 && at < end; left--) readBody();
    } else for (const last = min(end, at + size); at < last; ) byte(OUTSIDE, 1);
  }
}

function readBody(): void {
  op1 = op2 = op3 = op4 = op5 = 0;
  if (begin == 0) counterpart.noteFunction(at);
  else compare(counterpart.enterFunction(fn), i32.MAX_VALUE);
  fn++;
  // Its size is told by where it ends: two bytes for it stand there and are not packed.
  const start = at;
  store<u16>(BYTES + start, 0);
  at += 2;
  skipBytes(2);
  op = 21;
  for (let groups = number(HEADER, 0); groups > 0 && at < end; groups--) {
    op = 22;
    number(HEADER, 0);
    op = 23;
    byte(HEADER, 0);
  }
  for (let depth = 1; depth > 0 && at < end; ) {
    readInstruction();
    if (op1 >= 0x02 && op1 <= 0x04) depth++;
    else if (op1 == 0x0b) depth--;
  }
  const size = at - start - 2;
  store<u8>(BYTES + start, (size & 127) | 128);
  store<u8>(BYTES + start, size >>> 7, 1);
}

function readInstruction(): void {
  const start = at;
  if (begin != 0) compare(counterpart.expectedStart(), counterpart.expectedEnd());
  op = 0;
  let read = byte(OPCODE, 0);
  op = read;
  if (read >= 0xfc) {
    const prefixed = byte(PREFIXED, 0);
    read = ((read - 0xfb) << 8) | prefixed;
    if (prefixed >= 0x80) byte(PREFIXED, 1);
    op = read & 0x3ff;
  }
  readOperands(read);
  if (begin == 0) counterpart.noteInstruction(start, read);
  else counterpart.follow(read);
  op5 = op4;
  op4 = op3;
  op3 = op2;
  op2 = op1;
  op1 = read;
}

/** The numbers and then the other bytes that belong to an opcode; prefixed ones have 0x100 or 0x200 added. */
function readOperands(read: i32): void {
  let numbers = 0;
  let raw = 0;
  const simd = read - 0x200;
  if (simd >= 0) {
    if (simd <= 0x0b || (simd >= 0x54 && simd <= 0x5d)) numbers = 2;
    if (simd == 0x0c || simd == 0x0d) raw = 16;
    else if ((simd >= 0x15 && simd <= 0x22) || (simd >= 0x54 && simd <= 0x5b)) raw = 1;
  } else if (read == 0x10a) numbers = 2;
  else if (read == 0x10b) numbers = 1;
  else if (read == 0x0e) numbers = number(NUMBER, 0) + 1;
  else if (read == 0x43) raw = 4;
  else if (read == 0x44) raw = 8;
  else if (read >= 0x28 && read <= 0x3e) numbers = 2;
  else if ((read >= 0x02 && read <= 0x04) || read == 0x0c || read == 0x0d || read == 0x10) numbers = 1;
  else if ((read >= 0x20 && read <= 0x24) || (read >= 0x3f && read <= 0x42)) numbers = 1;
  for (let i = 0; i < numbers; i++) number(NUMBER, 8 * i);
  for (let i = 0; i < raw; i++) byte(RAW, 8 * numbers + i);
}

/** A number of seven bits a byte, the lowest first. */
function number(kind: i32, place: i32): i32 {
  let result = 0;
  for (let shift = 0; shift < 70; shift += 7) {
    const read = byte(kind, place++);
    result |= (read & 127) << shift;
    if (read < 128) break;
  }
  return result;
}

function compare(from: i32, until: i32): void {
  here = at;
  there = from;
  thereEnd = until;
}

/** The next byte; zeros follow the end. */
function byte(kind: i32, place: i32): i32 {
  if (at >= end) return 0;
  hashContexts(kind, place);
  let expected: i32 = load<u16>(habit);
  if (matched > ENOUGH) expected = load<u8>(BYTES + match) + 1;
  else if (expected == 0 && load<u8>(custom, 1) >= CUSTOM) expected = load<u8>(custom) + 1;
  if (expected == 0) expected = other;
  const read = nextByte(expected);
  store<u8>(custom, load<u8>(custom) == read ? min<i32>(254, load<u8>(custom, 1)) + 1 : 1, 1);
  store<u8>(custom, read);
  store<u8>(BYTES + at, read);
  store<u16>(habit, habit == NONE ? 0 : read + 1);
  if (kind == NUMBER && read < 128) {
    store<u8>(OPERANDS + op, read);
    if (op >= 0x20 && op <= 0x22) local = read;
  }
  if (matched > 0 && load<u8>(BYTES + match) == read) {
    match++;
    matched++;
  } else matched = 0;
  at++;
  findMatch();
  return read;
}

// @ts-ignore: decorator
@inline function both(hash: i32, value: i32): i32 {
  return hash * 0x2f0b4c47 + value + 1;
}

function context(index: i32, hash: i32): void {
  const mixed = hash * 0x2545f491;
  const slot = ((mixed ^ (mixed >>> 15)) * 0x3c6ef372) >>> (32 - SLOT_BITS);
  store<usize>(CONTEXT_SLOTS + (index << 2), SLOTS + (((index << SLOT_BITS) | slot) << 1));
}

function before(distance: i32): i32 {
  return at - distance < begin ? 0 : load<u8>(BYTES + at - distance);
}

function hashContexts(kind: i32, place: i32): void {
  const state = kind | (op << 3) | (place << 13);
  const twin = there + at - here;
  other = twin < thereEnd ? <i32>load<u8>(BYTES + twin) + 1 : 0;
  // A constant of 32 bits, where the first build has one of 64.
  if (op == 0x43 && kind == RAW && load<u8>(BYTES + there) == 0x44) {
    const real = <f32>load<f64>(BYTES + there, 1);
    other = ((reinterpret<i32>(real) >>> (place << 3)) & 255) + 1;
  }
  // Exports are a letter and an index each, and both count.
  if (op == EXPORT_SECTION) other = before(4) + 2;
  const same = matched > 0 ? load<u8>(BYTES + match) + 1 : 0;
  habit = other == 0 ? NONE : HABITS + (((both(state, other) * 0x9e3779b1) >>> 17) << 1);
  const b1 = before(1);
  const b2 = before(2);
  choose(0, op);
  choose(1, op1);
  choose(2, b1);
  let hash = both(state, op1);
  context(0, both(b1, b2));
  context(1, both(both(state, other), min(15, counterpart.agreed)));
  context(2, hash);
  context(3, (hash = both(hash, op2)));
  custom = CUSTOMS + (((hash * 0x9e3779b1) >>> 17) << 1);
  hash = both(hash, op3);
  context(4, (hash = both(hash, op4)));
  context(5, both(hash, op5));
  context(6, both(both(state, load<u8>(OPERANDS + op)), b1));
  context(7, both(both(both(state, local), op1), fn));
  context(8, both(both(state, other), fn));
  context(9, both(same, min(20, matched)));
  context(10, both(both(same, i32(matched > 7)), b1));
}

/** The latest place that followed the same four bytes. */
function findMatch(): void {
  if (at < 4) return;
  const key = PLACES + (((load<u32>(BYTES + at - 4) * 0x9e3779b1) >>> 16) << 2);
  if (matched == 0) {
    match = load<i32>(key);
    matched = i32(match > 0);
  }
  store<i32>(key, at);
}

// The WebAssembly instructions used by fused loops, and their encoding. Source: WebAssembly Core Specification 2.0,
// section 5.4 (binary format of instructions).

/** An instruction: its name in the text format, and its immediates. */
export interface Instruction {
  readonly name: string;
  readonly immediates: readonly number[];
  /** A comment for printed code. */
  readonly note?: string | undefined;
}

type Kind = 'none' | 'index' | 'signed' | 'double' | 'memory' | 'vector' | 'lane' | 'block';

/** Opcode and kind of immediates; vector instructions have the prefix 0xfd. */
interface Opcode {
  readonly code: number;
  readonly isVector: boolean;
  readonly kind: Kind;
}

const table = new Map<string, Opcode>();

function list(kind: Kind, isVector: boolean, codes: Readonly<Record<string, number>>): void {
  for (const [name, code] of Object.entries(codes)) table.set(name, { code, isVector, kind });
}

list('block', false, { block: 0x02, loop: 0x03, if: 0x04 });
list('none', false, { else: 0x05, end: 0x0b, return: 0x0f, drop: 0x1a, select: 0x1b });
list('index', false, { br: 0x0c, br_if: 0x0d, call: 0x10, 'local.get': 0x20, 'local.set': 0x21, 'local.tee': 0x22 });
list('memory', false, { 'i32.load': 0x28, 'f64.load': 0x2b, 'i32.store': 0x36, 'f64.store': 0x39 });
list('signed', false, { 'i32.const': 0x41 });
list('double', false, { 'f64.const': 0x44 });
list('none', false, {
  'i32.eqz': 0x45,
  'i32.ne': 0x47,
  'i32.lt_u': 0x49,
  'f64.eq': 0x61,
  'f64.lt': 0x63,
  'f64.le': 0x65,
  'i32.add': 0x6a,
  'i32.sub': 0x6b,
  'i32.mul': 0x6c,
  'i32.and': 0x71,
  'i32.or': 0x72,
  'i32.shl': 0x74,
  'i32.shr_u': 0x76,
  'f64.abs': 0x99,
  'f64.neg': 0x9a,
  'f64.floor': 0x9c,
  'f64.nearest': 0x9e,
  'f64.sqrt': 0x9f,
  'f64.add': 0xa0,
  'f64.sub': 0xa1,
  'f64.mul': 0xa2,
  'f64.div': 0xa3,
  'i32.trunc_f64_u': 0xab,
  'f32.demote_f64': 0xb6,
  'f64.promote_f32': 0xbb,
});
list('memory', true, { 'v128.load': 0x00, 'v128.store': 0x0b, 'v128.load64_zero': 0x5d });
list('vector', true, { 'v128.const': 0x0c });
list('lane', true, {
  'f32x4.extract_lane': 0x1f,
  'f32x4.replace_lane': 0x20,
  'f64x2.extract_lane': 0x21,
  'f64x2.replace_lane': 0x22,
});
list('none', true, {
  'i32x4.splat': 0x11,
  'i64x2.splat': 0x12,
  'f32x4.splat': 0x13,
  'f64x2.splat': 0x14,
  'i32x4.eq': 0x37,
  'f32x4.eq': 0x41,
  'f32x4.lt': 0x43,
  'f32x4.le': 0x45,
  'f64x2.eq': 0x47,
  'f64x2.lt': 0x49,
  'f64x2.le': 0x4b,
  'v128.not': 0x4d,
  'v128.and': 0x4e,
  'v128.andnot': 0x4f,
  'v128.or': 0x50,
  'v128.xor': 0x51,
  'v128.bitselect': 0x52,
  'f32x4.floor': 0x68,
  'f32x4.nearest': 0x6a,
  'f64x2.floor': 0x75,
  'f64x2.nearest': 0x94,
  'f64x2.promote_low_f32x4': 0x5f,
  'i32x4.bitmask': 0xa4,
  'i32x4.add': 0xae,
  'i64x2.bitmask': 0xc4,
  'i64x2.extend_low_i32x4_u': 0xc9,
  'i64x2.eq': 0xd6,
  'f32x4.convert_i32x4_u': 0xfb,
  'f64x2.convert_low_i32x4_u': 0xff,
  'f32x4.abs': 0xe0,
  'f32x4.neg': 0xe1,
  'f32x4.sqrt': 0xe3,
  'f32x4.add': 0xe4,
  'f32x4.sub': 0xe5,
  'f32x4.mul': 0xe6,
  'f32x4.div': 0xe7,
  'f32x4.pmin': 0xea,
  'f32x4.pmax': 0xeb,
  'f64x2.abs': 0xec,
  'f64x2.neg': 0xed,
  'f64x2.sqrt': 0xef,
  'f64x2.add': 0xf0,
  'f64x2.sub': 0xf1,
  'f64x2.mul': 0xf2,
  'f64x2.div': 0xf3,
  'f64x2.pmin': 0xf6,
  'f64x2.pmax': 0xf7,
});

/** Returns the opcode of an instruction. */
export function opcodeOf(name: string): Opcode {
  const opcode = table.get(name);
  if (opcode === undefined) throw new Error(`There is no instruction "${name}".`);
  return opcode;
}

/** The body of a function, one instruction after another. */
export class Code {
  readonly instructions: Instruction[] = [];

  add(name: string, ...immediates: readonly number[]): this {
    this.instructions.push({ name, immediates });
    return this;
  }

  /** Adds an instruction that reads or writes memory; the note names the accessed data in printed code. */
  memory(name: string, offset: number, note?: string): this {
    this.instructions.push({ name, immediates: [offset], note });
    return this;
  }
}

// Encodes functions in the binary format of WebAssembly modules (Core Specification 2.0, section 5).
import { type Code, type Instruction, opcodeOf } from './instructions.ts';

export type ValueType = 'i32' | 'f64' | 'v128';

const TYPES = { i32: 0x7f, f64: 0x7c, v128: 0x7b } as const;

/** A function that a module imports. */
export interface Import {
  readonly name: string;
  readonly parameters: readonly ValueType[];
}

/** A module with one function over the memory of a world. */
export interface ModuleSource {
  readonly imports: readonly Import[];
  readonly name: string;
  readonly parameters: readonly ValueType[];
  readonly result: ValueType;
  readonly locals: readonly ValueType[];
  readonly code: Code;
}

const [TYPE, IMPORT, FUNCTION, EXPORT, CODE] = [1, 2, 3, 7, 10];
const HEADER = [0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00];

/** Returns the bytes of a module. Imported functions return f64. */
export function encodeModule(source: ModuleSource): Uint8Array<ArrayBuffer> {
  const { imports, name, parameters, result, locals, code } = source;
  const types = [...imports.map((each) => functionType(each.parameters, 'f64')), functionType(parameters, result)];
  const memory = [...text('env'), ...text('memory'), 0x02, 0x00, 0x01];
  const functions = imports.map((each, i) => [...text('math'), ...text(each.name), 0x00, ...unsigned(i)]);
  const body = [...vector(locals.map((type) => [0x01, TYPES[type]])), ...instructionBytes(code.instructions), 0x0b];
  return Uint8Array.from([
    ...HEADER,
    ...section(TYPE, vector(types)),
    ...section(IMPORT, vector([memory, ...functions])),
    ...section(FUNCTION, vector([unsigned(imports.length)])),
    ...section(EXPORT, vector([[...text(name), 0x00, ...unsigned(imports.length)]])),
    ...section(CODE, vector([[...unsigned(body.length), ...body]])),
  ]);
}

function functionType(parameters: readonly ValueType[], result: ValueType): number[] {
  return [0x60, ...vector(parameters.map((type) => [TYPES[type]])), 0x01, TYPES[result]];
}

function instructionBytes(instructions: readonly Instruction[]): number[] {
  const bytes: number[] = [];
  for (const { name, immediates } of instructions) {
    const { code, isVector, kind } = opcodeOf(name);
    if (isVector) bytes.push(0xfd, ...unsigned(code));
    else bytes.push(code);
    const [first] = immediates;
    if (kind === 'index') bytes.push(...unsigned(first));
    else if (kind === 'signed') bytes.push(...signed(first));
    else if (kind === 'double') bytes.push(...new Uint8Array(Float64Array.of(first).buffer));
    // Alignment is an optional hint; 0 gives none.
    else if (kind === 'memory') bytes.push(0x00, ...unsigned(first));
    else if (kind === 'vector' || kind === 'lane') bytes.push(...immediates);
    else if (kind === 'block') bytes.push(0x40);
  }
  return bytes;
}

function section(id: number, content: readonly number[]): number[] {
  return [id, ...unsigned(content.length), ...content];
}

function vector(items: readonly (readonly number[])[]): number[] {
  return [...unsigned(items.length), ...items.flat()];
}

function text(value: string): number[] {
  return [...unsigned(value.length), ...Array.from(value, (letter) => letter.charCodeAt(0))];
}

/** LEB128: seven bits per byte, lowest first. */
function unsigned(value: number): number[] {
  const bytes: number[] = [];
  let remaining = value;
  while (remaining > 0x7f) {
    bytes.push((remaining % 0x80) | 0x80);
    remaining = Math.floor(remaining / 0x80);
  }
  bytes.push(remaining);
  return bytes;
}

function signed(value: number): number[] {
  const bytes: number[] = [];
  let remaining = value | 0;
  for (;;) {
    const low = remaining & 0x7f;
    remaining >>= 7;
    if ((remaining === 0 && (low & 0x40) === 0) || (remaining === -1 && (low & 0x40) !== 0)) return [...bytes, low];
    bytes.push(low | 0x80);
  }
}

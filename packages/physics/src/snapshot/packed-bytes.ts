// The bytes of an encoded snapshot: a mark, a checksum, the length of the header, the header as JSON, arrays of numbers.
import { PhysicsError } from '../errors/physics-error.ts';

/** An array among the bytes: the name of its class, where it begins after the header, its number of elements. */
export type ArrayPlace = readonly [type: string, offset: number, length: number];

export type NumberArray = Uint8Array | Int32Array | Uint32Array | Float32Array | Float64Array;

type ArrayMaker = new (buffer: ArrayBuffer, at: number, length: number) => NumberArray;

const ARRAY_TYPES: Readonly<Record<string, ArrayMaker>> = {
  Uint8Array,
  Int32Array,
  Uint32Array,
  Float32Array,
  Float64Array,
  ...({ Int8Array, Uint8ClampedArray, Int16Array, Uint16Array, BigInt64Array, BigUint64Array } as object),
};

/** 'PRIN', and a number that changes with the format. */
const MARK = [0x50, 0x52, 0x49, 0x4e, 2] as const;
const CHECKSUM_AT = 8;
const LENGTH_AT = 12;
const HEADER_AT = 16;

/** Collects arrays, and writes them behind a header. */
export class BytesWriter {
  readonly #arrays: NumberArray[] = [];
  #length = 0;

  add(array: NumberArray): ArrayPlace {
    const place = [array[Symbol.toStringTag], this.#length, array.length] as const;
    this.#arrays.push(array);
    this.#length = roundUp(this.#length + array.byteLength);
    return place;
  }

  finish(header: unknown): Uint8Array {
    const text = new TextEncoder().encode(JSON.stringify(header));
    const start = roundUp(HEADER_AT + text.length);
    const bytes = new Uint8Array(start + this.#length);
    bytes.set(MARK);
    bytes.set(text, HEADER_AT);
    let at = start;
    for (const { buffer, byteOffset, byteLength } of this.#arrays) {
      bytes.set(new Uint8Array(buffer, byteOffset, byteLength), at);
      at = roundUp(at + byteLength);
    }
    const numbers = new DataView(bytes.buffer);
    numbers.setUint32(LENGTH_AT, text.length, true);
    numbers.setUint32(CHECKSUM_AT, checksumOf(bytes.subarray(LENGTH_AT)), true);
    return bytes;
  }
}

/** Reads what `BytesWriter` wrote. */
export class BytesReader {
  readonly header: unknown;
  readonly #bytes: Uint8Array;
  readonly #start: number;

  /** @throws PhysicsError E_TYPE for bytes that are no snapshot, or not whole */
  constructor(given: Uint8Array) {
    if (!(given instanceof Uint8Array)) throw notASnapshot('it is no Uint8Array');
    // A copy, so that arrays lie at multiples of eight, and nothing changes meanwhile; not by `slice`, which does not copy in a Buffer.
    const bytes = new Uint8Array(given);
    if (bytes.length < HEADER_AT || MARK.some((byte, i) => bytes[i] !== byte))
      throw notASnapshot('it begins otherwise');
    const numbers = new DataView(bytes.buffer);
    if (numbers.getUint32(CHECKSUM_AT, true) !== checksumOf(bytes.subarray(LENGTH_AT))) {
      throw notASnapshot('its checksum is wrong: bytes were lost or changed');
    }
    const length = numbers.getUint32(LENGTH_AT, true);
    this.#bytes = bytes;
    this.#start = roundUp(HEADER_AT + length);
    this.header = JSON.parse(new TextDecoder().decode(bytes.subarray(HEADER_AT, HEADER_AT + length)));
  }

  /** A view of an array. */
  array<T extends NumberArray>([type, offset, length]: ArrayPlace): T {
    return new ARRAY_TYPES[type](this.#bytes.buffer as ArrayBuffer, this.#start + offset, length) as T;
  }
}

/** Whether arrays of this class can be written. */
export function isNumberArray(value: object): value is NumberArray {
  return Object.hasOwn(ARRAY_TYPES, value.constructor.name);
}

/** Makes an array of the class with this name. */
export function makeArray(type: string, buffer: ArrayBuffer, at: number, length: number): NumberArray {
  return new ARRAY_TYPES[type](buffer, at, length);
}

function notASnapshot(why: string): PhysicsError {
  return new PhysicsError('E_TYPE', `decodeSnapshot: the bytes are not an encoded snapshot: ${why}.`, {
    field: 'bytes',
    hint: 'Pass the bytes that `encodeSnapshot(…)` returned.',
  });
}

function roundUp(bytes: number): number {
  return Math.ceil(bytes / 8) * 8;
}

/** FNV-1a of 32 bits. */
function checksumOf(bytes: Uint8Array): number {
  let hash = 0x811c9dc5;
  for (let i = 0; i < bytes.length; i++) hash = Math.imul(hash ^ bytes[i], 0x01000193);
  return hash >>> 0;
}

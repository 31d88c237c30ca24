/**
 * Shows encoded as text for a URL: `3.` followed, in URL-safe base64, by a check byte and six bytes per shell. The
 * six bytes are a number of mixed radix with the digits, most significant first: time in tenths of a second, x, y, z,
 * kind, colour, power. Versions 1 and 2, of five bytes, in which shells reached less far, are read as well.
 */
import { FIREWORKS_REACH, SHELL_NAMES, STAR_COLORS } from '@principia/scenes';
import { bytesOfText, textOfBytes } from '@principia/shell';
import type { Cue } from './sim.ts';
import { WORDS } from './words.ts';

/** Largest number of shells of a show, and its last time, steps. */
export const MAX_CUES = 200;
export const LAST_TICK = 6 * 999;

/** How a version writes a shell. */
interface Format {
  readonly bytes: number;
  /** Radix of each digit. Their product is below 256 to the power of `bytes`. */
  readonly radices: readonly number[];
  /** Lowest value of x, y and z, and their resolution, m. */
  readonly from: readonly [x: number, y: number, z: number];
  readonly step: readonly [x: number, y: number, z: number];
}

const { halfWidth, halfDepth, lowest, highest } = FIREWORKS_REACH;
const OLD = { bytes: 5, from: [-48, 12, -15], step: [0.4, 0.3, 1] } as const;
const VERSION = '3';
const FORMATS: Readonly<Record<string, Format>> = {
  1: { ...OLD, radices: [1024, 256, 128, 32, 8, 8, 16] },
  2: { ...OLD, radices: [1000, 241, 127, 31, 9, 8, 16] },
  3: {
    bytes: 6,
    radices: [1000, 401, 314, 401, SHELL_NAMES.length, STAR_COLORS.length, 16],
    from: [-halfWidth, lowest, -halfDepth],
    step: [0.4, 0.3, 0.4],
  },
};
const FORMAT = FORMATS[VERSION];
const TENTH = 6;
const POWERS = 15;

const roundClamped = (value: number, low: number, high: number) => Math.min(high, Math.max(low, Math.round(value)));

/** The digits of a shell, most significant first. */
function digitsOf({ tick, x, y, z, kind, color, power }: Cue): number[] {
  const digit = (value: number, axis: 0 | 1 | 2, high: number) => {
    const steps = (to: number) => (to - FORMAT.from[axis]) / FORMAT.step[axis];
    return roundClamped(steps(value), 0, Math.floor(steps(high) + 1e-9));
  };
  return [
    roundClamped(tick / TENTH, 0, LAST_TICK / TENTH),
    digit(x, 0, halfWidth),
    digit(y, 1, highest),
    digit(z, 2, halfDepth),
    kind,
    color,
    roundClamped(power * POWERS, 0, POWERS),
  ];
}

function cueOf([tick, x, y, z, kind, color, power]: number[], { from, step }: Format): Cue {
  // All resolutions are whole decimetres.
  const metres = (digit: number, axis: 0 | 1 | 2) => Math.round(10 * (digit * step[axis] + from[axis])) / 10;
  return {
    tick: tick * TENTH,
    x: metres(x, 0),
    y: metres(y, 1),
    z: metres(z, 2),
    kind,
    color,
    power: power / POWERS,
  };
}

/** Rounds a shell to the resolution of the encoding. */
export function quantize(cue: Cue): Cue {
  return cueOf(digitsOf(cue), FORMAT);
}

function checkByte(bytes: Uint8Array, from: number): number {
  let check = 90;
  for (let i = from; i < bytes.length; i++) check = (31 * check + bytes[i] + 7) & 255;
  return check;
}

/** Encodes a show, in at most 1 610 characters. */
export function writeShow(cues: readonly Cue[]): string {
  const size = FORMAT.bytes;
  const bytes = new Uint8Array(1 + size * cues.length);
  for (const [i, cue] of cues.entries()) {
    let bits = digitsOf(cue).reduce((sum, value, digit) => sum * FORMAT.radices[digit] + value, 0);
    for (let b = size; b > 0; b--) {
      bytes[size * i + b] = bits % 256;
      bits = Math.floor(bits / 256);
    }
  }
  bytes[0] = checkByte(bytes, 1);
  return `${VERSION}.${textOfBytes(bytes)}`;
}

/** Decodes a show. @throws Error with a sentence that says what is wrong with the text and what to do */
export function readShow(text: string): Cue[] {
  const [, version, body] = /^([^.]*)\.(.*)$/s.exec(text) ?? [];
  if (version === undefined || body === undefined) throw broken(WORDS.broken.noVersion);
  if (!Object.hasOwn(FORMATS, version)) {
    throw new Error(WORDS.broken.version(version.slice(0, 12)));
  }
  const format = FORMATS[version];
  const bytes = bytesOf(body);
  if ((bytes.length - 1) % format.bytes !== 0) throw broken(WORDS.broken.length);
  if (checkByte(bytes, 1) !== bytes[0]) throw broken(WORDS.broken.checksum);
  const count = (bytes.length - 1) / format.bytes;
  if (count > MAX_CUES) throw new Error(WORDS.broken.count(count, MAX_CUES));
  const cues = Array.from({ length: count }, (_, i) => unpack(bytes, 1 + format.bytes * i, format));
  for (const [i, { tick }] of cues.entries()) {
    if (i > 0 && tick < cues[i - 1].tick) throw broken(WORDS.broken.order);
  }
  return cues;
}

function unpack(bytes: Uint8Array, at: number, format: Format): Cue {
  let bits = 0;
  for (let b = 0; b < format.bytes; b++) bits = bits * 256 + bytes[at + b];
  const values: number[] = [];
  for (const radix of format.radices.toReversed()) {
    values.unshift(bits % radix);
    bits = Math.floor(bits / radix);
  }
  // A remainder cannot come from the encoder.
  if (bits > 0) throw broken(WORDS.broken.time);
  return quantize(cueOf(values, format));
}

function bytesOf(body: string): Uint8Array {
  if (!/^[\w-]+$/.test(body)) throw broken(WORDS.broken.characters);
  try {
    return bytesOfText(body);
  } catch {
    throw broken(WORDS.broken.cut);
  }
}

function broken(why: string): Error {
  return new Error(WORDS.broken.sentence(why));
}

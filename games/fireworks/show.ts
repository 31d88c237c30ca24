/**
 * Shows encoded as text for a URL: `2.` followed, in URL-safe base64, by a check byte and five bytes per shell. The
 * five bytes are a number of mixed radix with the digits, most significant first: time in tenths of a second, x, y, z,
 * kind, colour, power. Version 1, which had eight kinds, is read as well.
 */
import { FIREWORKS_SKY } from '@principia/scenes';
import type { Cue } from './sim.ts';

/** Largest number of shells of a show, and its last time, steps. */
export const MAX_CUES = 200;
export const LAST_TICK = 6 * 999;

/** Radix of each digit. Their product is below 2^40. */
const RADICES: Readonly<Record<string, readonly number[]>> = {
  1: [1024, 256, 128, 32, 8, 8, 16],
  2: [1000, 241, 127, 31, 9, 8, 16],
};
const VERSION = '2';
const BYTES = 5;
const TENTH = 6;
const STEP_X = 0.4;
const STEP_Y = 0.3;
const MAX_Z = 15;
const POWERS = 15;

const roundClamped = (value: number, low: number, high: number) => Math.min(high, Math.max(low, Math.round(value)));

/** The digits of a shell, most significant first. */
function digitsOf({ tick, x, y, z, kind, color, power }: Cue): number[] {
  const { halfWidth, lowest, highest } = FIREWORKS_SKY;
  return [
    roundClamped(tick / TENTH, 0, LAST_TICK / TENTH),
    roundClamped((x + halfWidth) / STEP_X, 0, (2 * halfWidth) / STEP_X),
    roundClamped((y - lowest) / STEP_Y, 0, Math.floor((highest - lowest) / STEP_Y)),
    roundClamped(z, -MAX_Z, MAX_Z) + MAX_Z,
    kind,
    color,
    roundClamped(power * POWERS, 0, POWERS),
  ];
}

function cueOf([tick, x, y, z, kind, color, power]: number[]): Cue {
  const { halfWidth, lowest } = FIREWORKS_SKY;
  return {
    tick: tick * TENTH,
    x: x * STEP_X - halfWidth,
    y: y * STEP_Y + lowest,
    z: z - MAX_Z,
    kind,
    color,
    power: power / POWERS,
  };
}

/** Rounds a shell to the resolution of the encoding. */
export function quantize(cue: Cue): Cue {
  return cueOf(digitsOf(cue));
}

function checkByte(bytes: Uint8Array, from: number): number {
  let check = 90;
  for (let i = from; i < bytes.length; i++) check = (31 * check + bytes[i] + 7) & 255;
  return check;
}

/** Encodes a show, in at most 1 340 characters. */
export function writeShow(cues: readonly Cue[]): string {
  const bytes = new Uint8Array(1 + BYTES * cues.length);
  for (const [i, cue] of cues.entries()) {
    let bits = digitsOf(cue).reduce((sum, value, digit) => sum * RADICES[VERSION][digit] + value, 0);
    for (let b = BYTES; b > 0; b--) {
      bytes[BYTES * i + b] = bits % 256;
      bits = Math.floor(bits / 256);
    }
  }
  bytes[0] = checkByte(bytes, 1);
  const text = btoa(String.fromCharCode(...bytes));
  return `${VERSION}.${text.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

/** Decodes a show. @throws Error with a sentence that says what is wrong with the text and what to do */
export function readShow(text: string): Cue[] {
  const [, version, body] = /^([^.]*)\.(.*)$/s.exec(text) ?? [];
  if (version === undefined || body === undefined) throw broken('it does not begin with a version, such as “2.”');
  if (!Object.hasOwn(RADICES, version)) {
    throw new Error(
      `The show in the address has version “${version.slice(0, 12)}”, but this game reads versions 1 and 2.`,
    );
  }
  const bytes = bytesOf(body);
  if ((bytes.length - 1) % BYTES !== 0) throw broken('its length is wrong');
  if (checkByte(bytes, 1) !== bytes[0]) throw broken('its checksum is wrong');
  const count = (bytes.length - 1) / BYTES;
  if (count > MAX_CUES)
    throw new Error(`The show in the address has ${count} shells, but at most ${MAX_CUES} are allowed.`);
  const cues = Array.from({ length: count }, (_, i) => unpack(bytes, 1 + BYTES * i, RADICES[version]));
  for (const [i, { tick }] of cues.entries()) {
    if (i > 0 && tick < cues[i - 1].tick) throw broken('its shells are not sorted by time');
  }
  return cues;
}

function unpack(bytes: Uint8Array, at: number, radices: readonly number[]): Cue {
  let bits = 0;
  for (let b = 0; b < BYTES; b++) bits = bits * 256 + bytes[at + b];
  const values: number[] = [];
  for (const radix of radices.toReversed()) {
    values.unshift(bits % radix);
    bits = Math.floor(bits / radix);
  }
  // A remainder cannot come from the encoder.
  if (bits > 0) throw broken('it contains an invalid time');
  return quantize(cueOf(values));
}

function bytesOf(body: string): Uint8Array {
  if (!/^[\w-]+$/.test(body)) throw broken('it contains invalid characters');
  try {
    const text = atob(body.replaceAll('-', '+').replaceAll('_', '/'));
    return Uint8Array.from(text, (character) => character.charCodeAt(0));
  } catch {
    throw broken('it was cut off');
  }
}

function broken(why: string): Error {
  return new Error(`The show in the address cannot be read because ${why}. Copy the whole link again.`);
}

import { TEXTURE_WIDTH } from '@principia/render-core';

/**
 * Length of an array for `count` items of `channels` numbers in whole texture rows: the present length if it suffices,
 * otherwise at least twice it.
 *
 * @throws Error when `count` is not a whole number from zero
 */
export function bufferLength(count: number, length: number, channels: number): number {
  checkCount(count);
  const needed = count * channels;
  if (length > 0 && needed <= length) return length;
  const row = TEXTURE_WIDTH * channels;
  return Math.max(1, Math.ceil(Math.max(needed, 2 * length) / row)) * row;
}

/** @throws Error when `count` is not a whole number from zero */
export function checkCount(count: number): void {
  if (Number.isInteger(count) && count >= 0) return;
  throw new Error(`the number of lines must be a whole number, 0 or more, got ${count}`);
}

/** Colours in the order of the rainbow, for many things of one kind. */
import { cos, rgba } from '@principia/physics';

/** A light colour as `Appearance.color` has it. @param share from 0, red, over green and blue to 1, violet */
export function rainbow(share: number): number {
  const [red, green, blue] = channels(share);
  return rgba(red, green, blue);
}

/** The same colour as pictures have it, 0xRRGGBB. */
export function rainbowColor(share: number): number {
  const [red, green, blue] = channels(share).map((value) => Math.round(255 * value));
  return (red << 16) | (green << 8) | blue;
}

function channels(share: number): number[] {
  return [0, 1, 2].map((i) => 0.62 + 0.38 * cos(2 * Math.PI * (0.8 * share - i / 3)));
}

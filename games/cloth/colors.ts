/** Colours of the cloth, from its upper edge (0) to its lower one (1), as red, green and blue from 0 to 1. */
import { SAFE_COLORS } from '@principia/shell';

type Rgb = readonly [red: number, green: number, blue: number];

/** Amber and rose; or orange and blue, which differ for every kind of colour vision. */
const USUAL: readonly [Rgb, Rgb] = [
  [1, 0.75, 0.35],
  [1, 0.32, 0.62],
];
const SAFE: readonly [Rgb, Rgb] = [rgbOf(SAFE_COLORS[0]), rgbOf(SAFE_COLORS[1])];

export function colorAt(depth: number, safeColors: boolean): Rgb {
  const [top, bottom] = safeColors ? SAFE : USUAL;
  const mix = (channel: 0 | 1 | 2) => top[channel] + (bottom[channel] - top[channel]) * depth;
  return [mix(0), mix(1), mix(2)];
}

function rgbOf(color: number): Rgb {
  return [((color >> 16) & 255) / 255, ((color >> 8) & 255) / 255, (color & 255) / 255];
}

/** Colours and shapes of the balls. */
import { rgba } from '@principia/physics';
import { SHAPES } from '@principia/render-core';
import type { BouncingBalls } from '@principia/scenes';

/** Palettes that look well on a deep blue; the seed chooses one. */
const PALETTES: readonly (readonly number[])[] = [
  [0xffc15e, 0xff7a59, 0xf9506b, 0xb45cf0, 0x5b8cff, 0x38d6c4],
  [0x7be0ad, 0x3bb3c2, 0x5b8cff, 0x9b7bff, 0xf27bd0, 0xffd166],
  [0xfff3b0, 0xffcf56, 0xff9f45, 0xff6b6b, 0xd84797, 0x7f5af0],
  [0x9bf6ff, 0xa0c4ff, 0xbdb2ff, 0xffc6ff, 0xffadad, 0xfdffb6],
];

/** Balls smaller than this carry no mark: nobody would see it, m. */
const SMALLEST_MARKED = 0.03;

/** Gives every ball a colour of the seed's palette, in an order that puts each colour everywhere. */
export function dress({ world, balls, radius }: BouncingBalls, seed: number): void {
  const { color, shape } = world.components.Appearance;
  const palette = PALETTES[seed % PALETTES.length].map(packed);
  const kind = radius < SMALLEST_MARKED ? SHAPES.disc : SHAPES.markedDisc;
  for (let i = 0; i < balls.length; i++) {
    // Multiples of the golden ratio spread evenly over the palette whatever the number of balls.
    color[balls[i]] = palette[Math.floor(((i * 0.618034 + seed * 0.37) % 1) * palette.length)];
    shape[balls[i]] = kind;
  }
  world.versions.style++;
}

function packed(rgb: number): number {
  return rgba((rgb >> 16) / 255, ((rgb >> 8) & 255) / 255, (rgb & 255) / 255);
}

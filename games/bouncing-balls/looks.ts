/** Colours and shapes of the balls. */
import { rgba } from '@principia/physics';
import { SHAPES } from '@principia/render-core';
import type { BouncingBalls } from '@principia/scenes';
import { SAFE_COLORS } from '@principia/shell';

/** Palettes that look well on a deep blue; the seed chooses one. */
const PALETTES: readonly (readonly number[])[] = [
  [0xffc15e, 0xff7a59, 0xf9506b, 0xb45cf0, 0x5b8cff, 0x38d6c4],
  [0x7be0ad, 0x3bb3c2, 0x5b8cff, 0x9b7bff, 0xf27bd0, 0xffd166],
  [0xfff3b0, 0xffcf56, 0xff9f45, 0xff6b6b, 0xd84797, 0x7f5af0],
  [0x9bf6ff, 0xa0c4ff, 0xbdb2ff, 0xffc6ff, 0xffadad, 0xfdffb6],
];

/** Balls smaller than this carry no mark: nobody would see it, m. */
const SMALLEST_MARKED = 0.06;

/** With more balls than this, colours follow the order of the launch, so that one sees who mixes with whom. */
const MOST_MOTLEY = 100;

/** Gives every ball a colour of the seed's palette, or of the one that everybody tells apart. */
export function dress({ world, balls, radius }: BouncingBalls, seed: number, safeColors = false): void {
  const { color, shape } = world.components.Appearance;
  const palette = safeColors ? SAFE_COLORS : PALETTES[seed % PALETTES.length];
  const kind = radius < SMALLEST_MARKED ? SHAPES.disc : SHAPES.markedDisc;
  for (let i = 0; i < balls.length; i++) {
    // Neighbours in a motley get unlike colours: multiples of the golden ratio spread evenly whatever their number.
    const place = balls.length > MOST_MOTLEY ? i / balls.length : (i * 0.618034) % 1;
    // A mixture of safe colours is no safe colour.
    color[balls[i]] = colorAt(
      palette,
      safeColors ? Math.round(place * (palette.length - 1)) / (palette.length - 1) : place,
    );
    shape[balls[i]] = kind;
  }
  world.versions.style++;
}

/** The colour at a place of the palette, 0 to 1, between its neighbours there. */
function colorAt(palette: readonly number[], place: number): number {
  const at = place * (palette.length - 1);
  const from = Math.floor(at);
  const share = at - from;
  const mix = (shift: number) => {
    const start = (palette[from] >> shift) & 255;
    return (start + (((palette[from + 1] >> shift) & 255) - start) * share) / 255;
  };
  return rgba(mix(16), mix(8), mix(0));
}

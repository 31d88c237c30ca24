/** Colours and shapes of the balls. */
import { rgba } from '@principia/physics';
import { SHAPES } from '@principia/render-core';
import type { BouncingBalls } from '@principia/scenes';
import { SAFE_COLORS } from '@principia/shell';

/** Palettes that suit a deep blue background; the seed selects one. */
const PALETTES: readonly (readonly number[])[] = [
  [0xffc15e, 0xff7a59, 0xf9506b, 0xb45cf0, 0x5b8cff, 0x38d6c4],
  [0x7be0ad, 0x3bb3c2, 0x5b8cff, 0x9b7bff, 0xf27bd0, 0xffd166],
  [0xfff3b0, 0xffcf56, 0xff9f45, 0xff6b6b, 0xd84797, 0x7f5af0],
  [0x9bf6ff, 0xa0c4ff, 0xbdb2ff, 0xffc6ff, 0xffadad, 0xfdffb6],
];

/** Smaller balls have no mark because it would be invisible, m. */
const MIN_MARKED_RADIUS = 0.06;

/** With more balls than this, colours follow the launch order, which shows how the balls mix. */
const MAX_MIXED = 100;

/** Gives every ball a colour of the seed's palette or of the colour-blind palette. */
export function applyColors({ world, balls, radius }: BouncingBalls, seed: number, safeColors = false): void {
  const { color, shape } = world.components.Appearance;
  const palette = safeColors ? SAFE_COLORS : PALETTES[seed % PALETTES.length];
  const kind = radius < MIN_MARKED_RADIUS ? SHAPES.disc : SHAPES.markedDisc;
  for (let i = 0; i < balls.length; i++) {
    // Multiples of the golden ratio are evenly spread for any count, so neighbours get different colours.
    const position = balls.length > MAX_MIXED ? i / balls.length : (i * 0.618034) % 1;
    // Mixed colours would not be colour-blind safe.
    color[balls[i]] = colorAt(
      palette,
      safeColors ? Math.round(position * (palette.length - 1)) / (palette.length - 1) : position,
    );
    shape[balls[i]] = kind;
  }
  world.versions.style++;
}

/** The interpolated colour at a position of the palette, 0 to 1. */
function colorAt(palette: readonly number[], position: number): number {
  const at = position * (palette.length - 1);
  const from = Math.floor(at);
  const share = at - from;
  const mix = (shift: number) => {
    const start = (palette[from] >> shift) & 255;
    return (start + (((palette[from + 1] >> shift) & 255) - start) * share) / 255;
  };
  return rgba(mix(16), mix(8), mix(0));
}

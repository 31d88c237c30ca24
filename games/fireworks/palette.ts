/** The colours of shells on the screen: those of metal salts, or a colour-blind palette of eight. */
import { STAR_COLORS, type StarColor } from '@principia/scenes';
import { SAFE_COLORS } from '@principia/shell';

const SAFE_COLOR_NAMES = [
  'orange',
  'sky blue',
  'bluish green',
  'yellow',
  'blue',
  'vermilion',
  'reddish purple',
  'white',
];

const safePalette: readonly StarColor[] = SAFE_COLORS.map((rgb, i) => ({ name: SAFE_COLOR_NAMES[i], rgb }));

export function paletteOf(isSafe: boolean): readonly StarColor[] {
  return isSafe ? safePalette : STAR_COLORS;
}

/** A colour in CSS notation. */
export function css({ rgb }: Pick<StarColor, 'rgb'>): string {
  return `#${rgb.toString(16).padStart(6, '0')}`;
}

/** The colours of shells as the player sees them: those of the salts, or eight that everybody tells apart. */
import { STAR_COLORS, type StarColor } from '@principia/scenes';
import { SAFE_COLORS } from '@principia/shell';

const SAFE_NAMES = ['orange', 'sky blue', 'bluish green', 'yellow', 'blue', 'vermilion', 'reddish purple', 'white'];

const safePalette: readonly StarColor[] = SAFE_COLORS.map((rgb, i) => ({ name: SAFE_NAMES[i], rgb }));

export function paletteOf(isSafe: boolean): readonly StarColor[] {
  return isSafe ? safePalette : STAR_COLORS;
}

/** A colour as style sheets write it. */
export function css({ rgb }: Pick<StarColor, 'rgb'>): string {
  return `#${rgb.toString(16).padStart(6, '0')}`;
}

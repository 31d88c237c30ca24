/** The colours of shells on the screen: those of metal salts, or a colour-blind palette of eight. */
import { STAR_COLORS, type StarColor } from '@principia/scenes';
import { SAFE_COLORS } from '@principia/shell';
import { WORDS } from './words.ts';

const palette: readonly StarColor[] = STAR_COLORS.map(({ rgb }, i) => ({ name: WORDS.colors[i], rgb }));
const safePalette: readonly StarColor[] = SAFE_COLORS.map((rgb, i) => ({ name: WORDS.safeColors[i], rgb }));

export function paletteOf(isSafe: boolean): readonly StarColor[] {
  return isSafe ? safePalette : palette;
}

/** A colour in CSS notation. */
export function css({ rgb }: Pick<StarColor, 'rgb'>): string {
  return `#${rgb.toString(16).padStart(6, '0')}`;
}

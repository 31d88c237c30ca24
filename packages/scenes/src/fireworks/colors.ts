// Colours of stars and the salts or metals that produce them.
import { rgba } from '@principia/physics';

/** A colour of stars. */
export interface StarColor {
  /** The colour, and what makes it. */
  readonly name: string;
  /** 0xRRGGBB. */
  readonly rgb: number;
}

/** The colours of stars; shells name them by index. */
export const STAR_COLORS: readonly StarColor[] = [
  { name: 'red (strontium)', rgb: 0xff3b30 },
  { name: 'orange (calcium)', rgb: 0xff8a1f },
  { name: 'yellow (sodium)', rgb: 0xffd94a },
  { name: 'green (barium)', rgb: 0x3dff6e },
  { name: 'blue (copper)', rgb: 0x3f7bff },
  { name: 'violet (strontium and copper)', rgb: 0xb45cff },
  { name: 'silver (magnesium)', rgb: 0xdfe9ff },
  { name: 'gold (charcoal)', rgb: 0xffb04a },
];

/** The same colours as 0xRRGGBB. */
export const STAR_RGB: readonly number[] = STAR_COLORS.map(({ rgb }) => rgb);

/** Colour of a star over its life: nearly white, its colour, then fading. */
export function colorRamp(rgb: number, hot = 0.45): number[] {
  const mixed = (white: number, strength: number, alpha: number) => {
    const part = (shift: number) =>
      strength * (((rgb >> shift) & 255) / 255 + white * (1 - ((rgb >> shift) & 255) / 255));
    return rgba(part(16), part(8), part(0), alpha);
  };
  return [mixed(hot, 1, 0.8), mixed(0.08, 1, 1), mixed(0, 0.85, 0.8), mixed(0, 0.5, 0.02)];
}

import { checkNumber } from '../errors/validate.ts';
import { defineComponent, real, u32 } from './define.ts';

/** The appearance of a body, which only renderers read. */
export const Appearance = defineComponent({
  visual: true,
  scalar: 'color',
  fields: {
    /** RGBA bytes in memory order, 0xAABBGGRR; zero is the renderer's default colour. See `rgba`. */
    color: u32('', {}),
    /** Kind of shape, see the renderers' SHAPES; 0 is a disc or ball. */
    shape: u32('', {}),
    /** Drawn radius, metres; zero draws the collider. */
    size: real('m', { bounds: { min: 0, max: 1e12 } }),
  },
});

/**
 * Packs a colour for `Appearance.color`: red, green, blue and alpha from 0 to 1, clamped. Transparent black is packed as
 * 1, which is as invisible, because 0 stands for the renderer's default colour.
 * @throws PhysicsError E_TYPE, E_NONFINITE
 */
export function rgba(red: number, green: number, blue: number, alpha = 1): number {
  const byte = (value: number) => Math.round(Math.min(1, Math.max(0, checkNumber(value, 'rgba'))) * 255);
  return ((byte(alpha) << 24) | (byte(blue) << 16) | (byte(green) << 8) | byte(red)) >>> 0 || 1;
}

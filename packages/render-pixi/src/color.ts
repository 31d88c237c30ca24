/**
 * Writes a colour such as `0x4f9dde` (red, green, blue) into `out` as four numbers from 0 to 1, not premultiplied.
 *
 * @throws Error when the colour is not a whole number from 0 to 0xffffff or the opacity not within 0 … 1
 */
export function writeColor(out: Float32Array, rgb: number, opacity = 1): void {
  if (!Number.isInteger(rgb) || rgb < 0 || rgb > 0xffffff) {
    throw new Error(`a colour must be a number from 0x000000 to 0xffffff, got ${rgb}`);
  }
  if (!(opacity >= 0 && opacity <= 1)) throw new Error(`opacity must be a number from 0 to 1, got ${opacity}`);
  out[0] = (rgb >> 16) / 255;
  out[1] = ((rgb >> 8) & 255) / 255;
  out[2] = (rgb & 255) / 255;
  out[3] = opacity;
}

import { Color, type ColorRepresentation, SRGBColorSpace } from 'three';

/** A colour of three (`0xrrggbb`, a CSS name, a `Color`) as opaque RGBA bytes in memory order. */
export function colorBytes(color: ColorRepresentation): number {
  const hex = new Color(color).getHex(SRGBColorSpace);
  return (0xff000000 | ((hex & 0xff) << 16) | (hex & 0xff00) | (hex >> 16)) >>> 0;
}

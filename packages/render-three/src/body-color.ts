import { Color, type ColorRepresentation, SRGBColorSpace } from 'three';

/** Converts a colour of three.js (`0xrrggbb`, a CSS name, a `Color`) to opaque RGBA bytes in memory order. */
export function colorBytes(color: ColorRepresentation): number {
  const hex = new Color(color).getHex(SRGBColorSpace);
  return (0xff000000 | ((hex & 0xff) << 16) | (hex & 0xff00) | (hex >> 16)) >>> 0;
}

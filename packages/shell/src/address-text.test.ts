import { expect, it } from 'vitest';
import { bytesOfText, packText, textOfBytes, unpackText } from './address-text.ts';

it('writes all bytes in letters that addresses may have, and reads them', () => {
  for (const length of [0, 1, 2, 3, 256]) {
    const bytes = Uint8Array.from({ length }, (_, i) => 255 - i);
    const text = textOfBytes(bytes);
    expect(text).toMatch(/^[\w-]*$/);
    expect(bytesOfText(text)).toEqual(bytes);
  }
});

it('packs a long text into less, and gives it back with every letter', async () => {
  const text = 'const μ = 1; // ½ Größe 🎆\n'.repeat(5000);
  const packed = await packText(text);
  expect(packed.length).toBeLessThan(text.length / 50);
  expect(await unpackText(packed)).toBe(text);
});

it.each(['x', 'ß', 'AAAA', '!'])('refuses %s, which was not packed', async (text) => {
  await expect(unpackText(text)).rejects.toThrow();
});

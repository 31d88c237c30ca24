import { afterEach, expect, test, vi } from 'vitest';
import { decodeHex } from './decode.ts';

const noise = (length: number) => Uint8Array.from({ length }, (_, i) => Math.imul(i * i + 12345, 0x9e3779b1) >>> 24);

afterEach(() => {
  vi.unstubAllGlobals();
});

test.each([0, 1, 3, 4, 5, 8, 100_001])('%i bytes survive the round trip', (length) => {
  const bytes = noise(length);
  expect(decodeHex(Buffer.from(bytes).toString('hex'))).toEqual(bytes);
});

test('uses the decoder of the engine if there is one', () => {
  const fromHex = vi.fn(() => Uint8Array.of(7));
  vi.stubGlobal('Uint8Array', Object.assign(Uint8Array.bind(undefined), { fromHex }));
  expect(decodeHex('07')).toEqual(Uint8Array.of(7));
  expect(fromHex).toHaveBeenCalledExactlyOnceWith('07');
});

test('an engine that cannot gets the same bytes from the digits', () => {
  vi.stubGlobal('Uint8Array', Object.assign(Uint8Array.bind(undefined), { fromHex: undefined }));
  expect(decodeHex('00ff10')).toEqual(Uint8Array.of(0, 255, 16));
});

import { afterEach, expect, test, vi } from 'vitest';
import { decodeBase64 } from './decode.ts';

const noise = (length: number) => Uint8Array.from({ length }, (_, i) => Math.imul(i * i + 12345, 0x9e3779b1) >>> 24);

afterEach(() => {
  vi.unstubAllGlobals();
});

test.each([0, 1, 2, 3, 4, 5, 100_000])('%i bytes survive the round trip', (length) => {
  const bytes = noise(length);
  expect(decodeBase64(Buffer.from(bytes).toString('base64'))).toEqual(bytes);
});

test('uses the base64 decoder of the engine if there is one', () => {
  const fromBase64 = vi.fn(() => Uint8Array.of(7));
  vi.stubGlobal('Uint8Array', Object.assign(Uint8Array.bind(undefined), { fromBase64 }));
  expect(decodeBase64('Bw==')).toEqual(Uint8Array.of(7));
  expect(fromBase64).toHaveBeenCalledExactlyOnceWith('Bw==');
});

test('an engine that cannot gets the same bytes through atob', () => {
  vi.stubGlobal('Uint8Array', Object.assign(Uint8Array.bind(undefined), { fromBase64: undefined }));
  expect(decodeBase64('AP8Q')).toEqual(Uint8Array.of(0, 255, 16));
});

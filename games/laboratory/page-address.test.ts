import { afterEach, expect, it, vi } from 'vitest';
import { writeAddress } from './page-address.ts';

afterEach(() => vi.unstubAllGlobals());

const SETTINGS = {
  gravity: { kind: 'number', label: 'Gravity', unit: 'm/s²', initial: 9.81, min: 0, max: 30, integer: false },
} as const;

/** The address that stands after one was opened and written anew. */
function written(opened: string, gravity: number, seed: number): string {
  let address = new URL(opened, 'https://example.org/laboratory/');
  vi.stubGlobal('location', address);
  vi.stubGlobal('history', {
    replaceState: (_state: unknown, _title: string, to: string) => {
      address = new URL(to, address);
    },
  });
  writeAddress('ch01', SETTINGS, { gravity }, seed);
  return address.search + address.hash;
}

it('writes what differs from the example, and drops the moment', () => {
  expect(written('?example=ch01&step=9&camera=0,0,5', 9.81, 1)).toBe('?example=ch01');
  expect(written('?example=ch01&manual', 1.6, 7)).toBe('?example=ch01&gravity=1.6&seed=7&manual=');
});

it('leaves the code that a link brings where it is, so that a reload and a bookmark bring it again', () => {
  expect(written('?example=ch01#code=q1Yq', 1.6, 1)).toBe('?example=ch01&gravity=1.6#code=q1Yq');
});

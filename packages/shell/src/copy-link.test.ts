import { afterEach, expect, it, vi } from 'vitest';
import { copyLink } from './copy-link.ts';

afterEach(() => vi.unstubAllGlobals());

it.each([
  ['?lang=de&seed=4', 'https://example.org/game/?seed=4#part', 'https://example.org/game/?seed=4&lang=de#part'],
  ['?lang=de', 'https://example.org/game/#part', 'https://example.org/game/?lang=de#part'],
  ['?lang=de', 'https://example.org/game/?lang=de#part', 'https://example.org/game/?lang=de#part'],
  ['?seed=4', 'https://example.org/game/?seed=4#part', 'https://example.org/game/?seed=4#part'],
])('where the clipboard refuses, a page at %s keeps its language with %s', async (search, link, shown) => {
  const addresses: string[] = [];
  vi.stubGlobal('location', { search });
  vi.stubGlobal('history', { replaceState: (_: unknown, _title: string, address: string) => addresses.push(address) });
  vi.stubGlobal('navigator', { clipboard: { writeText: () => Promise.reject(new Error('refused')) } });
  await copyLink(link, 'this game');
  expect(addresses).toEqual([shown]);
});

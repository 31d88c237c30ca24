import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { carryCode, isNameable, momentAddress, momentOf, takeMoment } from './moment.ts';
import { codeHash, linkedCode } from './own-code.ts';

const ADDRESS = 'https://example.org/laboratory/?example=ch01';

function reach(tick: number): void {
  vi.stubGlobal('__game', { state: () => ({ tick }) });
}

beforeEach(() => vi.stubGlobal('location', new URL(ADDRESS)));
afterEach(() => {
  vi.unstubAllGlobals();
  carryCode('');
});

const take = (text: string, dimensions: 2 | 3) => takeMoment(new URLSearchParams(text), dimensions);

it('names the step', () => {
  reach(54);
  expect(momentAddress()).toBe(`${ADDRESS}&step=54`);
});

it('carries the code that the reader runs', async () => {
  reach(54);
  const source = "export default defineExample({ title: 'Mine – größer' });";
  carryCode(await codeHash(source));
  const { search, hash } = new URL(momentAddress());
  expect(search).toBe('?example=ch01&step=54');
  expect(await linkedCode(hash)).toBe(source);
});

it('names no step that opening would refuse', () => {
  for (const [tick, isRight] of [
    [200_000, true],
    [200_001, false],
  ] as const) {
    reach(tick);
    expect(isNameable()).toBe(isRight);
    const { searchParams } = new URL(momentAddress());
    expect(searchParams.has('step')).toBe(isRight);
    expect(take(searchParams.toString(), 2).problems).toEqual([]);
  }
});

it('refuses a camera that looks nowhere', () => {
  expect(take('camera=0,0,0,0,0,0', 3)).toMatchObject({ camera: undefined, problems: [expect.any(String)] });
  expect(take('camera=0,0,5,0,0,0', 3)).toMatchObject({ camera: [0, 0, 5, 0, 0, 0], problems: [] });
  expect(take('camera=0,0,0', 2)).toMatchObject({ camera: undefined, problems: [expect.any(String)] });
});

it('finds the part of an address that names its moment', () => {
  expect(momentOf(new URLSearchParams('example=ch01&step=54&camera=0,0,5&seed=2'))).toBe('step=54&camera=0,0,5');
  expect(momentOf(new URLSearchParams('example=ch01'))).toBe('');
});

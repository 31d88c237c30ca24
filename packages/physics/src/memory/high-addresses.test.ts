// WebAssembly returns addresses as signed numbers. The memory here is larger than 2 GiB, but the system lends only the pages written.
import { expect, it } from 'vitest';
import { instantiateKernels } from '../kernels/instantiate.ts';
import { clearMemory, PAGE_BYTES, seekPage } from './arena.ts';

const HALF = 2 ** 31;
const WASM_PAGE = 65536;
const memory = new WebAssembly.Memory({ initial: HALF / WASM_PAGE + 1, maximum: HALF / WASM_PAGE + 1 });
const { findPage } = instantiateKernels('f64', memory);
const bytes = new Uint8Array(memory.buffer);
const [from, to] = [HALF - WASM_PAGE, HALF + WASM_PAGE];

it('finds pages beyond 2 GiB', () => {
  const page = HALF + 2 * PAGE_BYTES;
  bytes[page + 5] = 1;
  expect(seekPage(findPage, from, to, 'used')).toBe(page);
  expect(seekPage(findPage, page, to, 'zero')).toBe(page + PAGE_BYTES);
  bytes[page + 5] = 0;
  expect(seekPage(findPage, from, to, 'used')).toBe(to);
});

it('clears memory beyond 2 GiB, and that alone', () => {
  const inside = [from + 1, HALF - 1, HALF, HALF + 3 * PAGE_BYTES, to - 20];
  const outside = [from - 1, to - 1];
  for (const at of [...inside, ...outside]) bytes[at] = 7;
  clearMemory(memory, findPage, from, to - 10);
  expect(inside.map((at) => bytes[at])).toEqual(inside.map(() => 0));
  expect(outside.map((at) => bytes[at])).toEqual([7, 7]);
});

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { buildKernels } from '../../scripts/build-kernels.mjs';
import { kernelInterface } from '../../scripts/lib/compile-kernels.mjs';

let folder: string;
const write = (text: string) => writeFileSync(join(folder, 'index.ts'), text);
const build = () => buildKernels({ quiet: true, from: folder, to: join(folder, 'generated.txt') });

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'principia-kernels-test-'));
});

afterEach(() => rmSync(folder, { recursive: true, force: true }));

test('types the exported kernels, and compiles again only when a source changed', async () => {
  write('export function kick(v: usize, dt: real, seed: u64): bool { return load<real>(v) > dt; }\n');
  expect(await build()).toBe(true);
  const generated = readFileSync(join(folder, 'generated.txt'), 'utf8');
  expect(generated).toContain('index/kick(v: usize, dt: real, seed: u64): bool */');
  expect(generated).toContain('kick(v: number, dt: number, seed: bigint): number;');
  expect(await build()).toBe(false);
}, 60_000);

test('a kernel that does not compile is named with file, line and column', async () => {
  write('\nexport function kick(): void { store<real>(missing, 0); }\n');
  await expect(build()).rejects.toThrow(/did not compile for f(32|64) at \S*index\.ts:2:44/);
}, 60_000);

test('an exported kernel takes every argument', () => {
  const compiled = {
    wasm: new Uint8Array(),
    declarations: '/** index/kick */\nexport function kick(n?: number): void;',
  };
  expect(() => kernelInterface({ f32: compiled, f64: compiled })).toThrow(/index\/kick has a default parameter/);
});

test('a missing entry file is said plainly', async () => {
  await expect(build()).rejects.toThrow(/index\.ts is missing/);
});

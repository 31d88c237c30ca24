import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { buildKernels } from '../../scripts/build-kernels.mjs';
import { kernelInterface } from '../../scripts/lib/compile-kernels.mjs';

let folder: string;
let generated: string;
const write = (text: string) => writeFileSync(join(folder, 'index.ts'), text);
const build = () => buildKernels({ quiet: true, from: folder, to: generated });

beforeEach(() => {
  const home = mkdtempSync(join(tmpdir(), 'principia-kernels-test-'));
  folder = join(home, 'kernels');
  generated = join(home, 'generated');
  mkdirSync(folder);
});

afterEach(() => rmSync(join(folder, '..'), { recursive: true, force: true }));

test('types the exported kernels, and compiles again only when a source changed', async () => {
  write('export function kick(v: usize, dt: real, seed: u64): bool { return load<real>(v) > dt; }\n');
  expect(await build()).toBe(true);
  const text = readFileSync(join(generated, 'modules.gen.ts'), 'utf8');
  expect(text).toContain('index/kick(v: usize, dt: real, seed: u64): bool */');
  expect(text).toContain('kick(v: number, dt: number, seed: bigint): number;');
  expect(await build()).toBe(false);
}, 60_000);

test('every feature folder with a module.ts becomes a module of its own', async () => {
  write('export function core(): i32 { return 1; }\n');
  mkdirSync(join(folder, 'springs'));
  writeFileSync(join(folder, 'springs', 'module.ts'), 'export function stretch(): i32 { return 2; }\n');
  expect(await build()).toBe(true);
  const read = (name: string) => readFileSync(join(generated, name), 'utf8');
  expect(read('springs.gen.ts')).toContain('stretch(): number;');
  expect(read('modules.gen.ts')).not.toContain('stretch');
}, 60_000);

test('a kernel that does not compile is named with file, line and column', async () => {
  write('\nexport function kick(): void { store<real>(missing, 0); }\n');
  await expect(build()).rejects.toThrow(/did not compile for f(32|64) at \S*index\.ts:2:44/);
}, 60_000);

test('constants of a feature that reach into those of the next do not compile', async () => {
  write('export function core(): i32 { return 1; }\n');
  mkdirSync(join(folder, 'springs'));
  const use = 'export function at(): usize { return memory.data(300, 16); }\n';
  writeFileSync(join(folder, 'springs', 'module.ts'), use);
  await expect(build()).rejects.toThrow(/limit exceeded by static data/);
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

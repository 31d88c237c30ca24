import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { buildKernels } from '../../scripts/build-kernels.mjs';
import { kernelInterface } from '../../scripts/lib/compile-kernels.mjs';

let folder: string;
let generated: string;
const write = (text: string) => writeFileSync(join(folder, 'index.ts'), text);
const read = (name: string) => readFileSync(join(generated, name), 'utf8');
const bytesOf = (name: string) => Buffer.from(read(name).match(/BASE64 = '([^']+)'/)?.[1] ?? '', 'base64');
const writeModule = (name: string, text: string) => {
  mkdirSync(join(folder, name));
  writeFileSync(join(folder, name, 'module.ts'), text);
};
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
  const text = read('core.gen.ts');
  expect(text).toContain('index/kick(v: usize, dt: real, seed: u64): bool */');
  expect(text).toContain('kick(v: number, dt: number, seed: bigint): number;');
  expect(await build()).toBe(false);
}, 60_000);

test('every feature folder with a module.ts becomes a module of its own, with a build for each precision', async () => {
  write('export function core(): i32 { return 1; }\n');
  writeModule('springs', 'export function stretch(): i32 { return sizeof<real>(); }\n');
  expect(await build()).toBe(true);
  expect(read('springs.gen.ts')).toContain('stretch(): number;');
  expect(read('springs.gen.ts')).toContain("from '#f32/springs'");
  expect(read('core.gen.ts')).not.toContain('stretch');
  for (const [precision, size] of Object.entries({ f32: 4, f64: 8 })) {
    const imports = { env: { memory: new WebAssembly.Memory({ initial: 1 }) } };
    const module = new WebAssembly.Module(bytesOf(`${precision}/springs.gen.ts`));
    const { exports } = new WebAssembly.Instance(module, imports);
    expect((exports.stretch as () => number)()).toBe(size);
  }
}, 60_000);

test('elementary functions have one build, in which real is unknown', async () => {
  write('export function core(): i32 { return 1; }\n');
  writeModule('math', 'export function half(x: f64): f64 { return x / 2; }\n');
  expect(await build()).toBe(true);
  expect(existsSync(join(generated, 'f32/math.gen.ts'))).toBe(false);
  expect(read('math.gen.ts')).toContain('{ f32: BASE64, f64: BASE64 }');
  expect(WebAssembly.validate(bytesOf('math.gen.ts'))).toBe(true);
  writeFileSync(join(folder, 'math', 'module.ts'), 'export function half(x: real): real { return x / 2; }\n');
  await expect(build()).rejects.toThrow(/math\/module\.ts/);
}, 60_000);

test('the files of a module that is gone go too', async () => {
  write('export function core(): i32 { return 1; }\n');
  writeModule('springs', 'export function stretch(): i32 { return 2; }\n');
  await build();
  rmSync(join(folder, 'springs'), { recursive: true });
  await build();
  expect(existsSync(join(generated, 'f64/springs.gen.ts'))).toBe(false);
  expect(existsSync(join(generated, 'f64/core.gen.ts'))).toBe(true);
}, 60_000);

test('a kernel that does not compile is named with file, line and column', async () => {
  write('\nexport function kick(): void { store<real>(missing, 0); }\n');
  await expect(build()).rejects.toThrow(/did not compile for f(32|64) at \S*index\.ts:2:44/);
}, 60_000);

test('constants of a feature that reach into those of the next do not compile', async () => {
  write('export function core(): i32 { return 1; }\n');
  writeModule('springs', 'export function at(): usize { return memory.data(300, 16); }\n');
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

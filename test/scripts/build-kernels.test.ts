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
const bytesOf = (name: string) => Buffer.from(read(name).match(/HEX = '([^']+)'/)?.[1] ?? '', 'hex');
const writeModule = (name: string, text: string) => {
  mkdirSync(join(folder, name));
  writeFileSync(join(folder, name, 'module.ts'), text);
};
const writeMap = (ranges: Record<string, number>) => {
  const lines = Object.entries(ranges).map(([name, start]) => `export const ${name}: usize = ${start};\n`);
  mkdirSync(join(folder, 'memory'), { recursive: true });
  writeFileSync(join(folder, 'memory/low-memory-map.ts'), lines.join(''));
};
const build = () => buildKernels({ quiet: true, from: folder, to: generated });

beforeEach(() => {
  const home = mkdtempSync(join(tmpdir(), 'principia-kernels-test-'));
  folder = join(home, 'kernels');
  generated = join(home, 'generated');
  mkdirSync(folder);
  writeMap({
    COLUMN_TABLE: 64,
    CORE_CONSTANTS: 512,
    MATH_CONSTANTS: 1024,
    SPRINGS_CONSTANTS: 1280,
    FIRST_COLUMN: 1536,
  });
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

test('compiles only the modules that a change concerns', async () => {
  write('export function core(): i32 { return 1; }\n');
  writeModule('springs', "import { length } from './length';\nexport function stretch(): i32 { return length(); }\n");
  writeFileSync(join(folder, 'springs', 'length.ts'), 'export function length(): i32 { return 2; }\n');
  expect(await build()).toBe(true);
  const [core, springs] = ['f64/core.gen.ts', 'f64/springs.gen.ts'].map(read);
  writeFileSync(join(folder, 'springs', 'length.ts'), 'export function length(): i32 { return 3; }\n');
  expect(await build()).toBe(true);
  expect(read('f64/core.gen.ts')).toBe(core);
  expect(read('f64/springs.gen.ts')).not.toBe(springs);
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
  expect(read('math.gen.ts')).toContain('{ f32: HEX, f64: HEX }');
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

test('the map of low memory ascends, and has a range for each module', async () => {
  write('export function core(): i32 { return 1; }\n');
  writeModule('springs', 'export function stretch(): i32 { return 2; }\n');
  writeMap({ COLUMN_TABLE: 64, CORE_CONSTANTS: 512, FIRST_COLUMN: 1536 });
  await expect(build()).rejects.toThrow(/The module springs has no range: add SPRINGS_CONSTANTS/);
  writeMap({ COLUMN_TABLE: 64, CORE_CONSTANTS: 512, SPRINGS_CONSTANTS: 512, FIRST_COLUMN: 1536 });
  await expect(build()).rejects.toThrow(/SPRINGS_CONSTANTS is 512, but must be a multiple of 16 and at least 528/);
  writeMap({ COLUMN_TABLE: 0, FIRST_COLUMN: 1536 });
  await expect(build()).rejects.toThrow(/COLUMN_TABLE is 0, but must be a multiple of 16 and at least 64/);
  writeMap({ COLUMN_TABLE: 64, CORE_CONSTANTS: 512, SPRINGS_CONSTANTS: 1024 });
  await expect(build()).rejects.toThrow(/FIRST_COLUMN must be the last range/);
});

test('TypeScript gets the layouts of exported records, and the addresses', async () => {
  write('export function core(): i32 { return 1; }\n');
  mkdirSync(join(folder, 'bodies'));
  const fields = ['ids: usize', 'mass: f64', 'count: i32'].map((field) => `  ${field};\n`).join('');
  const real = '@unmanaged\nexport class Ball {\n  x: real;\n  id: i32;\n}\n';
  const own = '@unmanaged\nclass Own {\n  x: f64;\n}\n';
  writeFileSync(join(folder, 'bodies/list.ts'), `@unmanaged\nexport class List {\n${fields}}\n\n${real}\n${own}`);
  await build();
  const text = readFileSync(join(generated, '../memory/layouts.gen.ts'), 'utf8');
  expect(text).toContain('export const FIRST_COLUMN = 1536;');
  expect(text).toContain('export const LIST_BYTES = 24;');
  expect(text).toContain('export const enum ListWord {\n  ids = 0,\n  count = 4,\n}');
  expect(text).toContain('export const enum ListNumber {\n  mass = 1,\n}');
  expect(text).toContain('export const BALL_BYTES = { f32: 8, f64: 16 } as const;');
  expect(text).not.toContain('OWN_BYTES');
}, 60_000);

test('a record that does not fit where the map puts it does not compile', async () => {
  write('export function core(): i32 { return 1; }\n');
  mkdirSync(join(folder, 'bodies'));
  const fields = Array.from({ length: 57 }, (_, i) => `  x${i}: f64;\n`).join('');
  writeFileSync(join(folder, 'bodies/columns.ts'), `@unmanaged\nexport class Columns {\n${fields}}\n`);
  await expect(build()).rejects.toThrow(/The class Columns takes 456 bytes, but COLUMN_TABLE reaches from 64 to 512/);
}, 60_000);

test('an exported kernel takes every argument', () => {
  const compiled = {
    wasm: new Uint8Array(),
    declarations: '/** index/kick */\nexport function kick(n?: number): void;',
  };
  expect(() => kernelInterface({ f32: compiled, f64: compiled })).toThrow(/index\/kick has a default parameter/);
});

test('an exported kernel has at most eight parameters', () => {
  const parameters = Array.from({ length: 9 }, (_, i) => `p${i}: number`).join(', ');
  const declarations = `/** index/kick */\nexport function kick(${parameters}): void;`;
  const compiled = { wasm: new Uint8Array(), declarations };
  expect(() => kernelInterface({ f32: compiled, f64: compiled })).toThrow(/index\/kick has more than 8 parameters/);
});

test('a missing entry file is said plainly', async () => {
  await expect(build()).rejects.toThrow(/index\.ts is missing/);
});

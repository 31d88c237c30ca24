/** Runs the AssemblyScript compiler over the kernels, once for each precision, and reads what it exports. */
import { execFile } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { promisify } from 'node:util';
import { padBodySizes } from './body-sizes.mjs';
import { orderLocals } from './order-locals.mjs';
import { orderTypes } from './order-types.mjs';
import { cacheFolder, resolveInstalled } from './paths.mjs';

const run = promisify(execFile);

/** No garbage collector, no checks; the comments in `docs/` say why. */
export const compilerFlags = [
  '--runtime stub',
  '--enable simd',
  '--noAssert',
  '--use abort=',
  '--bindings raw',
].flatMap((flag) => flag.split(' '));

/**
 * Modules that the compiler leaves as they are written, for Binaryen's optimizer to do less than the compiler asks of it:
 * it makes no locals of what is computed twice, which the engine sees by itself, and of which the two precisions have
 * different ones. That takes 1.4 KB less of a game with contacts, and up to 2 % longer.
 */
const LEAN = ['index.ts', 'collision/module.ts', 'emitters/module.ts'];

/** Small functions are inlined as the compiler has them inlined, with loops too. */
const LEAN_FLAGS = [
  '-O2 --optimize-level 3 --inline-functions-with-loops --partial-inlining-ifs 4',
  '--always-inline-max-function-size 12 --flexible-inline-max-function-size 70 --one-caller-inline-max-function-size 200',
  '--enable-simd --enable-bulk-memory --enable-sign-ext --enable-mutable-globals --enable-nontrapping-float-to-int',
].flatMap((flags) => flags.split(' '));

/** Modules that are not worth code that is unrolled and inlined: what they do waits for divisions. */
const SHORT = ['math/module.ts'];

/**
 * @typedef {{ wasm: Uint8Array, declarations: string }} CompiledKernels
 * @typedef {{ start: number, end: number }} Room addresses in a world's memory, which modules share
 * @param {string} folder the folder of the kernels
 * @param {string} entry the module in it
 * @param {Room} constants where its constants go; more than fit there do not compile
 * @returns {Promise<{ f32: CompiledKernels, f64: CompiledKernels }>}
 */
export async function compileKernels(folder, entry, constants) {
  mkdirSync(cacheFolder, { recursive: true });
  const output = mkdtempSync(`${cacheFolder}/kernels-`);
  try {
    const [f32, f64] = await Promise.all([
      compileKernel(folder, entry, 'f32', output, constants),
      compileKernel(folder, entry, 'f64', output, constants),
    ]);
    return packable(f32, f64);
  } finally {
    rmSync(output, { recursive: true, force: true });
  }
}

/**
 * @param {CompiledKernels} f32
 * @param {CompiledKernels} f64
 */
function packable(f32, f64) {
  const ordered = orderTypes(orderLocals(f64.wasm), orderLocals(f32.wasm));
  return {
    f32: { ...f32, wasm: padBodySizes(ordered.f32) },
    f64: { ...f64, wasm: padBodySizes(ordered.f64) },
  };
}

/**
 * A module of its own, with memory of its own.
 * @param {string} folder
 * @param {string} entry
 * @param {number} pages of its memory
 * @returns {Promise<Uint8Array>}
 */
export async function compileAlone(folder, entry, pages) {
  mkdirSync(cacheFolder, { recursive: true });
  const output = mkdtempSync(`${cacheFolder}/kernels-`);
  try {
    const flags = ['-O3', '--initialMemory', String(pages), '--shrinkLevel', '1'];
    return (await compile(folder, entry, 'f32', output, flags)).wasm;
  } finally {
    rmSync(output, { recursive: true, force: true });
  }
}

/**
 * @param {string} folder
 * @param {string} entry
 * @param {'f32' | 'f64'} real
 * @param {string} output
 * @param {Room} constants
 * @returns {Promise<CompiledKernels>}
 */
async function compileKernel(folder, entry, real, output, { start, end }) {
  const flags = ['--importMemory', '--memoryBase', String(start), '--lowMemoryLimit', String(end)];
  if (SHORT.includes(entry)) flags.push('--shrinkLevel', '1');
  if (!LEAN.includes(entry)) return compile(folder, entry, real, output, ['-O3', ...flags]);
  const { declarations } = await compile(folder, entry, real, output, ['-O0', ...flags]);
  const file = `${output}/${real}.wasm`;
  await run(process.execPath, [optimizer(), file, '-o', file, ...LEAN_FLAGS]);
  return { wasm: readFileSync(file), declarations };
}

/** The optimizer of the Binaryen that the compiler itself uses. */
function optimizer() {
  return createRequire(resolveInstalled('assemblyscript/package.json')).resolve('binaryen/bin/wasm-opt');
}

/**
 * @param {string} folder
 * @param {string} entry
 * @param {'f32' | 'f64'} real
 * @param {string} output
 * @param {string[]} flags
 * @returns {Promise<CompiledKernels>}
 */
async function compile(folder, entry, real, output, flags) {
  const compiler = resolveInstalled('assemblyscript/bin/asc.js');
  const file = `${output}/${real}.wasm`;
  const args = [
    `${folder}/${entry}`,
    '--baseDir',
    folder,
    '--outFile',
    file,
    '--use',
    `real=${real}`,
    ...compilerFlags,
    ...flags,
  ];
  try {
    // The compiler starts itself a second time unless source maps are already enabled.
    await run(process.execPath, ['--enable-source-maps', compiler, ...args], { cwd: folder, maxBuffer: 1 << 26 });
  } catch (error) {
    throw new Error(describeFailure(/** @type {{ stderr?: string, message: string }} */ (error), folder, real));
  }
  return { wasm: readFileSync(file), declarations: readFileSync(`${output}/${real}.d.ts`, 'utf8') };
}

/**
 * Turns `└─ in broad-phase/grid.ts(8,45)` into a path with line and column that editors and terminals can open.
 * @param {{ stderr?: string, message: string }} error
 * @param {string} folder
 * @param {string} real
 */
function describeFailure(error, folder, real) {
  const shown = folder.startsWith(process.cwd()) ? folder.slice(process.cwd().length + 1) : folder;
  const report = (error.stderr || error.message)
    .replace(/\bin (\S+\.ts)\((\d+),(\d+)\)/g, `in ${shown}/$1:$2:$3`)
    .trim();
  const places = [...report.matchAll(/\bin (\S+\.ts:\d+:\d+)/g)].map((match) => match[1]);
  const where = places.length > 0 ? ` at ${[...new Set(places)].join(', ')}` : '';
  return `The kernels did not compile for ${real}${where}.\n${report}`;
}

/**
 * A TypeScript interface of the exported kernels, from the declarations the compiler writes. Addresses and reals are
 * numbers, 64-bit integers are bigints, and booleans are what WebAssembly makes of them: the numbers 0 and 1.
 * @param {{ f32: CompiledKernels, f64: CompiledKernels }} compiled
 */
export function kernelInterface({ f32, f64 }) {
  const wide = exportedFunctions(f64.declarations);
  const members = exportedFunctions(f32.declarations).map(({ place, name, parameters, result, types }, index) => {
    if (parameters.includes('?')) {
      throw new Error(
        `The exported kernel ${place} has a default parameter, which callers outside WebAssembly cannot leave out ` +
          `safely: give ${name} plain parameters and put the default in TypeScript.`,
      );
    }
    const exact = types.map((type, i) => (type === wide[index]?.types[i] ? type : type.replace('f32', 'real')));
    const returns = result === 'void' ? 'void' : exact.pop();
    const signature = `${name}(${parameters}): ${result}`.replaceAll('boolean', 'number');
    return `  /** ${place}(${exact.join(', ')}): ${returns} */\n  ${signature};\n`;
  });
  return `export interface KernelExports {\n${members.join('')}}\n`;
}

/** @param {string} declarations */
function exportedFunctions(declarations) {
  const pattern = /\/\*\*((?:(?!\*\/)[\s\S])*)\*\/\s*export function (\w+)\(([^)]*)\): (\w+);/g;
  return [...declarations.matchAll(pattern)].map(([, comment, name, parameters, result]) => ({
    place: comment.match(/\S*\/\w+/)?.[0] ?? name,
    name,
    parameters,
    result,
    types: [...comment.matchAll(/@(?:param (\w+)|returns) `([^`]+)`/g)].map(([, parameter, type]) =>
      parameter ? `${parameter}: ${type}` : type,
    ),
  }));
}

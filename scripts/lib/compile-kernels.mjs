/** Runs the AssemblyScript compiler over the kernels, once for each precision, and reads what it exports. */
import { execFile } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { promisify } from 'node:util';
import { cacheFolder, resolveInstalled } from './paths.mjs';

const run = promisify(execFile);

/**
 * No garbage collector, no checks; the comments in `docs/` say why. Names of functions change no instruction, but would
 * take some 10 KB of a bundle with everything.
 */
export const compilerFlags = [
  '-O3',
  '--runtime stub',
  '--enable simd',
  '--noAssert',
  '--use abort=',
  '--bindings raw',
  '--importMemory',
  '--noExportMemory',
  ...(process.env.KERNEL_NAMES ? ['--debug'] : []),
].flatMap((flag) => flag.split(' '));

/**
 * Modules that are not worth code that is unrolled and inlined: what they do waits for divisions, and every game carries
 * them.
 */
const SHORT = ['math/module.ts', 'rotation/module.ts'];

/** Modules that are faster without the last level of optimization: springs take 0.93 of the time in f64, 0.92 in f32. */
const PLAIN = ['index.ts'];

/** A call with more arguments cannot be read: which is which. */
const MAX_PARAMETERS = 8;

/**
 * @typedef {{ wasm: Uint8Array<ArrayBuffer>, declarations: string }} CompiledKernels
 * @param {string} folder the folder of the kernels
 * @param {string} entry the module in it
 * @param {import('./low-memory-map.mjs').Room} constants where its constants go; more than fit there do not compile
 * @param {boolean} [alwaysF64] whether one build is for worlds of both precisions: kernels that use `real` do not compile
 * @returns {Promise<{ f32: CompiledKernels, f64: CompiledKernels }>}
 */
export async function compileKernels(folder, entry, { start, end }, alwaysF64 = false) {
  mkdirSync(cacheFolder, { recursive: true });
  const output = mkdtempSync(`${cacheFolder}/kernels-`);
  const flags = ['--memoryBase', String(start), '--lowMemoryLimit', String(end)];
  if (PLAIN.includes(entry)) flags.push('--optimizeLevel', '2');
  if (SHORT.includes(entry)) flags.push('--shrinkLevel', '1');
  const build = (/** @type {'f32' | 'f64'} */ precision) => {
    const real = alwaysF64 ? [] : ['--use', `real=${precision}`];
    return compile(folder, entry, precision, output, [...flags, ...real]);
  };
  try {
    const f64 = build('f64');
    const [a, b] = await Promise.all([alwaysF64 ? f64 : build('f32'), f64]);
    return { f32: a, f64: b };
  } finally {
    rmSync(output, { recursive: true, force: true });
  }
}

/**
 * Compiles one file for one precision.
 * @param {string} folder
 * @param {string} entry
 * @param {'f32' | 'f64'} precision
 * @param {string} output the folder where the compiler writes
 * @param {string[]} flags
 * @returns {Promise<CompiledKernels>}
 */
export async function compile(folder, entry, precision, output, flags) {
  const compiler = resolveInstalled('assemblyscript/bin/asc.js');
  const file = `${output}/${precision}.wasm`;
  const args = [`${folder}/${entry}`, '--baseDir', folder, '--outFile', file, ...compilerFlags, ...flags];
  try {
    // The compiler starts itself a second time unless source maps are already enabled.
    await run(process.execPath, ['--enable-source-maps', compiler, ...args], { cwd: folder, maxBuffer: 1 << 26 });
  } catch (error) {
    throw new Error(describeFailure(/** @type {{ stderr?: string, message: string }} */ (error), folder, precision));
  }
  return { wasm: readFileSync(file), declarations: readFileSync(`${output}/${precision}.d.ts`, 'utf8') };
}

/**
 * Turns `└─ in broad-phase/grid.ts(8,45)` into a path with line and column that editors and terminals can open.
 * @param {{ stderr?: string, message: string }} error
 * @param {string} folder
 * @param {string} precision
 */
function describeFailure(error, folder, precision) {
  const shown = folder.startsWith(process.cwd()) ? folder.slice(process.cwd().length + 1) : folder;
  const report = (error.stderr || error.message)
    .replace(/\bin (\S+\.ts)\((\d+),(\d+)\)/g, `in ${shown}/$1:$2:$3`)
    .trim();
  const places = [...report.matchAll(/\bin (\S+\.ts:\d+:\d+)/g)].map((match) => match[1]);
  const where = places.length > 0 ? ` at ${[...new Set(places)].join(', ')}` : '';
  return `The kernels did not compile for ${precision}${where}.\n${report}`;
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
    if (parameters.split(',').length > MAX_PARAMETERS) {
      throw new Error(
        `The exported kernel ${place} has more than ${MAX_PARAMETERS} parameters: give ${name} the address of an ` +
          'exported @unmanaged class, whose layout TypeScript gets.',
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

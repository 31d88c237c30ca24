/**
 * Compiles the reference kernel with the flags of the engine's own kernels. It is compiled when first asked for and
 * kept in the cache folder until its source or the compiler changes.
 */
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { compileKernels, compilerFlags } from '../../scripts/lib/compile-kernels.mjs';
import { cacheFolder, resolveInstalled } from '../../scripts/lib/paths.mjs';

const folder = fileURLToPath(new URL('.', import.meta.url)).replace(/[\\/]$/, '');

/**
 * @param {'f32' | 'f64'} precision
 * @returns {Promise<Uint8Array>} the WebAssembly module
 */
export async function referenceKernel(precision) {
  const file = (/** @type {string} */ real) => `${cacheFolder}/bench-kernel-${sourceHash()}-${real}.wasm`;
  if (!existsSync(file(precision))) {
    const compiled = await compileKernels(folder, 'fused.ts', { start: 1024, end: 4096 });
    mkdirSync(cacheFolder, { recursive: true });
    for (const real of /** @type {const} */ (['f32', 'f64'])) {
      const draft = `${file(real)}.${process.pid}`;
      writeFileSync(draft, compiled[real].wasm);
      renameSync(draft, file(real)); // another process never reads half a file
    }
  }
  return readFileSync(file(precision));
}

function sourceHash() {
  const compiler = JSON.parse(readFileSync(resolveInstalled('assemblyscript/package.json'), 'utf8')).version;
  const hash = createHash('sha256').update(compiler).update(compilerFlags.join(' '));
  for (const name of readdirSync(folder).sort()) {
    if (name.endsWith('.ts')) hash.update(name).update(readFileSync(`${folder}/${name}`));
  }
  return hash.digest('hex').slice(0, 16);
}

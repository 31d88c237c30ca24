/** Builds every package for publishing: an ES module for each of its entries, and declarations, in its `dist`. */
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';
import { buildKernels } from './build-kernels.mjs';
import { bundleOptions } from './lib/bundle.mjs';
import { cacheFolder, resolveInstalled, root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { runNode } from './lib/run.mjs';

const names = readdirSync(`${root}/packages`).filter((name) => existsSync(`${root}/packages/${name}/src/index.ts`));

try {
  await buildKernels();
  for (const name of names) {
    rmSync(`${root}/packages/${name}/dist`, { recursive: true, force: true });
    const folders = { outbase: `packages/${name}/src`, outdir: `packages/${name}/dist` };
    await build(bundleOptions({ ...folders, entryPoints: entriesOf(name), splitting: true, packages: 'external' }));
  }
  await writeDeclarations();
  process.stdout.write(`Built ${names.join(', ')}\n`);
} catch (error) {
  await reportFailure(error);
}

/**
 * The sources that a package exports.
 * @param {string} name
 * @returns {string[]}
 */
function entriesOf(name) {
  const { exports } = JSON.parse(readFileSync(`${root}/packages/${name}/package.json`, 'utf8'));
  return Object.values(exports).map((entry) => `packages/${name}/${entry['principia-source'].slice(2)}`);
}

/** All packages at once, because each imports the sources of those below it; then to each its own. */
async function writeDeclarations() {
  const types = `${cacheFolder}/types`;
  rmSync(types, { recursive: true, force: true });
  mkdirSync(types, { recursive: true });
  const project = {
    extends: `${root}/tsconfig.json`,
    compilerOptions: {
      noEmit: false,
      declaration: true,
      emitDeclarationOnly: true,
      allowJs: false,
      checkJs: false,
      rootDir: `${root}/packages`,
      outDir: types,
      typeRoots: [`${root}/node_modules/@types`],
    },
    include: names.map((name) => `${root}/packages/${name}/src`),
    exclude: [`${root}/packages/*/src/**/*.test.ts`],
  };
  writeFileSync(`${types}/tsconfig.json`, JSON.stringify(project));
  const typescript = resolveInstalled('typescript/package.json').replace(/package\.json$/, 'bin/tsc');
  if ((await runNode([typescript, '-p', `${types}/tsconfig.json`])) !== 0) throw new Error('The declarations failed.');
  for (const name of names) cpSync(`${types}/${name}/src`, `${root}/packages/${name}/dist`, { recursive: true });
}

/**
 * Builds every package for publishing, in its `dist`: a JavaScript module and a declaration file for each source that its
 * entries reach. One module a source, because a bundler drops whole modules of a package without side effects, and finds
 * far less to drop in one large file. There are no source maps: the modules are the sources without their types. The
 * package of the physics gets the pages of `docs`, too.
 *
 * As a program: `node scripts/build-packages.mjs`. As a function: `await buildPackages()`.
 */
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { buildExamples } from './build-examples.mjs';
import { buildKernels } from './build-kernels.mjs';
import { packageFolder, packageNames, sourcesByImport, sourcesOf } from './lib/packages.mjs';
import { cacheFolder, resolveInstalled, root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { runNode } from './lib/run.mjs';
import { shipPages } from './lib/shipped-pages.mjs';

export async function buildPackages() {
  await buildKernels();
  await buildExamples();
  const emitted = `${cacheFolder}/emitted`;
  await emit(emitted);
  for (const name of packageNames) {
    const dist = `${packageFolder(name)}/dist`;
    rmSync(dist, { recursive: true, force: true });
    cpSync(`${emitted}/${name}/src`, dist, { recursive: true });
    // Npm puts it into every tarball; the repository needs it once.
    cpSync(`${root}/LICENSE`, `${packageFolder(name)}/LICENSE`);
  }
  shipPages(`${packageFolder('physics')}/docs`);
}

/**
 * All packages at once, because each imports the sources of those below it.
 * @param {string} folder
 */
async function emit(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const project = {
    extends: `${root}/tsconfig.json`,
    compilerOptions: {
      noEmit: false,
      declaration: true,
      allowJs: false,
      checkJs: false,
      rewriteRelativeImportExtensions: true,
      // Seen together, and not one by one, so that numbers with names (`const enum`) stand in place of the names.
      isolatedModules: false,
      verbatimModuleSyntax: false,
      // Nothing of Node, so that the packages need none of its types.
      types: [],
      rootDir: `${root}/packages`,
      outDir: folder,
      // Sources that are found through node_modules belong to another project for the compiler, which does not emit them.
      paths: Object.fromEntries(packageNames.flatMap(sourcesByImport).map(([name, source]) => [name, [source]])),
    },
    files: packageNames.flatMap(sourcesOf),
    include: [],
  };
  writeFileSync(`${folder}/tsconfig.json`, JSON.stringify(project));
  const typescript = resolveInstalled('typescript/package.json').replace(/package\.json$/, 'bin/tsc');
  if ((await runNode([typescript, '-p', `${folder}/tsconfig.json`])) !== 0)
    throw new Error('The packages do not compile.');
  for (const file of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    if (file.endsWith('.d.ts')) nameEmittedFiles(`${folder}/${file}`);
  }
}

/**
 * The compiler gives imports of modules the extension of what it emits, but leaves those of declarations as they are in the
 * sources, which are not published.
 * @param {string} file
 */
function nameEmittedFiles(file) {
  const text = readFileSync(file, 'utf8');
  writeFileSync(file, text.replace(/((?:from|import) '\.[^']*|import\("\.[^"]*)\.ts(?=['"])/g, '$1.js'));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  try {
    await buildPackages();
    process.stdout.write(`Built ${packageNames.join(', ')}\n`);
  } catch (error) {
    await reportFailure(error);
  }
}

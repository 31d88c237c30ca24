/**
 * Looks at the packages as npm would publish them, and as somebody sees them who installs them: what is in the tarballs,
 * what publint and attw say of them, whether strict programs compile against them as Node and as bundlers resolve modules,
 * and whether the programs on their front pages run.
 */
import { execFile } from 'node:child_process';
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { promisify } from 'node:util';
import { build, transform } from 'esbuild';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import { codeOf, packageNames, readmeOf, sourcesByImport } from './lib/packages.mjs';
import { withPackedPackages } from './lib/packed-packages.mjs';
import { resolveInstalled, root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { shippedPages } from './lib/shipped-pages.mjs';

const attw = resolveInstalled('@arethetypeswrong/cli/package.json').replace(/package\.json$/, 'dist/index.js');
const typescript = resolveInstalled('typescript/package.json').replace(/package\.json$/, 'bin/tsc');

try {
  const problems = await withPackedPackages(async (project, packed) => {
    const found = [packed.flatMap(wrongFiles), missingPages(project, packed)];
    for (const one of packed) found.push(await lint(one));
    found.push(...(await Promise.all(packed.map(wrongTypes))));
    writePrograms(project);
    found.push(await compileErrors(project, 'node16', 'node16'), await compileErrors(project, 'esnext', 'bundler'));
    found.push(await unresolvedImports(project));
    for (const name of packageNames) found.push(await runErrors(project, name));
    for (const { name, size } of packed)
      process.stdout.write(`${name.padEnd(14)} ${(size / 1024).toFixed(1)} KB packed\n`);
    return found.flat();
  });
  if (problems.length > 0) throw new Error(`The packages are not fit to be published:\n${problems.join('\n')}`);
} catch (error) {
  await reportFailure(error);
}

/**
 * @param {import('./lib/packed-packages.mjs').Packed} packed
 * @returns {string[]}
 */
function wrongFiles({ name, files }) {
  const pages = name === 'physics' ? shippedPages.map((page) => `docs/${page}`) : [];
  const missing = ['LICENSE', 'README.md', 'package.json', 'dist/index.js', 'dist/index.d.ts', ...pages].filter(
    (file) => !files.includes(file),
  );
  const expected = /^(LICENSE|README\.md|package\.json|dist\/.*\.(js|d\.ts))$/;
  const needless = files.filter((file) => !expected.test(file) && !pages.includes(file));
  return [
    ...missing.map((file) => `${name}: ${file} is not in the tarball`),
    ...needless.map((file) => `${name}: nobody needs ${file} in the tarball`),
  ];
}

/**
 * Pages that comments in declarations name, such as `docs/step.md`, and that the physics, which every package needs, does
 * not ship.
 * @param {string} project
 * @param {readonly import('./lib/packed-packages.mjs').Packed[]} packed
 */
function missingPages(project, packed) {
  const shipped = packed.find(({ name }) => name === 'physics')?.files ?? [];
  return packed.flatMap(({ name }) => {
    const folder = `${project}/node_modules/@principia/${name}`;
    const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.d.ts'));
    return files.flatMap((file) => {
      const pages = readFileSync(`${folder}/${file}`, 'utf8').match(/\bdocs\/[\w-]+\.md\b/g) ?? [];
      const lost = pages.filter((page) => !shipped.includes(page));
      return lost.map((page) => `${name}: ${file} names ${page}, which is not in the tarball of the physics`);
    });
  });
}

/** @param {import('./lib/packed-packages.mjs').Packed} packed */
async function lint({ name, tarball }) {
  const { buffer, byteOffset, length } = readFileSync(tarball);
  const packed = { tarball: /** @type {ArrayBuffer} */ (buffer).slice(byteOffset, byteOffset + length) };
  const { messages, pkg } = await publint({ pack: packed, strict: true });
  return messages.map((message) => `${name}: publint: ${formatMessage(message, pkg, { color: false })}`);
}

/** The packages are ES modules, so resolution as in Node 10, and `require` in Node before 20.19, are left out. */
async function wrongTypes(/** @type {import('./lib/packed-packages.mjs').Packed} */ { name, tarball }) {
  return failureOf(`${name}: attw`, [attw, tarball, '--profile', 'esm-only', '--format', 'ascii', '--no-emoji']);
}

/**
 * The programs of consumers, and those of the front pages.
 * @param {string} project
 */
function writePrograms(project) {
  writeFileSync(`${project}/package.json`, JSON.stringify({ type: 'module' }));
  for (const name of ['consumer', 'declarations']) {
    copyFileSync(`${root}/test/packages/${name}.ts`, `${project}/${name}.ts`);
  }
  for (const name of packageNames) writeFileSync(`${project}/${name}.ts`, `${codeOf(readmeOf(name))}\nexport {};\n`);
}

/**
 * @param {string} project
 * @param {string} module
 * @param {string} moduleResolution
 */
async function compileErrors(project, module, moduleResolution) {
  const compilerOptions = {
    strict: true,
    declaration: true,
    skipLibCheck: false,
    noEmit: true,
    types: [],
    target: 'ES2022',
    lib: ['ES2022', 'DOM', 'DOM.Iterable'],
    module,
    moduleResolution,
  };
  writeFileSync(`${project}/tsconfig.json`, JSON.stringify({ compilerOptions, include: ['*.ts'] }));
  const output = (
    await failureOf(`types as ${moduleResolution} resolves them`, [typescript, '-p', '.'], project)
  ).join();
  // Declarations of pixi.js 8 itself do not compile as Node 16 resolves modules; they do as bundlers do.
  const own = output.split('\n').filter((line) => /error TS/.test(line) && !/node_modules\/pixi\.js\//.test(line));
  return own.map((line) => `${moduleResolution}: ${line}`);
}

/**
 * Follows the imports of all modules, as those that declarations do not name may be of packages that no manifest does.
 * @param {string} project
 */
async function unresolvedImports(project) {
  const imported = packageNames.flatMap(sourcesByImport).map(([name]) => name);
  const contents = imported.map((name) => `export * from '${name}';`).join('');
  const stdin = { contents, resolveDir: project };
  try {
    await build({ stdin, bundle: true, format: 'esm', outdir: project, write: false, logLevel: 'silent' });
    return [];
  } catch (error) {
    const { errors } = /** @type {import('esbuild').BuildFailure} */ (error);
    return errors.map(({ text, location }) => `${text} in ${location?.file}`);
  }
}

/**
 * Runs the program of a front page in plain Node, unless it needs a page to draw on.
 * @param {string} project
 * @param {string} name
 */
async function runErrors(project, name) {
  const source = readFileSync(`${project}/${name}.ts`, 'utf8');
  if (/from '(three|pixi\.js|@principia\/(render-pixi|render-three|shell))'/.test(source)) return [];
  const { code } = await transform(source, { loader: 'ts' });
  writeFileSync(`${project}/${name}.js`, code);
  return failureOf(`${name}: the program of its README`, [`${project}/${name}.js`], project);
}

/**
 * What a program of Node wrote before it failed; nothing when it did not.
 * @param {string} what
 * @param {readonly string[]} args
 * @param {string} [cwd]
 * @returns {Promise<string[]>}
 */
async function failureOf(what, args, cwd = root) {
  try {
    await promisify(execFile)(process.execPath, [...args], { cwd, maxBuffer: 1 << 26 });
    return [];
  } catch (error) {
    const { stdout, stderr } = /** @type {{ stdout: string, stderr: string }} */ (error);
    return [`${what}:\n${stdout}${stderr}`];
  }
}

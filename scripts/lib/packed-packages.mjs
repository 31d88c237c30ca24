/** The packages as a user gets them: packed by npm, and installed in an empty project that knows nothing of the sources. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { buildPackages } from '../build-packages.mjs';
import { packageNames } from './packages.mjs';
import { root } from './paths.mjs';

/**
 * A package, the file that npm would publish, its bytes, and what is in it.
 * @typedef {{ name: string, tarball: string, size: number, files: readonly string[] }} Packed
 */

/**
 * Builds and packs every package, and hands `use` an empty project in which they are installed. It lies outside of the
 * repository, whose own `node_modules` would hide a dependency that no manifest names.
 * @template T
 * @param {(project: string, packed: readonly Packed[]) => Promise<T>} use
 */
export async function withPackedPackages(use) {
  await buildPackages();
  const project = mkdtempSync(join(tmpdir(), 'principia-packed-'));
  try {
    const packed = pack(project);
    for (const { name, tarball } of packed) install(project, name, tarball);
    return await use(project, packed);
  } finally {
    rmSync(project, { recursive: true, force: true });
  }
}

/**
 * @param {string} folder
 * @returns {Packed[]}
 */
function pack(folder) {
  const workspaces = packageNames.flatMap((name) => ['--workspace', `packages/${name}`]);
  const output = npm(['pack', '--json', '--ignore-scripts', '--pack-destination', folder, ...workspaces]);
  /** @type {{ name: string, filename: string, size: number, files: { path: string }[] }[]} */
  const results = JSON.parse(output);
  return results.map(({ name, filename, size, files }) => ({
    name: name.split('/')[1],
    tarball: join(folder, filename),
    size,
    files: files.map(({ path }) => path),
  }));
}

/**
 * Unpacks a package and links what its manifest names from the repository, so that nothing is downloaded.
 * @param {string} project
 * @param {string} name
 * @param {string} tarball
 */
function install(project, name, tarball) {
  const folder = join(project, 'node_modules/@principia', name);
  mkdirSync(folder, { recursive: true });
  execFileSync('tar', ['-xzf', tarball, '-C', folder, '--strip-components=1']);
  const { dependencies = {}, peerDependencies = {} } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  for (const dependency of Object.keys({ ...dependencies, ...peerDependencies })) {
    if (dependency.startsWith('@principia/')) continue;
    const link = join(project, 'node_modules', dependency);
    mkdirSync(dirname(link), { recursive: true });
    rmSync(link, { force: true });
    symlinkSync(join(root, 'node_modules', dependency), link, 'junction');
  }
}

/** @param {readonly string[]} args */
function npm(args) {
  return execFileSync('npm', [...args], {
    cwd: root,
    encoding: 'utf8',
    maxBuffer: 1 << 26,
    stdio: ['ignore', 'pipe', 'inherit'],
    // On Windows npm is a script for the shell.
    shell: process.platform === 'win32',
  });
}

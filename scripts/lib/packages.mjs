/** The published packages: which there are, where they lie, and which of their sources can be reached from outside. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { root } from './paths.mjs';

/** Names of the folders below `packages`, in alphabetical order. */
export const packageNames = readdirSync(`${root}/packages`)
  .filter((name) => existsSync(`${packageFolder(name)}/src/index.ts`))
  .sort();

/** @param {string} name */
export function packageFolder(name) {
  return `${root}/packages/${name}`;
}

/**
 * What a package's manifest says.
 * @param {string} name
 */
export function manifestOf(name) {
  return JSON.parse(readFileSync(`${packageFolder(name)}/package.json`, 'utf8'));
}

/**
 * The front page of a package.
 * @param {string} name
 */
export function readmeOf(name) {
  return readFileSync(`${packageFolder(name)}/README.md`, 'utf8');
}

/**
 * The program that a page shows: all its blocks of TypeScript together.
 * @param {string} markdown
 */
export function codeOf(markdown) {
  return [...markdown.matchAll(/```ts\n([\s\S]*?)```/g)].map(([, block]) => block).join('\n');
}

/**
 * The sources behind a package's `exports` and `imports`: a file that one condition alone chooses is among them, and `*`
 * stands for all names.
 * @param {string} name
 * @returns {string[]} absolute paths
 */
export function sourcesOf(name) {
  const { exports, imports = {} } = manifestOf(name);
  return [...new Set([exports, imports].flatMap(targetsIn))]
    .filter((target) => /^\.\/src\/.*\.ts$/.test(target))
    .flatMap((target) => filesLike(packageFolder(name), target.slice(2)));
}

/**
 * The source behind each name that other packages import.
 * @param {string} name
 * @returns {[imported: string, source: string][]} such as `@principia/shell/pixi`, with absolute paths
 */
export function sourcesByImport(name) {
  const manifest = manifestOf(name);
  return Object.entries(manifest.exports)
    .filter(([, target]) => target['principia-source'] !== undefined)
    .map(([path, target]) => [
      manifest.name + path.slice(1),
      `${packageFolder(name)}/${target['principia-source'].slice(2)}`,
    ]);
}

/**
 * Every file that a part of a manifest leads to.
 * @param {unknown} part
 * @returns {string[]}
 */
function targetsIn(part) {
  if (typeof part === 'string') return [part];
  return part === null ? [] : Object.values(/** @type {object} */ (part)).flatMap(targetsIn);
}

/**
 * @param {string} folder
 * @param {string} pattern a path below it, with at most one `*`
 */
function filesLike(folder, pattern) {
  const [start, end] = pattern.split('*');
  if (end === undefined) return [`${folder}/${pattern}`];
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((file) => file.replaceAll('\\', '/'));
  return files
    .filter((file) => file.startsWith(start) && file.endsWith(end) && !file.endsWith('.test.ts'))
    .map((file) => `${folder}/${file}`);
}

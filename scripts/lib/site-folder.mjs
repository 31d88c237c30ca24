/** Where a site may be written: what is in that folder goes, so it must be a former site or empty. */
import { existsSync, readdirSync, readFileSync, realpathSync, statSync } from 'node:fs';
import { isAbsolute, relative, resolve } from 'node:path';
import { root } from './paths.mjs';

/** The files that a site lists in its worker, without maps of sources. */
const LIST = /^const FILES = (\[.*\]);$/m;

/**
 * The whole path of a folder for a site, relative to the working folder, without a slash at its end.
 * @param {string} folder
 * @throws Error if writing a site there would remove anything but a former site
 */
export function siteFolder(folder) {
  const path = resolve(folder);
  // Links would hide what a folder is.
  const real = existsSync(path) ? realpathSync(path) : path;
  for (const [what, kept] of [
    ['the project', root],
    ['the folder you are in', process.cwd()],
  ]) {
    if (isWithin(realpathSync(kept), real)) throw new Error(`${refusal(folder)}: ${what} lies there. ${ADVICE}`);
  }
  if (!existsSync(real)) return real;
  if (!statSync(real).isDirectory()) throw new Error(`${refusal(folder)}: it is a file. ${ADVICE}`);
  const foreign = foreignFile(real);
  if (foreign !== undefined) {
    throw new Error(`${refusal(folder)}: ${foreign} there is no file of a former site, and would be lost. ${ADVICE}`);
  }
  return real;
}

const ADVICE = 'Name a folder that is new or empty with --out.';

/** @param {string} folder */
const refusal = (folder) => `The site cannot be written to ${folder}`;

/** @param {string} path @param {string} folder */
function isWithin(path, folder) {
  const way = relative(folder, path);
  return way === '' || !(way.split(/[\\/]/)[0] === '..' || isAbsolute(way));
}

/** The first file or link in a folder that no site has put there. @param {string} folder */
function foreignFile(folder) {
  const files = filesIn(folder);
  const worker = files.includes('sw.js') ? readFileSync(`${folder}/sw.js`, 'utf8') : '';
  /** @type {string[]} */
  const listed = worker.startsWith("const CACHE = 'principia '") ? JSON.parse(worker.match(LIST)?.[1] ?? '[]') : [];
  const own = listed.length === 0 ? new Set() : new Set(['sw.js', ...listed, ...listed.map((file) => `${file}.map`)]);
  return files.find((file) => !own.has(file));
}

/** Everything in a folder that is no folder itself, by its path from there with slashes. @param {string} folder */
function filesIn(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => !entry.isDirectory())
    .map((entry) => relative(folder, `${entry.parentPath}/${entry.name}`).replaceAll('\\', '/'));
}

/**
 * The address of a site as pages are given it: with a slash at its end, from which the addresses of games lead on.
 * @param {string} text
 * @throws Error if it is no address of the web
 */
export function siteAddress(text) {
  const url = URL.canParse(text) ? new URL(text) : undefined;
  if (url === undefined || !/^https?:$/.test(url.protocol) || url.search !== '' || url.hash !== '') {
    throw new Error(`--url must be the address of the site, such as https://example.org/games/, not "${text}".`);
  }
  url.pathname = url.pathname.replace(/(\/index\.html|\/)?$/, '/');
  return url.href;
}

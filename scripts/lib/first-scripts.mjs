/** What makes a page start sooner: the scripts it will need are fetched at once. */
import { dirname, relative } from 'node:path';

/**
 * Games that open another part of themselves where the address has a parameter: its name, and the module of that part.
 * @type {Readonly<Record<string, { readonly parameter: string, readonly module: string }>>}
 */
const OTHER_PARTS = { laboratory: { parameter: 'example', module: 'example-page.ts' } };

/**
 * @typedef {object} FirstScripts
 * @property {string[]} shared scripts that the page imports itself, by addresses relative to the page
 * @property {string[]} picture scripts of its first picture, which it imports when it runs
 * @property {{ parameter: string, scripts: string[] }} [other] those that take their place where the address has a parameter
 */

/**
 * The scripts of a page in the order they are met. Without links a browser finds each only when it has read the one
 * before.
 * @param {import('esbuild').Metafile['outputs']} outputs
 * @param {string} entry key of the page's own script in `outputs`
 * @returns {FirstScripts}
 */
export function firstScripts(outputs, entry) {
  /** @type {Set<string>} */
  let found = new Set([entry]);
  /** @type {(path: string, into: string[]) => void} */
  const visit = (path, into) => {
    for (const each of outputs[path].imports) {
      if (each.kind !== 'import-statement' || found.has(each.path) || outputs[each.path] === undefined) continue;
      found.add(each.path);
      into.push(relative(dirname(entry), each.path).replaceAll('\\', '/'));
      visit(each.path, into);
    }
  };
  /** @type {FirstScripts} */
  const scripts = { shared: [], picture: [] };
  visit(entry, scripts.shared);
  const picture = outputs[entry].imports.find(({ kind }) => kind === 'dynamic-import');
  const shared = new Set(found);
  /** @param {string | undefined} path @param {string[]} into */
  const visitPart = (path, into) => {
    if (path === undefined || outputs[path] === undefined || found.has(path)) return;
    found.add(path);
    into.push(relative(dirname(entry), path).replaceAll('\\', '/'));
    visit(path, into);
  };
  visitPart(picture?.path, scripts.picture);
  const name = dirname(entry).split('/').at(-1) ?? '';
  if (OTHER_PARTS[name] === undefined) return scripts;
  const { parameter, module } = OTHER_PARTS[name];
  found = shared;
  scripts.other = { parameter, scripts: [] };
  const part = Object.keys(outputs).find((path) => outputs[path].entryPoint === `games/${name}/${module}`);
  visitPart(part, scripts.other.scripts);
  return scripts;
}

/**
 * The same for every game of some bundles.
 * @param {readonly (import('esbuild').Metafile | undefined)[]} metafiles
 * @returns {(name: string) => FirstScripts}
 */
export function scriptsByGame(metafiles) {
  const outputs = Object.assign({}, ...metafiles.map((metafile) => metafile?.outputs));
  return (name) => {
    const entry = Object.keys(outputs).find((path) => path.endsWith(`/${name}/main.js`));
    return entry === undefined ? { shared: [], picture: [] } : firstScripts(outputs, entry);
  };
}

/**
 * A page that fetches them at once; an address that names a renderer may want another picture, so it fetches none.
 * @param {string} html
 * @param {FirstScripts} scripts as `firstScripts` says
 */
export function startSooner(html, { shared, picture, other }) {
  const links = shared.map((script) => `<link rel="modulepreload" href="${script}">`);
  const part =
    other && `new URLSearchParams(location.search).has('${other.parameter}') ? ${JSON.stringify(other.scripts)} : `;
  const early = `<script>/[?&]renderer=/.test(location.search) || (${part ?? ''}${JSON.stringify(picture)}).forEach(function (script) {
  document.head.append(Object.assign(document.createElement('link'), { rel: 'modulepreload', href: script }));
})</script>`;
  if (picture.length > 0) links.push(early);
  return html.replace('</head>', `${links.join('\n')}\n</head>`);
}

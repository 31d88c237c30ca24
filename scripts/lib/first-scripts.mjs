/** What makes a page start sooner: the scripts it will need are fetched at once. */
import { dirname, relative } from 'node:path';

/**
 * The scripts of a page in the order they are met: what it imports, and its first picture, which it imports when it
 * runs. Without links a browser finds each only when it has read the one before.
 * @param {import('esbuild').Metafile['outputs']} outputs
 * @param {string} entry key of the page's own script in `outputs`
 * @returns {string[]} addresses relative to the page
 */
export function firstScripts(outputs, entry) {
  /** @type {Set<string>} */
  const found = new Set();
  /** @type {(path: string) => void} */
  const visit = (path) => {
    if (found.has(path) || outputs[path] === undefined) return;
    found.add(path);
    const { imports } = outputs[path];
    for (const each of imports) if (each.kind === 'import-statement') visit(each.path);
    const picture = path === entry ? imports.find(({ kind }) => kind === 'dynamic-import') : undefined;
    if (picture !== undefined) visit(picture.path);
  };
  visit(entry);
  return [...found]
    .filter((path) => path !== entry)
    .map((path) => relative(dirname(entry), path).replaceAll('\\', '/'));
}

/**
 * The same for every game of some bundles.
 * @param {readonly (import('esbuild').Metafile | undefined)[]} metafiles
 * @returns {(name: string) => string[]}
 */
export function scriptsByGame(metafiles) {
  const outputs = Object.assign({}, ...metafiles.map((metafile) => metafile?.outputs));
  return (name) => {
    const entry = Object.keys(outputs).find((path) => path.endsWith(`/${name}/main.js`));
    return entry === undefined ? [] : firstScripts(outputs, entry);
  };
}

/**
 * A page with links to them in its head.
 * @param {string} html
 * @param {readonly string[]} scripts as `firstScripts` says
 */
export function startSooner(html, scripts) {
  const links = scripts.map((script) => `<link rel="modulepreload" href="${script}">`);
  return html.replace('</head>', `${links.join('\n')}\n</head>`);
}

/** What makes a page start sooner: the scripts it will need are fetched at once. */
import { dirname, relative } from 'node:path';

/** Scripts that pixi loads when it has chosen how to draw, and a game's page draws with WebGL. */
const OF_PIXI = /\/(WebGLRenderer|browserAll)-/;

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
    const later = imports.filter(({ kind }) => kind === 'dynamic-import');
    const chosen = path === entry ? later.slice(0, 1) : later.filter((each) => OF_PIXI.test(each.path));
    for (const each of imports) if (each.kind === 'import-statement') visit(each.path);
    for (const each of chosen) visit(each.path);
  };
  visit(entry);
  return [...found]
    .filter((path) => path !== entry)
    .map((path) => relative(dirname(entry), path).replaceAll('\\', '/'));
}

/**
 * The same for every game of a bundle.
 * @param {import('esbuild').Metafile | undefined} metafile
 * @returns {(name: string) => string[]}
 */
export function scriptsByGame(metafile) {
  const outputs = metafile?.outputs ?? {};
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

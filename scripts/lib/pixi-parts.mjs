/** Lets a page carry and run only those parts of pixi.js that it uses, and ask the graphics card nothing that is known. */
import { readFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

const library = dirname(fileURLToPath(import.meta.resolve('pixi.js')));

/** What pixi finds out by trial, on canvases that it throws away: file, and what is so wherever there is WebGL 2. */
const KNOWN = {
  canUseNewCanvasBlendModes: 'export const canUseNewCanvasBlendModes = () => true;',
  getMaxFragmentPrecision: "export const getMaxFragmentPrecision = () => 'highp';",
  maxRecommendedTextures: 'export const getMaxTexturesPerBatch = () => 16;',
};

/**
 * Pixi asks the graphics card before it shows anything, and waits for the answers.
 * @type {import('esbuild').Plugin}
 */
const knownAnswers = {
  name: 'known answers',
  setup(build) {
    for (const [file, contents] of Object.entries(KNOWN)) {
      build.onLoad({ filter: new RegExp(`[\\\\/]${file}\\.mjs$`) }, () => ({ contents }));
    }
  },
};

/**
 * Whoever imports from pixi's index is taken to need all of it as soon as pages share scripts: imports go to the files
 * behind the index instead. A page that makes an `Application` keeps the index, which tells it what pages can do.
 * @type {import('esbuild').Plugin}
 */
const behindTheIndex = {
  name: 'behind the index',
  setup(build) {
    const files = filesBehind(`${library}/index.mjs`);
    build.onLoad({ filter: /[\\/](packages|games)[\\/].*\.ts$/ }, ({ path }) => {
      const source = readFileSync(path, 'utf8');
      if (!source.includes("from 'pixi.js'")) return undefined;
      return { contents: source.replace(/^import (type )?\{([^}]*)\} from 'pixi\.js';$/gm, split), loader: 'ts' };
    });
    /** @type {(whole: string, type: string | undefined, names: string) => string} */
    const split = (whole, type, names) => {
      const imports = names.split(',').map((name) => name.trim());
      if (type !== undefined || imports.includes('Application')) return whole;
      const values = imports.filter((name) => name !== '' && !name.startsWith('type '));
      const lines = values.map((name) => `import { ${name} } from ${JSON.stringify(files(name.split(' as ')[0]))};`);
      // The index would also start what every renderer needs.
      return [`import '${library}/rendering/init.mjs';`, ...lines].join(' ');
    };
  },
};

/**
 * Finds the file that exports a name of the index.
 * @param {string} index
 * @returns {(name: string) => string}
 */
function filesBehind(index) {
  /** @type {Map<string, string>} */
  const found = new Map();
  for (const [, names, path] of readFileSync(index, 'utf8').matchAll(/^export \{([^}]*)\} from '\.\/([^']*)';$/gm)) {
    for (const name of names.split(',')) found.set(name.trim(), `${library}/${path}`);
  }
  return (name) => {
    const path = found.get(name);
    if (path === undefined) throw new Error(`pixi.js exports no “${name}” from a file of its own.`);
    return path;
  };
}

export const pixiPlugins = [knownAnswers, behindTheIndex];

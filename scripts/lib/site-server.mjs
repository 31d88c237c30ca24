/** The games site while you work on it: rebuilt on every change, reloaded by itself, errors shown on the page. */
import { readFileSync, statSync } from 'node:fs';
import { relative } from 'node:path';
import { context, formatMessages } from 'esbuild';
import { scriptsByGame, startSooner } from './first-scripts.mjs';
import { root } from './paths.mjs';
import { frontPageOptions, kernelsPlugin, siteBundles } from './site-bundle.mjs';
import { frontPage, gameNames, gamePage, gamePicture } from './site-pages.mjs';
import { serveFiles } from './static-server.mjs';

/** Covers the page before the first build and after a bad one, reloads it after a good one. */
const liveScript = readFileSync(new URL('./site-live.js', import.meta.url), 'utf8');

/**
 * @param {{ ports: readonly number[], host: string }} options
 * @returns {Promise<import('./static-server.mjs').RunningServer>}
 */
export async function serveSite({ ports, host }) {
  const live = liveChannel();
  const games = await watchGames(live.announce);
  const front = await watchFrontPage();
  const server = await serveFiles({
    ports,
    host,
    find: (path) => games.find(path) ?? front.find(path) ?? picture(path) ?? page(path, games.scripts),
    special: (path, response) => path === '/live' && live.join(response),
  });
  const pages = setInterval(watchPages(live.announce, games.restart), 500);
  const close = async () => {
    clearInterval(pages);
    await games.close();
    await front.close();
    await server.close();
  };
  return { ...server, close };
}

/**
 * Bundles the games in memory and again whenever a source changes; a bad build keeps the last good files.
 * @param {(problem: string) => void} announce
 */
async function watchGames(announce) {
  /** @type {{ files: Map<string, Uint8Array>, metafile?: import('esbuild').Metafile | undefined, problem: string | undefined }[]} */
  let bundles = [];
  let scripts = scriptsByGame([]);
  /** @type {(index: number) => import('esbuild').Plugin} */
  const publish = (index) => ({
    name: 'publish',
    setup(build) {
      build.onEnd(async ({ errors, outputFiles = [], metafile }) => {
        const problem = (await formatMessages(errors, { kind: 'error', color: false })).join('');
        if (errors.length === 0) {
          bundles[index] = {
            files: new Map(outputFiles.map(({ path, contents }) => [sitePath(path), contents])),
            metafile,
            problem,
          };
          scripts = scriptsByGame(bundles.map((bundle) => bundle.metafile));
        } else {
          bundles[index] = { ...bundles[index], problem };
          const messages = await formatMessages(errors, { kind: 'error', color: process.stderr.isTTY });
          process.stderr.write(`${messages.join('')}\n`);
        }
        // Pages wait until all games have been built once.
        if (bundles.every(({ problem }) => problem !== undefined))
          announce(bundles.map((each) => each.problem).join(''));
      });
    },
  });
  const start = async () => {
    const options = siteBundles({ write: false });
    bundles = options.map(() => ({ files: new Map(), problem: undefined }));
    const bundlers = await Promise.all(
      options.map((bundle, i) => context({ ...bundle, plugins: [...(bundle.plugins ?? []), publish(i)] })),
    );
    await Promise.all(bundlers.map((bundler) => bundler.watch()));
    return bundlers;
  };
  const stop = () => Promise.all(bundlers.map((bundler) => bundler.dispose()));
  let bundlers = await start();
  return {
    find: (/** @type {string} */ path) =>
      bundles.map(({ files }) => files.get(path)).find((file) => file !== undefined),
    scripts: (/** @type {string} */ name) => scripts(name),
    close: stop,
    restart: async () => {
      await stop();
      bundlers = await start();
    },
  };
}

/** Bundles the live scene of the front page in memory; the games report what is wrong with a source that both use. */
async function watchFrontPage() {
  /** @type {Map<string, Uint8Array>} */
  let files = new Map();
  /** @type {import('esbuild').Plugin} */
  const publish = {
    name: 'publish front page',
    setup(build) {
      build.onEnd(({ outputFiles = [] }) => {
        if (outputFiles.length > 0)
          files = new Map(outputFiles.map(({ path, contents }) => [sitePath(path), contents]));
      });
    },
  };
  const bundler = await context(frontPageOptions({ write: false, plugins: [kernelsPlugin, publish] }));
  await bundler.watch();
  return {
    find: (/** @type {string} */ path) => files.get(path),
    close: () => bundler.dispose(),
  };
}

/** @param {string} path of an output file on disk, had it been written */
function sitePath(path) {
  return `/${relative(`${root}/dist/site`, path).replaceAll('\\', '/')}`;
}

/** @param {string} path */
function picture(path) {
  const name = path.match(/^\/([\w-]+)\/picture\.webp$/)?.[1];
  return name && gameNames().includes(name) ? gamePicture(name) : undefined;
}

/**
 * Pages are read afresh for each request and carry the live script.
 * @param {string} path
 * @param {(name: string) => import('./first-scripts.mjs').FirstScripts} scripts
 */
function page(path, scripts) {
  const name = path.match(/^\/(?:([\w-]+)\/)?index\.html$/);
  if (!name || (name[1] && !gameNames().includes(name[1]))) return undefined;
  try {
    const html = name[1] ? startSooner(gamePage(name[1]), scripts(name[1])) : frontPage();
    return `${html}\n<script>${liveScript}</script>`;
  } catch (error) {
    return `<!doctype html><p>${/** @type {Error} */ (error).message}</p><script>${liveScript}</script>`;
  }
}

/**
 * A function to call now and then: it notices edited pages, and new games, which need a bundler of their own.
 * @param {(problem: string) => void} announce
 * @param {() => Promise<void>} restart
 */
function watchPages(announce, restart) {
  const edited = (/** @type {string} */ file) => statSync(`${root}/games/${file}`, { throwIfNoEntry: false })?.mtimeMs;
  const look = () => {
    const names = gameNames();
    return { names: names.join(), edits: ['.', ...names].map((name) => edited(`${name}/index.html`)).join() };
  };
  let before = look();
  return () => {
    const now = look();
    if (now.names !== before.names) void restart();
    else if (now.edits !== before.edits) announce('');
    before = now;
  };
}

/** Tells every open page of each build (server-sent events). */
function liveChannel() {
  /** @type {Set<import('node:http').ServerResponse>} */
  const listeners = new Set();
  // A page that is opened before there is anything to play says so, and begins by itself.
  const news = 'The games are being built for the first time. They begin by themselves, in half a minute or so.';
  let message = event({ version: 0, news });
  return {
    join(/** @type {import('node:http').ServerResponse} */ response) {
      response.writeHead(200, { 'Content-Type': 'text/event-stream', 'Cache-Control': 'no-store' });
      response.write(message);
      listeners.add(response);
      response.on('close', () => listeners.delete(response));
      return true;
    },
    announce(/** @type {string} */ problem) {
      message = event({ version: Date.now(), problem });
      for (const response of listeners) response.write(message);
    },
  };
}

/** @param {object} data */
function event(data) {
  return `data: ${JSON.stringify(data)}\n\n`;
}

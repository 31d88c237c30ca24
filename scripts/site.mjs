/**
 * The games site. `npm start` serves it from memory and follows your edits, the kernels included; `npm run build`
 * writes a static site into `dist/site` that works from any folder of any web server.
 *
 * Options of `npm start -- …`: `--port 8000` (the first free one from there on), `--host 127.0.0.1`.
 */
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { build } from 'esbuild';
import { root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { siteOptions } from './lib/site-bundle.mjs';
import { frontPage, gameNames, gamePage, gamePicture } from './lib/site-pages.mjs';
import { serveSite } from './lib/site-server.mjs';

const { values } = parseArgs({
  options: {
    serve: { type: 'boolean', default: false },
    port: { type: 'string', default: '8000' },
    host: { type: 'string', default: '127.0.0.1' },
  },
});

if (values.serve) await serve(Number(values.port), values.host);
else await buildSite();

/**
 * @param {number} first
 * @param {string} host
 */
async function serve(first, host) {
  const ports = [...Array.from({ length: 20 }, (_, i) => first + i), 0];
  const { port } = await serveSite({ ports, host });
  process.stdout.write(`\nPrincipia games: http://localhost:${port}/\n(Ctrl+C stops; edits reload the page)\n\n`);
}

async function buildSite() {
  const folder = `${root}/dist/site`;
  rmSync(folder, { recursive: true, force: true });
  try {
    await build(siteOptions({ minify: true }));
    mkdirSync(folder, { recursive: true });
    writeFileSync(`${folder}/index.html`, frontPage());
    for (const name of gameNames()) {
      writeFileSync(`${folder}/${name}/index.html`, gamePage(name));
      const picture = gamePicture(name);
      if (picture) writeFileSync(`${folder}/${name}/picture.png`, picture);
    }
    process.stdout.write(`Wrote ${gameNames().length} games to dist/site: serve that folder with any web server\n`);
  } catch (error) {
    await reportFailure(error);
  }
}

/**
 * The games site. `npm start` serves it from memory and follows your edits, the kernels included; `npm run build`
 * writes a static site into `dist/site` that works from any folder of any web server.
 *
 * Options of `npm start -- …`: `--port 8000` (the first free one from there on), `--host 127.0.0.1`; of
 * `npm run build -- …`: `--out dist/site`, and `--url https://example.org/games/`, the address at which it will be, with which
 * links to the games have previews with pictures.
 */
import { commandOptions } from './lib/command-options.mjs';
import { root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { writeSite } from './lib/site-build.mjs';
import { serveSite } from './lib/site-server.mjs';

const values = commandOptions({
  serve: { type: 'boolean', default: false },
  port: { type: 'string', default: '8000' },
  host: { type: 'string', default: '127.0.0.1' },
  out: { type: 'string', default: `${root}/dist/site` },
  url: { type: 'string' },
});

if (values.serve) await serve(Number(values.port), values.host);
else await buildSite(values.out);

/**
 * @param {number} first
 * @param {string} host
 */
async function serve(first, host) {
  const ports = [...Array.from({ length: 20 }, (_, i) => first + i), 0];
  const { port } = await serveSite({ ports, host });
  process.stdout.write(`\nPrincipia games: http://localhost:${port}/\n(Ctrl+C stops; edits reload the page)\n\n`);
}

/** @param {string} folder */
async function buildSite(folder) {
  try {
    const count = await writeSite(folder, values.url);
    process.stdout.write(`Wrote ${count} games to ${folder}: serve that folder with any web server\n`);
  } catch (error) {
    await reportFailure(error);
  }
}

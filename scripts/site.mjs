/**
 * The games site. `npm start` serves it from memory and follows your edits, the kernels included; `npm run build`
 * writes a static site into `dist/site` that works from any folder of any web server.
 *
 * Options of `npm start -- …`: `--port 8000` (the first free one from there on), `--host 127.0.0.1`; of
 * `npm run build -- …`: `--out dist/site`, and `--url https://example.org/games/`, the address at which it will be, with which
 * links to the games have previews with pictures. What the folder of `--out` held goes, so it must be new, empty or a former site.
 */
import { commandOptions, numberOption, refuse } from './lib/command-options.mjs';
import { root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { writeSite } from './lib/site-build.mjs';
import { siteAddress, siteFolder } from './lib/site-folder.mjs';
import { serveSite } from './lib/site-server.mjs';
import { serveFiles } from './lib/static-server.mjs';

const LAST_PORT = 65_535;

const values = commandOptions({
  serve: { type: 'boolean', default: false },
  port: { type: 'string', default: '8000' },
  host: { type: 'string', default: '127.0.0.1' },
  out: { type: 'string', default: `${root}/dist/site` },
  url: { type: 'string' },
});

if (values.serve) await serve(numberOption('port', values.port, { min: 0, max: LAST_PORT }), values.host);
else await buildSite(values.out);

/**
 * @param {number} first
 * @param {string} host
 */
async function serve(first, host) {
  const ports = [...Array.from({ length: 20 }, (_, i) => first + i).filter((port) => port <= LAST_PORT), 0];
  try {
    // Before the games are bundled for nothing.
    await (await serveFiles({ host, find: () => undefined })).close();
    const { port } = await serveSite({ ports, host });
    process.stdout.write(`\nPrincipia games: http://localhost:${port}/\n(Ctrl+C stops; edits reload the page)\n\n`);
  } catch (error) {
    await reportFailure(error);
  }
}

/** @param {string} out */
async function buildSite(out) {
  const { folder, url } = checkedPlace(out);
  try {
    const count = await writeSite(folder, url);
    process.stdout.write(`Wrote ${count} games to ${folder}: serve that folder with any web server\n`);
  } catch (error) {
    await reportFailure(error);
  }
}

/** @param {string} out */
function checkedPlace(out) {
  try {
    return { folder: siteFolder(out), url: values.url === undefined ? undefined : siteAddress(values.url) };
  } catch (error) {
    return refuse(/** @type {Error} */ (error).message);
  }
}

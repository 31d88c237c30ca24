/** A small HTTP server for files in memory: the games while they are developed, and the pages of browser tests. */
import { createServer } from 'node:http';
import { extname } from 'node:path';

const contentTypes = /** @type {Record<string, string>} */ ({
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.map': 'application/json',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.webp': 'image/webp',
  '.wasm': 'application/wasm',
});

/** With these a page is cross-origin isolated: SharedArrayBuffer exists and timers resolve 5 µs. */
const headers = {
  'Cache-Control': 'no-store',
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

/**
 * @typedef {string | Uint8Array | undefined} Content
 * @typedef {import('node:http').ServerResponse} ServerResponse
 * @typedef {{ port: number, url: string, close(): Promise<void> }} RunningServer
 */

/**
 * Serves what `find` returns for a path such as `/orbit/main.js`; a path that ends in `/` means its `index.html`, and
 * one without the `/` is sent there. `special` may take over a request and then returns true.
 * @param {object} options
 * @param {(path: string) => Content} options.find
 * @param {(path: string, response: ServerResponse) => boolean} [options.special]
 * @param {readonly number[]} [options.ports] tried in order; 0 is any free port
 * @param {string} [options.host]
 * @returns {Promise<RunningServer>}
 */
export async function serveFiles({ find, special, ports = [0], host = '127.0.0.1' }) {
  const server = createServer((request, response) => {
    const path = pathOf(request.url ?? '/');
    if (special?.(path, response)) return;
    const name = path.endsWith('/') ? `${path}index.html` : path;
    const content = find(name);
    if (content === undefined && find(`${path}/index.html`) !== undefined) {
      response.writeHead(302, { ...headers, Location: `${path}/` }).end();
      return;
    }
    const type = contentTypes[extname(name)] ?? 'application/octet-stream';
    if (content !== undefined) response.writeHead(200, { ...headers, 'Content-Type': type }).end(content);
    else response.writeHead(404, { ...headers, 'Content-Type': 'text/plain' }).end(`Nothing is served at ${path}\n`);
  });
  await listen(server, host, ports);
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return { port, url: `http://127.0.0.1:${port}/`, close: () => close(server) };
}

/** @param {string} url */
function pathOf(url) {
  try {
    return decodeURIComponent(new URL(url, 'http://localhost').pathname);
  } catch {
    return '/malformed-address';
  }
}

/**
 * @param {import('node:http').Server} server
 * @param {string} host
 * @param {readonly number[]} ports
 */
async function listen(server, host, ports) {
  for (const port of ports) {
    const taken = await new Promise((resolve, reject) => {
      server.once('error', (/** @type {NodeJS.ErrnoException} */ error) => {
        if (error.code === 'EADDRINUSE' || error.code === 'EACCES') resolve(true);
        else
          reject(
            new Error(`Nothing can be served at ${host} (${error.code}): --host must be an address of this machine.`),
          );
      });
      server.listen(port, host, () => resolve(false));
    });
    server.removeAllListeners('error');
    server.removeAllListeners('listening');
    if (!taken) return;
  }
  throw new Error(`No free port among ${ports.join(', ')}: close another server or name one with --port.`);
}

/** @param {import('node:http').Server} server */
function close(server) {
  return /** @type {Promise<void>} */ (
    new Promise((resolve, reject) => {
      server.close((error) => (error ? reject(error) : resolve()));
      server.closeAllConnections();
    })
  );
}

/** The service worker of the static site: after the first visit every page works without the internet. */
import { createHash } from 'node:crypto';

/**
 * The source of a worker that keeps all files of the site. Scripts come from the cache, pages from the network where there is
 * one. A new version of the site waits until no page of the old one is open, since pages load parts of themselves later.
 * @param {Readonly<Record<string, string | Uint8Array>>} contents of the files of the site, by their paths there
 */
export function serviceWorker(contents) {
  const files = Object.keys(contents)
    .filter((file) => !file.endsWith('.map'))
    .sort();
  const hash = createHash('sha256');
  for (const file of files) hash.update(file).update(contents[file]);
  return `const CACHE = 'principia ' + registration.scope + ' ${hash.digest('hex').slice(0, 16)}';
const FILES = ${JSON.stringify(files)};
addEventListener('install', (event) => event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(FILES))));
addEventListener('activate', (event) => event.waitUntil(removeOthers()));
addEventListener('fetch', (event) => {
  const { method, url, mode } = event.request;
  if (method !== 'GET' || !url.startsWith(registration.scope)) return;
  if (mode === 'navigate') event.respondWith(fetch(event.request).catch(() => kept(url).then((page) => page ?? Response.error())));
  else event.respondWith(kept(url).then((file) => file ?? fetch(event.request)));
});
async function kept(url) {
  const file = new URL(url);
  if (file.pathname.endsWith('/')) file.pathname += 'index.html';
  return (await caches.open(CACHE)).match(file, { ignoreSearch: true });
}
async function removeOthers() {
  const names = await caches.keys();
  const own = 'principia ' + registration.scope + ' ';
  await Promise.all(names.filter((name) => name.startsWith(own) && name !== CACHE).map((name) => caches.delete(name)));
}
`;
}

/**
 * A page that starts the worker when it has loaded.
 * @param {string} html
 * @param {string} path of the worker, relative to the page
 */
export function withServiceWorker(html, path) {
  const script = `<script>
if ('serviceWorker' in navigator && location.protocol !== 'file:') {
  addEventListener('load', function () { navigator.serviceWorker.register('${path}').catch(function () {}); });
}
</script>`;
  return html.replace('</body>', `${script}\n</body>`);
}

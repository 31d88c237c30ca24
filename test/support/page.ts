/** Serves one bundled TypeScript file as a page, so that a browser test runs the sources as they are. */
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import type { Browser, Page } from 'playwright-core';
import { buildKernels } from '../../scripts/build-kernels.mjs';
import { bundleOptions } from '../../scripts/lib/bundle.mjs';
import { serveFiles } from '../../scripts/lib/static-server.mjs';

export type ServedPage = { url: string; close(): Promise<void> };

export type PageOptions = {
  /** Markup for the body (`<canvas id="stage"></canvas>`), or a whole page that loads `./main.js` itself. */
  html?: string;
};

/**
 * Bundles `entry` (an absolute path, one from the repository root, or `new URL('./x.ts', import.meta.url)`) in
 * memory and serves it on a free port. The page is cross-origin isolated: SharedArrayBuffer and 5 µs timers work.
 */
export async function servePage(entry: string | URL, { html = '' }: PageOptions = {}): Promise<ServedPage> {
  await buildKernels({ quiet: true });
  const entryPath = entry instanceof URL ? fileURLToPath(entry) : entry;
  const { outputFiles } = await build({
    // The map lies beside the program: within it, every page would read ten megabytes more.
    ...bundleOptions({}),
    // As on the site: a page reads what it needs and no more.
    splitting: true,
    entryPoints: { main: entryPath },
    outdir: '/',
    write: false,
  });
  const files = new Map<string, string | Uint8Array>([['/index.html', wholePage(html)]]);
  for (const file of outputFiles) files.set(`/${file.path.split(/[\\/]/).pop()}`, file.contents);
  return serveFiles({ find: (path) => files.get(path) });
}

/** Opens `url` in a page of its own; `errors` fills with every uncaught error, so a test can expect it empty. */
export async function openPage(browser: Browser, url: string): Promise<{ page: Page; errors: string[] }> {
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  await page.goto(url);
  return { page, errors };
}

function wholePage(html: string): string {
  if (/^\s*<!doctype/i.test(html)) return html;
  return `<!doctype html>
<html lang="en">
<head><meta charset="utf-8"><title>Principia test page</title><link rel="icon" href="data:,">
<style>body { margin: 0 }</style></head>
<body>${html}<script type="module" src="./main.js"></script></body>
</html>`;
}

// The page of docs/in-your-own-project.md that needs no bundler, opened in a browser under the Content-Security-Policy that
// the same page recommends. What it asks of the CDN is answered from the built packages.
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { beforeAll, expect, test } from 'vitest';
import { buildPackages } from '../../scripts/build-packages.mjs';
import { drawingMapOf, htmlOf, importMapOf } from '../support/import-map.ts';
import { shareBrowser } from '../support/shared-browser.ts';

const guide = readFileSync('docs/in-your-own-project.md', 'utf8');
const html = htmlOf(guide);
const ORIGIN = 'http://own-project.test/';
const browser = shareBrowser();

beforeAll(async () => {
  await buildPackages();
});

/** The file behind an address such as https://cdn.jsdelivr.net/npm/bitecs@0.4.0/dist/core/index.min.mjs. */
function fileOf(address: string): string {
  const [, name, path] = /\/npm\/(@?[^@]+)@[^/]+\/(.*)$/.exec(address) ?? [];
  return `node_modules/${name}/${path}`;
}

async function openUnder(scriptSources: string, body = html): Promise<{ page: Page; errors: string[] }> {
  const page = await browser().newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  await page.route('https://cdn.jsdelivr.net/**', (route) =>
    route.fulfill({
      body: readFileSync(fileOf(route.request().url())),
      contentType: 'text/javascript',
      headers: { 'access-control-allow-origin': '*' },
    }),
  );
  await page.route(ORIGIN, (route) =>
    route.fulfill({
      body: `<!doctype html><title>…</title>${body.replaceAll('<script ', '<script nonce="page" ')}`,
      contentType: 'text/html; charset=utf-8',
      headers: { 'content-security-policy': `script-src 'nonce-page' https://cdn.jsdelivr.net ${scriptSources}` },
    }),
  );
  await page.goto(ORIGIN, { waitUntil: 'networkidle' });
  return { page, errors };
}

test('the page with an import map runs under the recommended policy', async () => {
  const { page, errors } = await openUnder("'wasm-unsafe-eval'");
  expect(errors).toEqual([]);
  // 10 m - g t²/2 with g = 10 m/s² after one second; velocity Verlet is exact for constant forces.
  expect(await page.title()).toBe('The ball is at 5.00 m.');
  await page.close();
});

test('without wasm-unsafe-eval the error names what is missing', async () => {
  const { page, errors } = await openUnder('');
  expect(errors.join()).toMatch(/forbids compiling WebAssembly/);
  expect(errors.join()).toMatch(/'wasm-unsafe-eval'/);
  await page.close();
});

test.each(['render-pixi', 'render-three'])(
  'the program of the front page of %s runs with the maps',
  async (renderer) => {
    const imports = { ...importMapOf(guide), ...drawingMapOf(guide, renderer) };
    const [, program] = /```ts\n([\s\S]*?)```/.exec(readFileSync(`packages/${renderer}/README.md`, 'utf8')) ?? [];
    const code = program?.replace('createPhysicsWorld({', "createPhysicsWorld({ precision: 'f32',");
    const { page, errors } = await openUnder(
      // pixi.js compiles functions from text.
      "'wasm-unsafe-eval' 'unsafe-eval'",
      `<body><script type="importmap">${JSON.stringify({ imports })}</script>
    <script type="module">${code}; document.title = 'It runs.';</script>`,
    );
    await expect.poll(() => page.title(), { timeout: 20_000 }).toBe('It runs.');
    await page.waitForTimeout(500);
    expect(errors).toEqual([]);
    await page.close();
  },
);

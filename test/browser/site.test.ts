/** The static site as `npm run build` writes it: in a folder below another, without the internet, every game played. */
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { writeSite } from '../../scripts/lib/site-build.mjs';
import { gameNames, gamePicture } from '../../scripts/lib/site-pages.mjs';
import { type RunningServer, serveFiles } from '../../scripts/lib/static-server.mjs';
import { launchChromium } from '../support/chromium.ts';

const PREFIX = '/some/sub/path';

const names = gameNames();
let folder: string;
let server: RunningServer;
let browser: Browser;
let home: string;

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'principia-site-'));
  await writeSite(folder);
  server = await serveFiles({
    find(path) {
      const file = join(folder, path.slice(PREFIX.length));
      const isThere = path.startsWith(`${PREFIX}/`) && existsSync(file) && statSync(file).isFile();
      return isThere ? readFileSync(file) : undefined;
    },
  });
  home = `${server.url.slice(0, -1)}${PREFIX}/`;
  browser = await launchChromium();
});

afterAll(async () => {
  await browser?.close();
  await server?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** A page for which there is nothing but the folder; `trouble` fills with what goes wrong. */
async function openHome(options: Parameters<Browser['newContext']>[0] = {}) {
  const context = await browser.newContext({ viewport: { width: 800, height: 600 }, ...options });
  const trouble: string[] = [];
  await context.route('**/*', (route) => {
    const url = route.request().url();
    if (url.startsWith(home)) return route.continue();
    trouble.push(`asked for ${url}`);
    return route.abort();
  });
  const page = await context.newPage();
  page.on('pageerror', (error) => trouble.push(error.stack ?? error.message));
  page.on('requestfailed', (request) => trouble.push(`failed: ${request.url()}`));
  page.on(
    'response',
    (response) => response.status() >= 400 && trouble.push(`${response.status()}: ${response.url()}`),
  );
  await page.goto(home);
  return { context, page, trouble };
}

/** The canvas the game draws on; the shell's plot has one of its own. */
const stage = (page: Page) => page.locator('.game-stage canvas, body > canvas');

/** Two pictures of the canvas that differ show that something moves. */
async function moves(page: Page): Promise<boolean> {
  const canvas = stage(page);
  const before = await canvas.screenshot();
  for (let i = 0; i < 20; i++) {
    await page.waitForTimeout(100);
    if (!(await canvas.screenshot()).equals(before)) return true;
  }
  return false;
}

it('shows the pictures of the games, on a phone too', async () => {
  const phone = { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true };
  const { context, page, trouble } = await openHome(phone);
  // Pictures are loaded as they come into view.
  for (const picture of await page.locator('.games img').all()) {
    await picture.scrollIntoViewIfNeeded();
    await picture.evaluate((image: HTMLImageElement) => image.decode());
  }
  const pictures = await page
    .locator('.games img')
    .evaluateAll((images) =>
      (images as HTMLImageElement[]).map(({ naturalWidth, clientWidth }) => [naturalWidth > 0, clientWidth > 300]),
    );
  expect(pictures).toEqual(names.filter(gamePicture).map(() => [true, true]));
  expect(await page.locator('.games a').count()).toBe(names.length);
  // Nothing sticks out to the right.
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(360);
  expect(trouble).toEqual([]);
  await context.close();
});

it.each(names)('plays %s from a folder below another, without the internet', async (name) => {
  const { context, page, trouble } = await openHome();
  await page.locator(`.games a[href*="/${name}/"]`).click();
  // The laboratory begins with a list of its examples.
  if (name === 'laboratory') await page.locator('a[href*="example="]').first().click();
  await stage(page).waitFor();
  await page.waitForLoadState('load');
  await page.keyboard.press('ArrowUp');
  await page
    .locator('canvas')
    .first()
    .click({ position: { x: 200, y: 300 } });
  expect(await moves(page)).toBe(true);
  expect(trouble).toEqual([]);
  await context.close();
});

it('loads only the renderer that the address names', async () => {
  const { context, page, trouble } = await openHome();
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(`${home}bouncing-balls/index.html?renderer=three`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  expect(asked.filter((url) => /view-3d/.test(url))).toHaveLength(1);
  expect(asked.filter((url) => /view-2d/.test(url))).toEqual([]);
  expect(trouble).toEqual([]);
  await context.close();
});

it('keeps the picture where the other one cannot be loaded, and says so', async () => {
  const { context, page } = await openHome({ serviceWorkers: 'block' });
  await page.goto(`${home}bouncing-balls/index.html?renderer=pixi`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  await context.setOffline(true);
  await page.keyboard.press('3');
  await page.waitForFunction(() => __game.state().banner.includes('3D view could not be loaded'));
  await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'pixi');
  await context.setOffline(false);
  await page.locator('.game-banner button', { hasText: 'Try again' }).click();
  await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'three');
  await context.close();
});

it('has a front page of at most 120 KB with all pictures, a search, a surprise, and a scene that moves', async () => {
  const { context, page, trouble } = await openHome({ serviceWorkers: 'block' });
  const files = ['index.html', 'front-page.js', ...names.filter(gamePicture).map((name) => `${name}/picture.webp`)];
  const sizes = files.map((file) => {
    const content = readFileSync(join(folder, file));
    return file.endsWith('.webp') ? content.length : gzipSync(content).length;
  });
  for (const [i, file] of files.entries()) if (file.endsWith('.webp')) expect(sizes[i]).toBeLessThanOrEqual(15 * 1024);
  expect(sizes.reduce((sum, size) => sum + size, 0)).toBeLessThanOrEqual(120 * 1024);
  const scene = page.locator('header canvas');
  const before = await scene.screenshot();
  await page.waitForTimeout(500);
  expect((await scene.screenshot()).equals(before)).toBe(false);
  await page.locator('input').fill('black');
  expect(await page.locator('.games li:visible').allTextContents()).toEqual([expect.stringContaining('Black hole')]);
  await page.locator('button', { hasText: 'Surprise me' }).click();
  await page.waitForURL(/black-hole/);
  expect(trouble).toEqual([]);
  await context.close();
});

it('works without the internet after the first visit, every page and both renderers', async () => {
  const { context, page } = await openHome();
  await page.evaluate(() => navigator.serviceWorker.ready);
  await context.unrouteAll();
  await context.setOffline(true);
  await page.goto(`${home}bouncing-balls/?renderer=pixi`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  await page.keyboard.press('3');
  await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'three');
  await page.goto(home);
  expect(await page.locator('.games a').count()).toBe(names.length);
  await context.close();
});

it('says how to serve it when it is opened straight from the folder', async () => {
  const context: BrowserContext = await browser.newContext();
  const page = await context.newPage();
  for (const file of ['index.html', `${names[0]}/index.html`]) {
    await page.goto(pathToFileURL(join(folder, file)).href);
    expect(await page.locator('[role=alert]').first().textContent()).toContain('Serve the folder');
  }
  await context.close();
});

it('has no address of another place in it', () => {
  const html = ['index.html', ...names.map((name) => `${name}/index.html`)].map((file) =>
    readFileSync(join(folder, file), 'utf8'),
  );
  for (const page of html) expect(page).not.toMatch(/(?:src|href)="(?:https?:)?\//);
});

/** The static site as `npm run build` writes it: in a folder below another, without the internet, every game played. */
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import type { BrowserContext, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, it } from 'vitest';
import { WORDS_BY_LANGUAGE as FRONT_PAGE } from '../../games/front-page/words.mjs';
import { writeSite } from '../../scripts/lib/site-build.mjs';
import { gameNames, gamePage, gamePicture } from '../../scripts/lib/site-pages.mjs';
import { type RunningServer, serveFiles } from '../../scripts/lib/static-server.mjs';
import { faintTexts, smallTargets, unreachedControls } from '../support/page-audit.ts';
import { shareBrowser } from '../support/shared-browser.ts';

const PREFIX = '/some/sub/path';

const names = gameNames();
let folder: string;
let server: RunningServer;
const browser = shareBrowser();
const contexts: BrowserContext[] = [];
let home: string;

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'principia-site-'));
  // As a shell completes it.
  await writeSite(`${relative(process.cwd(), folder)}/`);
  server = await serveFiles({
    find(path) {
      const file = join(folder, path.slice(PREFIX.length));
      const isThere = path.startsWith(`${PREFIX}/`) && existsSync(file) && statSync(file).isFile();
      return isThere ? readFileSync(file) : undefined;
    },
  });
  home = `${server.url.slice(0, -1)}${PREFIX}/`;
});

afterAll(async () => {
  await server?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** A context that lives as long as the test, and no longer where the test fails. */
async function newContext(options: BrowserContextOptions = {}): Promise<BrowserContext> {
  const context = await browser().newContext({ viewport: { width: 800, height: 600 }, ...options });
  contexts.push(context);
  return context;
}

afterEach(async () => {
  for (const context of contexts.splice(0)) await context.close();
});

/**
 * A page for which there is nothing but the folder; `trouble` fills with what goes wrong. Without the service worker, which
 * would fetch the whole site in each test.
 */
async function openHome(options: BrowserContextOptions = {}) {
  const context = await newContext({ serviceWorkers: 'block', ...options });
  const trouble: string[] = [];
  await context.route('**/*', (route) => {
    const url = route.request().url();
    if (url.startsWith(home)) return route.continue();
    trouble.push(`asked for ${url}`);
    return route.abort();
  });
  const page = await context.newPage();
  page.on('pageerror', (error) => trouble.push(error.stack ?? error.message));
  page.on('requestfailed', (request) => {
    const reason = request.failure()?.errorText;
    // A page that is left gives up the pictures it has not yet got.
    if (reason !== 'net::ERR_ABORTED') trouble.push(`failed: ${request.url()} (${reason})`);
  });
  page.on(
    'response',
    (response) => response.status() >= 400 && trouble.push(`${response.status()}: ${response.url()}`),
  );
  await page.goto(home);
  return { context, page, trouble };
}

/** The canvas the game draws on; the shell's plot has one of its own, and instruments come after it. */
const stage = (page: Page) => page.locator('.game-stage canvas, body > canvas').first();

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
  const { page, trouble } = await openHome(phone);
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
});

it.each(names)('plays %s from a folder below another, without the internet', async (name) => {
  const { page, trouble } = await openHome();
  await page.locator(`.games a[href*="/${name}/"]`).click();
  // The laboratory begins with a list of its examples.
  if (name === 'laboratory') await page.locator('.start li a').first().click();
  await stage(page).waitFor();
  await page.waitForLoadState('load');
  await page.keyboard.press('ArrowUp');
  await page
    .locator('canvas')
    .first()
    .click({ position: { x: 400, y: 300 } });
  expect(await moves(page)).toBe(true);
  expect(trouble).toEqual([]);
});

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true } as const;

/** What can be read, pressed and reached by keyboard, and what cannot. */
async function expectAccess(page: Page): Promise<void> {
  expect(await faintTexts(page)).toEqual([]);
  expect(await smallTargets(page)).toEqual([]);
  expect(await unreachedControls(page)).toEqual([]);
}

const shellGames = names.filter((name) => !['laboratory', 'first-game'].includes(name));

it.each([
  ...shellGames.map((name) => [name, `${name}/index.html?manual`]),
  ['an example of the laboratory', 'laboratory/index.html?manual&example=ch17-figure-eight'],
])('can be read, pressed and reached by keyboard on a phone: %s', async (_name, address) => {
  const { page } = await openHome(PHONE);
  await page.goto(home + address);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  const side = page.locator('.game-side');
  if (!(await side.isVisible())) await page.keyboard.press('p');
  await side.waitFor({ state: 'visible' });
  await expectAccess(page);
});

it.each([
  ['the front page', 'index.html', '.games a'],
  ['the list of the laboratory', 'laboratory/index.html', '.start-picture svg'],
  ['first-game', 'first-game/index.html', 'canvas'],
])('can be read, pressed and reached by keyboard on a phone: %s', async (_name, address, until) => {
  const { page } = await openHome(PHONE);
  await page.goto(home + address);
  await page.locator(until).first().waitFor();
  await expectAccess(page);
});

it('finds texts of too little contrast, small buttons, and buttons that Tab misses', async () => {
  const { page } = await openHome();
  await page.setContent(`<body style="background: #222"><p style="color: #777">grey</p><p style="color: #8f8f8f">paler</p>
<button style="all: unset; width: 20px">small</button><button style="padding: 30px" tabindex="-1">hidden from keys</button></body>`);
  // Of #777 on #222 it is 3.56, of #8f8f8f 4.9.
  expect(await faintTexts(page)).toEqual([
    expect.stringMatching(/“grey”.* 3\.\d+ : 1/),
    expect.stringContaining('“small”'),
  ]);
  expect(await smallTargets(page)).toEqual([expect.stringContaining('“small”')]);
  expect(await unreachedControls(page)).toEqual([
    expect.stringContaining('“small” () does not show its focus'),
    expect.stringContaining('“hidden from keys” () is not reached by Tab'),
  ]);
});

it('loads only the renderer that the address names', async () => {
  const { page, trouble } = await openHome();
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(`${home}bouncing-balls/index.html?renderer=three`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  expect(asked.filter((url) => /view-3d/.test(url))).toHaveLength(1);
  expect(asked.filter((url) => /view-2d/.test(url))).toEqual([]);
  expect(trouble).toEqual([]);
});

it('keeps the picture where the other one cannot be loaded, and says so', async () => {
  const { context, page } = await openHome();
  await page.goto(`${home}bouncing-balls/index.html?renderer=pixi`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  await context.setOffline(true);
  await page.keyboard.press('3');
  await page.waitForFunction(() => __game.state().banner.includes('3D view could not be loaded'));
  await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'pixi');
  await context.setOffline(false);
  await page.locator('.game-banner button', { hasText: 'Try again' }).click();
  await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'three');
});

it('has a front page of at most 120 KB with all pictures, a search, a surprise, and a scene that moves', async () => {
  const { page, trouble } = await openHome();
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
});

it('leads from a search of the front page without a game to that of the laboratory', async () => {
  const { page, trouble } = await openHome();
  await page.locator('input').fill('double pendulum');
  await page.locator('.nothing a').click();
  await page.waitForURL(/laboratory\/index\.html\?search=double/);
  expect(await page.locator('input').inputValue()).toBe('double pendulum');
  await page.locator('section').first().waitFor();
  await page.goto(`${home}index.html?lang=de`);
  await page.locator('input').fill('orbit');
  await page.keyboard.press('Enter');
  await page.waitForURL(/laboratory\/.*lang=de/);
  expect(new URL(page.url()).searchParams.get('search')).toBe('orbit');
  expect(trouble).toEqual([]);
});

/** Large enough for the head of the front page and some cards at once. */
const DESK = { viewport: { width: 1280, height: 1100 } } as const;
const liveNames = names.filter((name) => /<meta name="live"/.test(gamePage(name)));
const cardOf = (page: Page, name: string) => page.locator(`.games li:has(a[href*="/${name}/"])`);
const frames = (page: Page) => page.locator('iframe').count();
/** Longer than a pointer has to rest. */
const REST = 900;

/** What the scene at the head of the front page shows. */
const dust = (page: Page) => page.locator('header canvas').evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());

it.each(liveNames)('lets the card of %s come alive under the pointer, and nothing else meanwhile', async (name) => {
  const { page, trouble } = await openHome(DESK);
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  const card = cardOf(page, name);
  await card.scrollIntoViewIfNeeded();
  await card.hover();
  await page.locator('iframe[data-ready]').waitFor({ state: 'attached', timeout: 60_000 });
  expect(page.frames()).toHaveLength(2);
  const [, game] = page.frames();
  const tick = () => game.evaluate(() => __game.state().tick);
  const before = { tick: await tick(), dust: await dust(page) };
  await game.waitForFunction((first) => __game.state().tick > first, before.tick);
  expect(await dust(page)).toBe(before.dust);
  // Nothing but the picture is seen, and nothing is kept.
  expect(await game.locator('.game > :not(.game-stage):visible, .game-stage > :not(canvas):visible').count()).toBe(0);
  expect(await game.evaluate(() => Object.keys(localStorage))).toEqual([]);
  await page.mouse.move(2, 2);
  await expect.poll(() => frames(page)).toBe(0);
  await page.evaluate(() => scrollTo(0, 0));
  await expect.poll(() => dust(page)).not.toBe(before.dust);
  expect([...trouble, ...said.filter((line) => !/GPU stall|Service Worker/.test(line))]).toEqual([]);
});

it('has one live card at most, none for a pointer in passing, and still leads to the game', async () => {
  const { page, trouble } = await openHome(DESK);
  await page.evaluate(() => {
    const { dataset } = document.documentElement;
    const count = () => {
      dataset.most = String(Math.max(Number(dataset.most ?? 0), document.querySelectorAll('iframe').length));
    };
    new MutationObserver(count).observe(document.body, { childList: true, subtree: true });
  });
  const most = () => page.evaluate(() => Number(document.documentElement.dataset.most ?? 0));
  const [first, second] = [cardOf(page, 'black-hole'), cardOf(page, 'solar-system')];
  await first.hover();
  await page.mouse.move(2, 2);
  await page.waitForTimeout(REST);
  expect(await most()).toBe(0);
  for (const card of [first, second, first]) {
    await card.hover();
    await card.locator('iframe').waitFor({ state: 'attached' });
    expect(await frames(page)).toBe(1);
  }
  expect(await most()).toBe(1);
  await page.locator('input').fill('solar');
  expect(await frames(page)).toBe(0);
  await page.mouse.move(2, 2);
  await second.hover();
  await second.locator('iframe[data-ready]').waitFor({ state: 'attached', timeout: 60_000 });
  await page.mouse.down();
  await page.mouse.up();
  await page.waitForURL(/solar-system\/index\.html$/);
  expect(trouble).toEqual([]);
});

it('lets a card come alive on which the focus of the keyboard rests, and Tab goes past the game', async () => {
  const { page } = await openHome(DESK);
  await page.locator('button').focus();
  await page.keyboard.press('Tab');
  const card = cardOf(page, 'black-hole');
  await card.locator('iframe[data-ready]').waitFor({ state: 'attached', timeout: 60_000 });
  await page.keyboard.press('Tab');
  expect(await frames(page)).toBe(0);
  expect(await page.evaluate(() => document.activeElement?.matches('.games a'))).toBe(true);
});

it.each([
  ['on a touch screen', PHONE, ''],
  ['with reduced motion', { ...DESK, reducedMotion: 'reduce' }, ''],
  ['where data are saved', DESK, 'Object.defineProperty(navigator, "connection", { value: { saveData: true } })'],
] as const)('has still cards %s', async (_where, options, prepare) => {
  const { page } = await openHome(options);
  await page.addInitScript(prepare);
  await page.reload();
  const card = cardOf(page, 'black-hole');
  await card.hover();
  await page.waitForTimeout(REST);
  expect(await frames(page)).toBe(0);
  await page.locator('button').focus();
  await page.keyboard.press('Tab');
  await page.waitForTimeout(REST);
  expect(await frames(page)).toBe(0);
});

it.each([
  ['de-AT', ''],
  ['en-GB', '?lang=de'],
])('has a front page in German for a browser in %s and the address “%s”', async (locale, query) => {
  const { page, trouble } = await openHome({ ...PHONE, locale });
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  await page.goto(`${home}index.html${query}`);
  expect(await page.locator('html').getAttribute('lang')).toBe('de');
  expect(await page.title()).toBe(FRONT_PAGE.de.title);
  const text = (await page.locator('body').innerText()).replaceAll('\n', ' ');
  const written = (html: string) => html.replace(/<[^>]*>/g, '');
  for (const name of ['title', 'lead', 'about', 'surprise', 'game', 'toy', 'lab', 'touch', 'privacy'] as const) {
    expect(text).toContain(written(FRONT_PAGE.de[name]));
    if (name !== 'title') expect(text).not.toContain(written(FRONT_PAGE.en[name]));
  }
  expect(await page.locator('input').getAttribute('placeholder')).toBe(FRONT_PAGE.de.search);
  expect(await page.locator('.games :is(b, span):not([data-de])').count()).toBe(0);
  expect(text).not.toContain(written(FRONT_PAGE.de.keys));
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  await page.locator('input').fill('Quastenflosser');
  expect(await page.locator('main').innerText()).toContain(written(FRONT_PAGE.de.nothing));
  await page.locator('input').fill('Schwarzes Loch');
  expect(await page.locator('.nothing').isVisible()).toBe(false);
  await page.locator('.games li:visible a').click();
  await page.waitForURL(`**/black-hole/index.html${query}`);
  await page.waitForFunction(() => document.title === 'Schwarzes Loch');
  if (query !== '') expect(await page.locator('.game-bar a').getAttribute('href')).toContain('lang=de');
  expect([...trouble, ...said.filter((line) => !/GPU stall|Service Worker/.test(line))]).toEqual([]);
});

it('works without the internet after the first visit, every page and both renderers', async () => {
  const context = await newContext();
  const page = await context.newPage();
  await page.goto(home);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await context.setOffline(true);
  await page.goto(`${home}bouncing-balls/?renderer=pixi`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  await page.keyboard.press('3');
  await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'three');
  await page.goto(home);
  expect(await page.locator('.games a').count()).toBe(names.length);
});

it('says how to serve it when it is opened straight from the folder', async () => {
  const context = await newContext();
  const page = await context.newPage();
  for (const file of ['index.html', `${names[0]}/index.html`]) {
    await page.goto(pathToFileURL(join(folder, file)).href);
    expect(await page.locator('[role=alert]').first().textContent()).toContain('Serve the folder');
  }
});

it('has no address of another place in it', () => {
  const html = ['index.html', ...names.map((name) => `${name}/index.html`)].map((file) =>
    readFileSync(join(folder, file), 'utf8'),
  );
  for (const page of html) expect(page).not.toMatch(/(?:src|href)="(?:https?:)?\//);
});

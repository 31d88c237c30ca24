/** A game's real page in a browser, served, opened and watched for errors: what every test that plays a game needs. */
import { readFileSync } from 'node:fs';
import type { BodyState, GameState } from '@principia/shell';
import type { BrowserContext, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect } from 'vitest';
import { type ServedPage, servePage } from './page.ts';
import { shareBrowser } from './shared-browser.ts';

/** How a page is opened: everything a browser context takes (viewport, hasTouch, acceptDownloads, reducedMotion…). */
export interface OpenOptions extends BrowserContextOptions {
  /** Runs in the page before anything of the game does. */
  readonly prepare?: () => void;
  /** What to wait for. Default: the game's picture. */
  readonly until?: 'picture' | 'game' | 'nothing';
}

/** A game that is served as long as the tests of a file, or of a `describe`, run. */
export interface PlayedGame {
  /** Where it is served. */
  readonly url: string;
  /**
   * Opens `?query` (a `#…` may follow) in a context of its own, which is closed after the test. Errors that nobody
   * catches fail the test.
   */
  open(query?: string, options?: OpenOptions): Promise<Page>;
}

/**
 * Serves `games/<name>` to the tests that follow.
 * @param defaults options of every page, unless it has its own
 * @param args further flags of the browser
 */
export function playGame(name: string, defaults: OpenOptions = {}, args: readonly string[] = []): PlayedGame {
  const browser = shareBrowser({ args });
  let served: ServedPage | undefined;
  let errors: string[] = [];
  const contexts: BrowserContext[] = [];

  beforeAll(async () => {
    const html = readFileSync(`games/${name}/index.html`, 'utf8');
    served = await servePage(`games/${name}/main.ts`, { html });
  });

  afterAll(() => served?.close());

  afterEach(async () => {
    for (const context of contexts.splice(0)) await context.close();
    const seen = errors;
    errors = [];
    expect(seen).toEqual([]);
  });

  return {
    get url() {
      return (served as ServedPage).url;
    },
    async open(query = '', options = {}) {
      const { prepare, until = 'picture', ...rest } = { ...defaults, ...options };
      const context = await browser().newContext(rest);
      // A busy machine without a graphics card draws one frame a second.
      context.setDefaultTimeout(60_000);
      contexts.push(context);
      context.on('page', (page) => page.on('pageerror', (error) => errors.push(error.stack ?? error.message)));
      const page = await context.newPage();
      if (prepare !== undefined) await page.addInitScript(prepare);
      await page.goto(`${served?.url}?${query}`);
      if (until !== 'nothing') await ready(page, until);
      return page;
    },
  };
}

/** Resolves when the game is there, or its picture as well. */
export async function ready(page: Page, until: 'picture' | 'game' = 'picture'): Promise<void> {
  await page.waitForFunction(() => globalThis.__game !== undefined);
  if (until === 'picture') await page.waitForFunction(() => __game.state().ready);
}

export const state = (page: Page): Promise<GameState> => page.evaluate(() => __game.state());
export const body = (page: Page, index: number): Promise<BodyState> => page.evaluate((i) => __game.body(i), index);
/** Steps of a game that was opened with `manual`. */
export const steps = (page: Page, count: number) => page.evaluate((n) => __game.step(n), count);

/**
 * Takes steps if the game reports what is wanted, with no picture between the two.
 * @returns whether it did
 */
export const stepsIf = (page: Page, wanted: Readonly<Record<string, unknown>>, count: number): Promise<boolean> =>
  page.evaluate(
    ([wanted, count]) => {
      const { game } = __game.state();
      if (Object.entries(wanted).some(([name, value]) => game[name] !== value)) return false;
      __game.step(count);
      return true;
    },
    [wanted, count] as const,
  );

/** For `prepare`: lets `withoutPictures` keep the page from drawing. */
export function holdablePictures(): void {
  const ask = requestAnimationFrame.bind(globalThis);
  let held: FrameRequestCallback[] | undefined;
  globalThis.requestAnimationFrame = (callback) => (held === undefined ? ask(callback) : held.push(callback));
  Object.assign(globalThis, {
    holdPictures(isHeld: boolean) {
      const waiting = held ?? [];
      held = isHeld ? waiting : undefined;
      if (!isHeld) for (const callback of waiting) ask(callback);
    },
  });
}

/**
 * Does something while the page draws nothing, so that inputs arrive at once also where the processor draws. The page was
 * opened with `prepare: holdablePictures`.
 */
export async function withoutPictures(page: Page, act: () => Promise<unknown>): Promise<void> {
  const hold = (isHeld: boolean) =>
    page.evaluate((on) => (globalThis as unknown as { holdPictures(on: boolean): void }).holdPictures(on), isHeld);
  await hold(true);
  await act();
  await hold(false);
}

/** Two pictures, as the display shows them, since a change of the world shows in the second at the latest. */
export const frames = (page: Page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** The picture as a PNG, without what the shell and the game write over it. @param more selectors to hide as well */
export async function pictureOf(page: Page, ...more: string[]): Promise<Buffer> {
  await frames(page);
  const hidden = ['.game > :not(.game-stage)', '.game-hint', ...more].join();
  return page.screenshot({ style: `${hidden} { display: none !important }` });
}

export type Finger = { readonly x: number; readonly y: number; readonly id?: number };

/** Touches the page as the browser's own input does: `touchPoints` are all fingers that are down afterwards. */
export async function fingersOf(page: Page) {
  const client = await page.context().newCDPSession(page);
  return (type: 'touchStart' | 'touchMove' | 'touchEnd' | 'touchCancel', fingers: readonly Finger[] = []) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints: [...fingers] });
}

/** Takes the graphics card away, and waits until the game says so. Returns how to give it back. */
export async function loseGraphicsCard(page: Page): Promise<() => Promise<void>> {
  const card = await page.evaluateHandle(() => {
    const canvas = document.querySelector('.game-stage canvas') as HTMLCanvasElement;
    const gl = canvas.getContext('webgl2') as WebGL2RenderingContext;
    const found = gl.getExtension('WEBGL_lose_context') as WEBGL_lose_context;
    found.loseContext();
    return found;
  });
  await page.waitForFunction(() => __game.state().banner.includes('Graphics interrupted'));
  return async () => {
    await card.evaluate((found) => found.restoreContext());
    await page.waitForFunction(() => __game.state().banner === '');
  };
}

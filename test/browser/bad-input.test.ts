/** What befalls a page in real life: each game says so in a sentence, or simply survives. */
import { readFileSync } from 'node:fs';
import type { GameState } from '@principia/shell';
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { launchChromium } from '../support/chromium.ts';
import { type ServedPage, servePage } from '../support/page.ts';

let browser: Browser;
let context: BrowserContext;
let errors: string[] = [];

beforeAll(async () => {
  browser = await launchChromium();
});

afterAll(() => browser?.close());

afterEach(async () => {
  await context?.close();
  const seen = errors;
  errors = [];
  expect(seen).toEqual([]);
});

const state = (page: Page): Promise<GameState> => page.evaluate(() => __game.state());

/** A world that goes on when it is told to: whatever happened did not kill it. */
async function expectAlive(page: Page) {
  const { tick } = await state(page);
  await page.evaluate(() => __game.step(10));
  expect((await state(page)).tick).toBeGreaterThanOrEqual(tick + 10);
}

describe.each(['black-hole', 'bouncing-balls'])('%s', (game) => {
  let served: ServedPage;

  beforeAll(async () => {
    const html = readFileSync(`games/${game}/index.html`, 'utf8');
    served = await servePage(`games/${game}/main.ts`, { html });
  });

  afterAll(() => served?.close());

  async function open(query = '', prepare?: () => void): Promise<Page> {
    context = await browser.newContext({ viewport: { width: 640, height: 420 }, hasTouch: true });
    const page = await context.newPage();
    page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
    if (prepare !== undefined) await page.addInitScript(prepare);
    await page.goto(`${served.url}?${query}`);
    await page.waitForFunction(() => globalThis.__game !== undefined);
    return page;
  }

  it('says so where there is no WebGL, and the world is there all the same', async () => {
    const page = await open('manual', () => {
      const { getContext } = HTMLCanvasElement.prototype;
      const only2d = function (this: HTMLCanvasElement, kind: string, ...more: unknown[]) {
        return kind === '2d' ? (getContext as (...given: unknown[]) => unknown).call(this, kind, ...more) : null;
      };
      Object.assign(HTMLCanvasElement.prototype, { getContext: only2d });
      Object.assign(OffscreenCanvas.prototype, { getContext: () => null });
      Object.defineProperty(Navigator.prototype, 'gpu', { get: () => undefined });
    });
    await page.waitForFunction(() => __game.state().banner !== '');
    expect(await state(page)).toMatchObject({ ready: false });
    expect((await state(page)).banner).toMatch(/no WebGL 2.*hardware acceleration/);
    await expectAlive(page);
  });

  it('waits out a graphics card that goes away, once more and again', async () => {
    const page = await open();
    for (let turn = 0; turn < 2; turn++) {
      await page.evaluate(() => {
        const canvas = document.querySelector('.game-stage canvas') as HTMLCanvasElement;
        const gl = canvas.getContext('webgl2') as WebGL2RenderingContext;
        const card = gl.getExtension('WEBGL_lose_context') as WEBGL_lose_context;
        Object.assign(globalThis, { card });
        card.loseContext();
      });
      await page.waitForFunction(() => __game.state().banner.includes('graphics card'));
      await page.waitForTimeout(100);
      await page.evaluate(() => (globalThis as unknown as { card: WEBGL_lose_context }).card.restoreContext());
      await page.waitForFunction(() => __game.state().banner === '');
    }
    await expectAlive(page);
  });

  it('lives through a window without size, and one that is one pixel small', async () => {
    const page = await open();
    const resize = async (width: string) => {
      await page.evaluate((size) => {
        const root = document.querySelector('.game') as HTMLElement;
        root.style.cssText = size === '' ? '' : `right: auto; bottom: auto; width: ${size}; height: ${size}`;
      }, width);
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    };
    for (const size of ['0px', '1px', '0px', '']) await resize(size);
    const { banner, ready } = await state(page);
    expect({ banner, ready }).toEqual({ banner: '', ready: true });
    const { width, height } = (await page.locator('.game-stage canvas').boundingBox()) as DOMRect;
    expect([width, height]).toEqual([640, 420]);
    await expectAlive(page);
  });

  it.each([true, false])('does not make up for an hour away; told that it is hidden: %s', async (told) => {
    const page = await open('', () => {
      const ask = globalThis.requestAnimationFrame.bind(globalThis);
      Object.assign(globalThis, { lost: 0 });
      const late = () => (globalThis as unknown as { lost: number }).lost;
      globalThis.requestAnimationFrame = (callback) => ask((time) => callback(time + late()));
    });
    await page.waitForFunction(() => __game.state().tick > 3);
    const { tick } = await state(page);
    const start = Date.now();
    await page.evaluate((isTold) => {
      (globalThis as unknown as { lost: number }).lost = 3_600_000;
      if (isTold) document.dispatchEvent(new Event('visibilitychange'));
    }, told);
    await page.waitForFunction((before) => __game.state().tick > before + 2, tick);
    const after = await state(page);
    // No more than the real time since, at 120 steps a second, and one frame of a fifteenth of a second.
    expect(after.tick - tick).toBeLessThan(((Date.now() - start) / 1000 + 1 / 15) * 120 + 2);
    expect(after.banner).toBe('');
  });

  it('takes ten fingers at once, and lets go of them all', async () => {
    const page = await open('manual&seed=4');
    const client = await context.newCDPSession(page);
    const fingers = (dx: number) =>
      Array.from({ length: 10 }, (_, id) => ({ x: 40 + 35 * id + dx, y: 120 + 25 * (id % 5), id }));
    await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: fingers(0) });
    for (const dx of [4, 9, 15]) {
      await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: fingers(dx) });
      await page.evaluate(() => __game.step(5));
    }
    await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await page.evaluate(() => __game.step(1));
    const after = await state(page);
    expect(after.held).toEqual([]);
    expect(after.game.heading ?? '').toBe('');
    expect(after.banner).toBe('');
    await expectAlive(page);
  });

  it('plays without sound where Web Audio is blocked', async () => {
    const page = await open('', () => {
      const blocked = () => {
        throw new DOMException('Audio is blocked.', 'NotAllowedError');
      };
      Object.assign(globalThis, { AudioContext: blocked, webkitAudioContext: blocked });
    });
    await page.keyboard.press('ArrowUp');
    await page.waitForFunction(() => __game.state().tick > 5);
    expect((await state(page)).banner).toBe('');
  });

  it('keeps nothing, and plays, where the browser keeps nothing', async () => {
    const page = await open('manual', () => {
      Object.defineProperty(globalThis, 'localStorage', {
        get() {
          throw new DOMException('Not allowed.', 'SecurityError');
        },
      });
    });
    await page.keyboard.press('y');
    expect(await state(page)).toMatchObject({ safeColors: true, banner: '' });
    await expectAlive(page);
  });
});

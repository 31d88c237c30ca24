/** What befalls a page in real life: each game says so in a sentence, or simply survives. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { fingersOf, frames, loseGraphicsCard, playGame, state } from '../support/game-page.ts';

const games = [
  ['bouncing-balls', 'pixi'],
  ['bouncing-balls', 'three'],
  ['black-hole', 'pixi'],
  ['fireworks', 'pixi'],
  ['fireworks', 'three'],
  ['cloth', 'pixi'],
  ['cloth', 'three'],
  ['stacking', 'pixi'],
  ['solar-system', 'three'],
  ['submarine', 'pixi'],
  ['flight-simulator', 'three'],
  ['laboratory', 'pixi', 'example=ch05-floating-ball'],
  ['laboratory', 'three', 'example=ch15-bouncing-ball-3d'],
] as const;

/** A world that goes on when it is told to: whatever happened did not kill it. */
async function expectAlive(page: Page) {
  const { tick } = await state(page);
  await page.evaluate(() => __game.step(10));
  expect((await state(page)).tick).toBeGreaterThanOrEqual(tick + 10);
}

/** Runs in a page before its game: a browser that draws in two dimensions alone. */
function withoutWebGL(): void {
  const { getContext } = HTMLCanvasElement.prototype;
  const only2d = function (this: HTMLCanvasElement, kind: string, ...more: unknown[]) {
    return kind === '2d' ? (getContext as (...given: unknown[]) => unknown).call(this, kind, ...more) : null;
  };
  Object.assign(HTMLCanvasElement.prototype, { getContext: only2d });
  Object.assign(OffscreenCanvas.prototype, { getContext: () => null });
  Object.defineProperty(Navigator.prototype, 'gpu', { get: () => undefined });
}

const pages = games.map(([game, renderer, query = '']) => [game, renderer, query] as const);

describe.each(pages)('%s in %s', (game, renderer, own) => {
  const played = playGame(game, { viewport: { width: 640, height: 420 }, hasTouch: true });
  const open = (query = '', options: Parameters<typeof played.open>[1] = {}) =>
    played.open(`${own}&renderer=${renderer}&${query}`, options);

  it('says so where there is no WebGL, and the world is there all the same', async () => {
    const page = await open('manual', { prepare: withoutWebGL, until: 'game' });
    await page.waitForFunction(() => __game.state().banner !== '');
    expect(await state(page)).toMatchObject({ ready: false });
    expect((await state(page)).banner).toMatch(/no WebGL 2.*hardware acceleration/);
    await page.locator('button[title="Help (H)"]').click();
    expect(await page.locator('dialog').isVisible()).toBe(true);
    await expectAlive(page);
  });

  it('waits out a graphics card that goes away, once more and again', async () => {
    const page = await open();
    for (let turn = 0; turn < 2; turn++) {
      const giveBack = await loseGraphicsCard(page);
      await page.waitForTimeout(100);
      await giveBack();
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
      await frames(page);
    };
    for (const size of ['0px', '1px', '0px', '']) await resize(size);
    const { banner, ready } = await state(page);
    expect({ banner, ready }).toEqual({ banner: '', ready: true });
    const { width, height } = (await page.locator('.game-stage canvas').first().boundingBox()) as DOMRect;
    expect([width, height]).toEqual([640, 420]);
    await expectAlive(page);
  });

  it.each([true, false])('does not make up for an hour away; told that it is hidden: %s', async (told) => {
    const prepare = () => {
      const ask = globalThis.requestAnimationFrame.bind(globalThis);
      Object.assign(globalThis, { lost: 0 });
      const late = () => (globalThis as unknown as { lost: number }).lost;
      globalThis.requestAnimationFrame = (callback) => ask((time) => callback(time + late()));
    };
    const page = await open('', { prepare });
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
    const touch = await fingersOf(page);
    const fingers = (dx: number) =>
      Array.from({ length: 10 }, (_, id) => ({ x: 40 + 35 * id + dx, y: 120 + 25 * (id % 5), id }));
    await touch('touchStart', fingers(0));
    for (const dx of [4, 9, 15]) {
      await touch('touchMove', fingers(dx));
      await page.evaluate(() => __game.step(5));
    }
    await touch('touchEnd');
    await page.evaluate(() => __game.step(1));
    const after = await state(page);
    expect(after.dragged).toEqual([]);
    expect(after.game.held ?? []).toEqual([]);
    expect(after.game.heading ?? '').toBe('');
    expect(after.banner).toBe('');
    await expectAlive(page);
  });

  it('plays without sound where Web Audio is blocked', async () => {
    const prepare = () => {
      const blocked = () => {
        throw new DOMException('Audio is blocked.', 'NotAllowedError');
      };
      Object.assign(globalThis, { AudioContext: blocked, webkitAudioContext: blocked });
    };
    const page = await open('', { prepare });
    await page.keyboard.press('ArrowUp');
    await page.waitForFunction(() => __game.state().tick > 5);
    // A game that would sound says once that it cannot.
    if (game === 'fireworks') await page.waitForFunction(() => __game.state().banner.includes('No sound:'));
    else expect((await state(page)).banner).toBe('');
    await expectAlive(page);
  });

  it('keeps nothing, and plays, where the browser keeps nothing', async () => {
    const prepare = () => {
      Object.defineProperty(globalThis, 'localStorage', {
        get() {
          throw new DOMException('Not allowed.', 'SecurityError');
        },
      });
    };
    const page = await open('manual', { prepare });
    await page.keyboard.press('y');
    expect(await state(page)).toMatchObject({ safeColors: true, banner: '' });
    await expectAlive(page);
  });
});

describe('first-game', () => {
  const { open } = playGame('first-game');

  it('says so where there is no WebGL', async () => {
    const page = await open('', { prepare: withoutWebGL, until: 'nothing' });
    await page.locator('[role=alert]').waitFor();
    expect(await page.locator('[role=alert]').textContent()).toMatch(/cannot start here.*needs WebGL 2/);
  });
});

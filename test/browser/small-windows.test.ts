/** Games in small windows: nothing lies over what is pressed or read, and an open panel stops the game that it covers. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { playGame, state } from '../support/game-page.ts';

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true } as const;
const TABLETS = [
  [768, 1024],
  [820, 1180],
] as const;

/** Pairs of elements that are seen and overlap, by their texts. */
const overlaps = (page: Page, selector: string) =>
  page.evaluate((wanted) => {
    const seen = [...document.querySelectorAll<HTMLElement>(wanted)].filter(
      (each) => each.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && each.textContent !== '',
    );
    const boxes = seen.map((each) => each.getBoundingClientRect());
    const isOver = (a: DOMRect, b: DOMRect) =>
      Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
      Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
    return seen.flatMap((one, i) =>
      seen.slice(i + 1).flatMap((other, j) => {
        const isPart = one.contains(other) || other.contains(one);
        return !isPart && isOver(boxes[i], boxes[i + 1 + j]) ? [`${one.textContent} × ${other.textContent}`] : [];
      }),
    );
  }, selector);

describe('fireworks', () => {
  const { open } = playGame('fireworks', {});

  it.each(TABLETS)('keep their buttons below a bar of two rows, at %i × %i', async (width, height) => {
    const page = await open('manual&renderer=pixi', { ...PHONE, viewport: { width, height } });
    const heights = await page
      .locator('.game-bar :is(button, a)')
      .evaluateAll((buttons) => [...new Set(buttons.map((each) => each.getBoundingClientRect().top))]);
    expect(heights.length).toBeGreaterThan(1);
    expect(await overlaps(page, '.game-bar :is(button, a), .fw-extra')).toEqual([]);
  });
});

describe('bouncing balls', () => {
  const { open } = playGame('bouncing-balls', PHONE);
  const press = (page: Page) => page.locator('.game-bar button[title^="Settings"]').tap();
  const isPaused = (page: Page) => page.locator('.game-bar button[title^="Resume"]').isVisible();

  it.each([
    ['its button', (page: Page) => page.locator('.game-side-close').tap()],
    ['Escape', (page: Page) => page.keyboard.press('Escape')],
    ['a tap beside it', (page: Page) => page.touchscreen.tap(30, 600)],
  ])('wait behind the panel, which %s closes', async (_means, close) => {
    const page = await open('renderer=pixi&count=5');
    await press(page);
    expect(await isPaused(page)).toBe(true);
    const { tick } = await state(page);
    await page.waitForTimeout(300);
    expect((await state(page)).tick).toBe(tick);
    await close(page);
    expect(await page.locator('.game-side').isVisible()).toBe(false);
    expect(await isPaused(page)).toBe(false);
    await page.waitForFunction((before) => __game.state().tick > before, tick);
  });

  it('stay paused behind the panel if the player had paused them, and run if the player resumes them', async () => {
    const page = await open('renderer=pixi&count=5');
    const toggle = () => page.locator('.game-bar button:is([title^="Pause"], [title^="Resume"])').tap();
    await toggle();
    await press(page);
    await press(page);
    expect(await isPaused(page)).toBe(true);
    await press(page);
    await toggle();
    await press(page);
    expect(await isPaused(page)).toBe(false);
  });

  it('tell screen readers the names of lists and the limits of sliders', async () => {
    const page = await open('renderer=pixi&count=5', { viewport: { width: 1000, height: 700 }, isMobile: false });
    const gravity = page.getByRole('spinbutton', { name: 'Gravity' });
    const values = () =>
      gravity.evaluate((field) => ['min', 'max', 'now'].map((name) => Number(field.getAttribute(`aria-value${name}`))));
    expect(await values()).toEqual([0, 30, 9.80665]);
    await page.getByRole('combobox', { name: 'Gravity' }).selectOption('Moon');
    expect((await values())[2]).toBe((await state(page)).values.gravity);
  });
});

describe.each(['black-hole', 'solar-system', 'stacking'])('%s', (name) => {
  const { open } = playGame(name, {});

  it.each([
    [900, 600],
    [1000, 700],
    [768, 1024],
    [1024, 768],
  ])('has no text over its buttons at %i × %i', async (width, height) => {
    const page = await open('manual', { viewport: { width, height } });
    const texts = '.game-bar button, .game-pad button, .game-hint, .st-tools, .bh-call > *, .bh-daily, .bh-redraw';
    expect(await overlaps(page, `${texts}, .ss-jpl, .ss-menu > *`)).toEqual([]);
  });
});

describe('solar system', () => {
  const { open } = playGame('solar-system', { viewport: { width: 1280, height: 800 } });

  it('never leads the focus of the keyboard out of the window', async () => {
    const page = await open('manual');
    const labels = await page
      .locator('.ss-label:visible')
      .evaluateAll((buttons) => buttons.map((each) => each.getBoundingClientRect()).map(({ x, y }) => [x, y]));
    expect(labels.length).toBeGreaterThan(3);
    expect(labels.filter(([x, y]) => x < 0 || x > 1280 || y < 0 || y > 800)).toEqual([]);
  });
});

describe('stacking', () => {
  const { open } = playGame('stacking', {});

  it('has its buttons from the top in the order of the keyboard', async () => {
    const page = await open('manual', { viewport: { width: 1000, height: 700 } });
    const tops = await page
      .locator('.game-pad button')
      .evaluateAll((buttons) => buttons.map((each) => each.getBoundingClientRect().top));
    expect(tops).toHaveLength(3);
    expect(tops).toEqual(tops.toSorted((a, b) => a - b));
  });

  it('names its tools on phones', async () => {
    const page = await open('manual', { ...PHONE, viewport: { width: 360, height: 640 } });
    expect(await page.locator('.st-tools span:visible').allTextContents()).toHaveLength(6);
    const { left, right } = await page.locator('.st-tools').evaluate((tools) => tools.getBoundingClientRect());
    expect(left).toBeGreaterThanOrEqual(0);
    expect(right).toBeLessThanOrEqual(360);
  });
});

/** The first level of the game of black holes: those that were reached, and that of a link. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { HANDS, perform, winningMoves } from '../support/black-hole-bot.ts';
import { frames, playGame, ready, state, steps } from '../support/game-page.ts';

const { open: play } = playGame('black-hole', { viewport: { width: 1280, height: 800 } });

const level = async (page: Page) => ((await state(page)).game as { dodged: number }).dodged + 1;

const setting = (page: Page) => page.locator('.lil-number', { hasText: 'First level' });

/** Asks in the panel for a first level. @returns the level that it takes */
async function askFor(page: Page, wanted: number): Promise<string> {
  const input = setting(page).locator('input');
  await input.fill(String(wanted));
  await input.press('Enter');
  return input.inputValue();
}

it('the panel offers the levels that were reached, and those of a link', async () => {
  const page = await play('manual&seed=4');
  await page.locator('.game-side').waitFor();
  // A single level is no choice: neither slider nor field takes anything.
  const input = setting(page).locator('input');
  expect(await input.isDisabled()).toBe(true);
  expect(await input.inputValue()).toBe('1');
  const slider = (await setting(page).locator('.lil-slider').boundingBox()) as { x: number; y: number };
  await page.mouse.click(slider.x + 40, slider.y + 5);
  expect(await input.inputValue()).toBe('1');
  expect(await setting(page).locator('.lil-fill').isVisible()).toBe(false);
  await perform(page, await HANDS.keys(page), winningMoves(4));
  await steps(page, 120);
  expect(await level(page)).toBe(2);
  await frames(page);
  expect(await askFor(page, 9)).toBe('2');
  expect(await level(page)).toBe(2);

  await page.reload();
  await ready(page);
  expect(await askFor(page, 9)).toBe('2');

  await page.goto(page.url().replace(/\?.*/, '?manual&seed=4&level=5'));
  await ready(page);
  expect(await level(page)).toBe(5);
  expect(await askFor(page, 9)).toBe('5');
  expect(await askFor(page, 3)).toBe('3');
});

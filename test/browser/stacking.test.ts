/** The sandbox of rigid bodies through its real page: tools, and a scene that comes back from its link. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { body, playGame, ready, state, steps } from '../support/game-page.ts';

const { open } = playGame('stacking', { viewport: { width: 900, height: 600 } });

const told = async (page: Page) => (await state(page)).game as { bodies: number; joints: number };
const tool = (page: Page, name: string) => page.locator('.st-tools button', { hasText: name }).click();

it('hinges by a tap, cuts by a swipe, and does not drag meanwhile', async () => {
  const page = await open('manual&build=pyramid&count=15');
  await steps(page, 20);
  const { screen } = await body(page, 2);
  const { x, y } = screen as { x: number; y: number };
  await tool(page, 'Hinge');
  await page.mouse.click(x, y);
  expect(await told(page)).toMatchObject({ joints: 1, bodies: 16 });
  await tool(page, 'Cut');
  await page.mouse.move(20, y - 2);
  await page.mouse.down();
  await page.mouse.move(600, y + 2, { steps: 4 });
  expect((await state(page)).dragged).toEqual([]);
  await page.mouse.up();
  // The lowest row has five bricks.
  expect((await told(page)).bodies).toBe(21);
  await steps(page, 30);
  expect((await state(page)).banner).not.toContain('wrong');
});

it('saves the scene to a link, and says what is wrong with a broken one', async () => {
  const page = await open('manual&build=bridge&count=20', { permissions: ['clipboard-read', 'clipboard-write'] });
  await steps(page, 20);
  const before = await told(page);
  await tool(page, 'Link');
  await page.waitForFunction(() => __game.state().banner.includes('your scene'));
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toMatch(/#scene=1\.[\w-]+$/);
  const guest = await page.context().newPage();
  await guest.goto(link);
  await ready(guest);
  expect(await told(guest)).toMatchObject(before);
  await steps(guest, 60);
  await guest.evaluate(() => __game.set('build', 'tower'));
  expect((await told(guest)).joints).toBe(0);
  // The note may have left before a slow machine has drawn the first picture.
  const wrong = await open('manual#scene=1.abc', { until: 'game' });
  await wrong.waitForFunction(() => __game.state().banner.includes('cannot be read'));
});

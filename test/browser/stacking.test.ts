/** The sandbox of rigid bodies through its real page: tools, and a scene that comes back from its link. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { body, playGame, ready, state, steps } from '../support/game-page.ts';
import { choose, fingerOf, MEANS, middleOf, mouseOf, tap, windowFor } from '../support/hands.ts';

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
  await page.mouse.move(8, y - 2);
  await page.mouse.down();
  await page.mouse.move(600, y + 2, { steps: 4 });
  expect((await state(page)).dragged).toEqual([]);
  await page.mouse.up();
  // The lowest row has five bricks.
  expect((await told(page)).bodies).toBe(21);
  await steps(page, 30);
  expect((await state(page)).banner).not.toContain('wrong');
});

it.each(['mouse', 'touch'] as const)('takes the top brick off by %s and stacks it again', async (means) => {
  const page = await open('manual&build=pyramid&count=6', windowFor(means));
  await steps(page, 60);
  const { count } = await state(page);
  const all = await Promise.all(Array.from({ length: count }, (_, i) => body(page, i)));
  const top = all.reduce((highest, { y }, i) => (y > all[highest].y ? i : highest), 0);
  const [{ x, y }, right] = [all[top].screen as { x: number; y: number }, 80];
  const pointer = means === 'touch' ? await fingerOf(page) : mouseOf(page);
  await pointer.press({ x, y });
  const carry = async (dx: number, dy: number) => {
    await pointer.move({ x: x + dx, y: y + dy });
    await steps(page, 40);
  };
  await carry(0, -90);
  await carry(right, -90);
  expect((await state(page)).dragged).toHaveLength(1);
  expect((await body(page, top)).y).toBeGreaterThan(all[top].y + 0.3);
  await carry(0, -90);
  for (let dy = -80; dy <= 0; dy += 20) await carry(0, dy);
  await pointer.release();
  await steps(page, 120);
  const again = await body(page, top);
  expect(Math.hypot(again.x - all[top].x, again.y - all[top].y)).toBeLessThan(0.2);
  expect(Math.hypot(again.vx, again.vy)).toBeLessThan(0.05);
});

it.each(MEANS)('takes tools, and by %s throws a ball that knocks the tower down', async (means) => {
  const page = await open('manual&build=tower&count=40', windowFor(means));
  await steps(page, 30);
  const { count } = await state(page);
  const height = async () =>
    Math.max(...(await Promise.all(Array.from({ length: count }, (_, i) => body(page, i)))).map(({ y }) => y));
  const before = await height();
  const weld = page.locator('.st-tools button[aria-label=Weld]');
  await choose(page, means, weld);
  expect(await weld.getAttribute('aria-pressed')).toBe('true');
  const throws = page.locator('.game-pad [data-name=action]');
  for (let balls = 0; balls < 4; balls++) {
    if (means === 'touch') await tap(await fingerOf(page), await middleOf(throws));
    else if (means === 'mouse') await throws.click();
    else await page.keyboard.press('c');
    await steps(page, 90);
  }
  // What the last ball threw up comes down again.
  await steps(page, 180);
  expect((await told(page)).bodies).toBeGreaterThan(count);
  expect(await height()).toBeLessThan(0.8 * before);
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
  // {"shapes":[[2,0,0,0,1,0]],"bodies":[[0,0,1,0,1,1]],"joints":[]}: a polygon of two corners.
  const impossible = await open('manual#scene=1.q1YqzkgsSC1WsoqONtIxAENDHYPYWB2lpPyUTIgEVBCIDUESWfmZeSUgidhaAA', {
    until: 'game',
  });
  await impossible.waitForFunction(() => __game.state().banner.includes('that cannot be'));
  await impossible.evaluate(() => __game.set('build', 'bridge'));
  expect((await told(impossible)).joints).toBeGreaterThan(0);
});

/** The solar system through its real page: a mission by its buttons, its link, and what the address may say. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { playGame, ready, state, steps } from '../support/game-page.ts';

const { open } = playGame('solar-system', { viewport: { width: 1000, height: 700 } });

interface Report {
  readonly date: string;
  readonly phase: string;
  readonly deltaV: number;
  readonly days: number;
  readonly isReplay: boolean;
  readonly errorsKm: Record<string, number>;
}

const told = async (page: Page) => (await state(page)).game as unknown as Report;
const press = (page: Page, text: string) => page.locator('.ss button', { hasText: text }).click();

/** Steps until the journey to a date has ended. */
async function arrive(page: Page): Promise<void> {
  for (let i = 0; i < 60 && (await told(page)).date === ''; i++) await steps(page, 10);
}

it('flies to Mars by its buttons, and the link repeats the flight', async () => {
  const page = await open('manual');
  await steps(page, 5);
  await press(page, 'To Mars');
  await arrive(page);
  expect(await told(page)).toMatchObject({ date: '2013-11-18', phase: 'ready' });
  await press(page, 'Reach Mars');
  await page.waitForFunction(() => document.querySelector('.ss-say')?.textContent?.includes('Aiming'));
  await page.waitForFunction(() => document.querySelector('.ss-say')?.textContent?.startsWith('Passes Mars'), null, {
    timeout: 60_000,
  });
  await press(page, 'Launch');
  expect((await told(page)).phase).toBe('flying');
  await steps(page, 4000);
  const flown = await told(page);
  expect(flown.phase).toBe('arrived');
  await page.waitForSelector('.game-outcome:not([hidden])');
  const guest = await page.context().newPage();
  await guest.goto(page.url());
  await guest.reload();
  await ready(guest);
  await arrive(guest);
  await steps(guest, 6000);
  const repeated = await told(guest);
  expect(repeated).toMatchObject({ phase: 'arrived', isReplay: true });
  expect(repeated.deltaV).toBeCloseTo(flown.deltaV, 9);
  expect(repeated.days).toBeCloseTo(flown.days, 0);
}, 120_000);

it('goes to the date of the address, follows a body by a key, and says what it cannot read', async () => {
  const page = await open('manual#date=2012-06-30&follow=saturn&speed=abc');
  await arrive(page);
  const { date, errorsKm } = await told(page);
  expect(date).toBe('2012-06-30');
  expect(errorsKm.mars).toBeLessThan(1);
  expect((await state(page)).banner).toContain('speed must be a number of seconds');
  expect(await page.locator('.ss-jpl tr.on').innerText()).toContain('Saturn');
  await page.keyboard.press('5');
  await page.waitForFunction(() => document.querySelector('.ss-jpl tr.on')?.textContent?.startsWith('Mars'));
}, 60_000);

it('plots energies in its own units, as masses are G m', async () => {
  const page = await open('manual');
  await steps(page, 30);
  const names = page.locator('.game-card h2 span').first();
  await expect.poll(() => names.textContent(), { timeout: 10_000 }).toContain('GM km²/s²');
  expect(await names.textContent()).not.toContain('J');
});

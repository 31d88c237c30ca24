/** The solar system through its real page: missions by keys, mouse and touch, their link, and what the address may say. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { playGame, ready, state, steps } from '../support/game-page.ts';
import { choose, MEANS, type Means, windowFor } from '../support/hands.ts';

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

/** Steps until the journey to a date has ended. */
async function arrive(page: Page): Promise<void> {
  for (let i = 0; i < 60 && (await told(page)).date === ''; i++) await steps(page, 10);
}

it.each([
  [360, 640],
  [740, 360],
])(
  'shows the goal and every button of a mission on a phone of %i × %i',
  async (width, height) => {
    const page = await open('', { viewport: { width, height }, hasTouch: true, isMobile: true });
    await page.locator('.ss button', { hasText: 'To Mars' }).tap();
    await page.locator('.ss-go').waitFor();
    expect(await page.locator('.ss-goal').isVisible()).toBe(true);
    for (const button of await page.locator('.ss-card button, .ss-pick button').all()) {
      const box = (await button.boundingBox()) as { x: number; y: number; width: number; height: number };
      expect(box.x + box.width).toBeLessThanOrEqual(width);
      expect(box.y + box.height).toBeLessThanOrEqual(height - 8);
    }
  },
  60_000,
);

describe('a mission', () => {
  const button = (page: Page, text: string) => page.locator('.ss button', { hasText: text });

  /** Waits at the point L2 for the day of the launch. */
  async function prepareLaunch(page: Page, means: Means): Promise<void> {
    await steps(page, 5);
    await choose(page, means, button(page, 'To Mars'));
    await arrive(page);
    expect(await told(page)).toMatchObject({ date: '2013-11-18', phase: 'ready' });
  }

  async function says(page: Page, start: string): Promise<void> {
    await expect
      .poll(() => page.locator('.ss-say').textContent(), { timeout: 60_000 })
      .toMatch(new RegExp(`^${start}`));
  }

  /** A guest who opens the link sees the same flight. */
  async function repeatFromLink(page: Page): Promise<void> {
    const flown = await told(page);
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
  }

  it.each(MEANS)(
    'is flown to Mars by %s',
    async (means) => {
      const page = await open('manual', windowFor(means));
      await prepareLaunch(page, means);
      await says(page, '.*Help with aiming begins within 10 million km');
      expect(await button(page, 'Reach Mars').isDisabled()).toBe(true);
      for (const [name, amount] of Object.entries({ Forward: '1.9', Outward: '-2', North: '1.5' }))
        await page.locator(`.ss-number[aria-label^="${name}"]`).fill(amount);
      await expect.poll(() => button(page, 'Reach Mars').isEnabled(), { timeout: 60_000 }).toBe(true);
      await choose(page, means, button(page, 'Reach Mars'));
      await says(page, 'Aiming');
      await says(page, 'Passes Mars');
      await choose(page, means, button(page, 'Launch'));
      expect((await told(page)).phase).toBe('flying');
      await steps(page, 4000);
      expect((await told(page)).phase).toBe('arrived');
      const card = page.locator('.game-outcome');
      await card.waitFor({ state: 'visible' });
      expect(await card.textContent()).toContain('Mars');
      if (means === 'mouse') await repeatFromLink(page);
    },
    120_000,
  );

  it.each(MEANS)(
    'fails by %s without aiming, and is tried again',
    async (means) => {
      const page = await open('manual', windowFor(means));
      await prepareLaunch(page, means);
      await says(page, 'Passes Mars');
      await choose(page, means, button(page, 'Launch'));
      for (let i = 0; i < 20 && (await told(page)).phase === 'flying'; i++) await steps(page, 1000);
      expect((await told(page)).phase).toBe('lost');
      const card = page.locator('.game-outcome');
      await card.waitFor({ state: 'visible' });
      await choose(page, means, card.locator('button', { hasText: 'Play again' }));
      await arrive(page);
      expect(await told(page)).toMatchObject({ phase: 'ready', deltaV: 0 });
    },
    120_000,
  );
});

it('shows the planets and the missions beside the lists of a low window, also before it plays', async () => {
  const page = await open('', { viewport: { width: 844, height: 390 }, hasTouch: true, reducedMotion: 'reduce' });
  const lists = (await page.locator('.ss-jpl').first().boundingBox()) as { x: number; width: number };
  // The farther planets may be outside the window.
  for (const name of ['Sun', 'Earth', 'Mars']) {
    const label = page.locator('.ss-label:visible', { hasText: name });
    const left = async () => (await label.boundingBox())?.x ?? 0;
    await expect.poll(left, { timeout: 30_000 }).toBeGreaterThan(lists.x + lists.width);
  }
  expect(await page.locator('.ss-menu button:visible').count()).toBe(3);
  expect(await page.locator('.ss-date > span').textContent()).not.toContain('Computing');
});

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

it('follows a link that is pasted while the page is open', async () => {
  const page = await open('manual');
  await Promise.all([
    page.waitForEvent('framenavigated', { predicate: () => page.url().includes('#date') }),
    page.waitForEvent('load'),
    page.evaluate(() => {
      location.hash = '#date=2012-06-30';
    }),
  ]);
  await ready(page);
  await arrive(page);
  expect((await told(page)).date).toBe('2012-06-30');
}, 60_000);

it('plots energies in its own units, as masses are G m', async () => {
  const page = await open('manual');
  await steps(page, 30);
  const names = page.locator('.game-card h2 span').first();
  await expect.poll(() => names.textContent(), { timeout: 10_000 }).toContain('km⁵/s⁴');
  expect(await names.textContent()).not.toContain('J');
});

it('lists what comes in the sky of the Earth, and leads there', async () => {
  const page = await open('manual#date=2030-01-01');
  await arrive(page);
  await page.locator('.ss-sky summary').click();
  const first = page.locator('.ss-sky button').first();
  await expect
    .poll(() => first.textContent(), { timeout: 60_000 })
    .toMatch(/^2032-11-13 08:5\d Mercury before the Sun, 9\.5′/);
  await page.locator('.ss-sky select').selectOption({ label: 'Planets that meet' });
  await expect.poll(() => page.locator('.ss-sky button').count(), { timeout: 60_000 }).toBe(8);
  await page.locator('.ss-sky select').selectOption({ label: 'Oppositions' });
  await expect
    .poll(() => page.locator('.ss-sky button', { hasText: 'Mars in opposition' }).first().textContent(), {
      timeout: 60_000,
    })
    .toMatch(/^2031-05-04/);
  await page.locator('.ss-sky button', { hasText: 'Mars in opposition' }).first().click();
  await arrive(page);
  // A quarter of a day before, at an hour a second.
  expect((await told(page)).date).toMatch(/^2031-05-0[34]/);
});

/** The submarine through its real page: it dives by keys and by touch, and its sonar answers. */

import { step } from '@principia/physics';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { createGame } from '../../games/submarine/sim.ts';
import {
  body,
  fingersOf,
  frames,
  holdablePictures,
  playGame,
  state,
  steps,
  stepsIf,
  withoutPictures,
} from '../support/game-page.ts';
import {
  choose,
  fingerOf,
  type Means,
  mouseOf,
  type Pointer,
  type Spot,
  type Steer,
  type Steering,
  steerByKeys,
  steerByPad,
  steerByPointer,
  windowFor,
} from '../support/hands.ts';
import { type Move, winningMoves } from '../support/submarine-bot.ts';

const { open } = playGame('submarine', { viewport: { width: 900, height: 600 } });

interface Report {
  readonly depth: number;
  readonly fill: number;
  readonly pingTime: number;
  readonly ending: string;
  readonly collected: number;
  readonly crates: number;
}

const told = async (page: Page) => (await state(page)).game as unknown as Report;

it('dives while the key is held, pings', async () => {
  const page = await open('manual');
  await page.keyboard.down('ArrowDown');
  await steps(page, 120);
  await page.keyboard.up('ArrowDown');
  await steps(page, 120);
  expect((await told(page)).fill).toBeCloseTo(0.4 + 0.44, 2);
  expect((await told(page)).depth).toBeGreaterThan(8);
  await page.keyboard.press('x');
  expect((await told(page)).pingTime).toBeGreaterThan(3.9);
  await frames(page);
  await page.keyboard.down('ArrowUp');
  await steps(page, 240);
  expect((await told(page)).fill).toBeLessThan(0.1);
  expect((await state(page)).banner).toBe('');
});

it('dives by the touch pad of a phone', async () => {
  const page = await open('manual', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const box = await page.locator('.game-pad [data-name=down]').boundingBox();
  const { x, y } = box as { x: number; y: number };
  const touch = await fingersOf(page);
  await touch('touchStart', [{ x: x + 20, y: y + 20 }]);
  await steps(page, 60);
  await touch('touchEnd');
  await steps(page, 60);
  expect((await told(page)).fill).toBeCloseTo(0.4 + 0.22, 2);
});

it('names fingers and buttons in the help of a phone, and keys elsewhere', async () => {
  const inputsOf = async (page: Page) => {
    await page.keyboard.press('h');
    const terms = page.locator('.game-help dt');
    await terms.first().waitFor();
    return (await terms.allTextContents()).map((term) => term.trim());
  };
  const phone = await open('manual', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const touched = await inputsOf(phone);
  expect(touched).toContain('Hold a finger');
  expect(touched).toContain('●, tap');
  expect(touched.join()).not.toMatch(/mouse|Enter|click/);
  expect(await inputsOf(await open('manual'))).toContain('X, Enter, ●, click');
});

it.each([
  [1280, 800],
  [390, 844],
  [844, 390],
  [768, 1024],
  [1024, 768],
])('keeps its gauges off the ship and the touch pad in a window of %i by %i', async (width, height) => {
  const touch = { hasTouch: true, isMobile: true };
  const page = await open('manual', { viewport: { width, height }, ...(width < 1200 ? touch : {}) });
  await frames(page);
  const gauges = (await page.locator('.sub-panel').boundingBox()) as {
    x: number;
    y: number;
    width: number;
    height: number;
  };
  const { y } = (await page.evaluate(() => __game.body(0).screen)) as { y: number };
  // The ship reaches 10 m above the water and 2 m below, and a metre takes at most ten pixels here.
  expect(gauges.y + gauges.height < y - 110 || gauges.y > y + 40).toBe(true);
  expect(gauges.y + gauges.height).toBeLessThanOrEqual(height);
  const buttons = await page.locator('.game-pad :is(button, .game-stick):visible').all();
  expect(buttons.length > 0).toBe(width < 1200);
  for (const button of buttons) {
    const box = (await button.boundingBox()) as typeof gauges;
    const isBeside = box.x + box.width <= gauges.x || gauges.x + gauges.width <= box.x;
    const isAbove = box.y + box.height <= gauges.y || gauges.y + gauges.height <= box.y;
    expect(isBeside || isAbove).toBe(true);
  }
});

describe('a player', () => {
  /** From the boat to the pointer, CSS pixels: it stays in its eighth while the camera follows for a moment. */
  const REACH = 110;
  const aboutBoat = (page: Page, pointer: Pointer): Steer =>
    steerByPointer(pointer, async () => (await body(page, 0)).screen as Spot, REACH);
  const HANDS: readonly (readonly [name: string, means: Means, steering: Steering])[] = [
    ['keys', 'keys', steerByKeys],
    ['the mouse', 'mouse', (page) => aboutBoat(page, mouseOf(page))],
    ['the touch pad', 'touch', steerByPad],
    ['a finger on the picture', 'touch', async (page) => aboutBoat(page, await fingerOf(page))],
  ];
  const plan = winningMoves(1, 1);

  /** Steers until the boat does what is wanted, and lets it go on for some steps. */
  async function perform(page: Page, steer: Steer, { x, y, steps: count }: Move): Promise<void> {
    const wanted = { engine: x, valve: y === 0 ? 0 : -y };
    for (let tries = 0; tries < 40; tries++) {
      await steer(x, y);
      if (await stepsIf(page, wanted, count)) return;
      // After a long way the camera has yet to follow.
      await steer(0, 0);
      await frames(page);
    }
    throw new Error(`The boat does not go ${x} to the right and ${y} up: ${JSON.stringify(await told(page))}`);
  }

  it.each(HANDS.slice(0, 3))(
    'by %s brings up all crates, as the same keys do in Node',
    async (_, means, steering) => {
      const page = await open('manual&seed=1', { ...windowFor(means), prepare: holdablePictures });
      const steer = await steering(page);
      const sail = async () => {
        for (const move of plan) await perform(page, steer, move);
        await steer(0, 0);
      };
      // A pointer needs the picture, whose camera follows the boat.
      await (means === 'mouse' ? sail() : withoutPictures(page, sail));
      expect(await told(page)).toMatchObject({ ending: 'won', collected: 3, crates: 3, hull: 1 });
      const again = createGame({ values: { level: 1 }, seed: 1 });
      for (const { x, y, steps: count } of plan) {
        Object.assign(again.boat, { engine: x, valve: -y });
        for (let i = 0; i < count; i++) step(again.world, again.dt);
      }
      expect((await told(page)).depth).toBe(again.depth);
      const card = page.locator('.game-outcome');
      await card.waitFor({ state: 'visible' });
      expect(await card.textContent()).toContain('All brought up');
    },
    120_000,
  );

  it.each(HANDS)('by %s that dives and stays there is lost, and plays again', async (_, means, steering) => {
    const page = await open('manual&seed=1', windowFor(means));
    const steer = await steering(page);
    await perform(page, steer, { x: 0, y: -1, steps: 60 * 60 });
    await steer(0, 0);
    for (let minutes = 0; minutes < 6 && (await told(page)).ending === 'none'; minutes++) await steps(page, 60 * 60);
    expect((await told(page)).ending).not.toBe('won');
    const card = page.locator('.game-outcome');
    await card.waitFor({ state: 'visible' });
    await choose(page, means, card.locator('button', { hasText: 'Play again' }));
    expect(await told(page)).toMatchObject({ ending: 'none', fill: 0.4, collected: 0 });
  });
});

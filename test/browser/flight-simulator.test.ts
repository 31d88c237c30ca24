/** The flight simulator through its real page: take-offs, landings and crashes by keys, mouse and touch. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { landingMoves, type Throttle } from '../support/flight-bot.ts';
import { fingersOf, holdablePictures, playGame, state, steps, withoutPictures } from '../support/game-page.ts';
import {
  choose,
  handOf,
  holdKeys,
  holdPad,
  MEANS,
  mouseOf,
  type Steer,
  steerByKeys,
  steerByStick,
  windowFor,
} from '../support/hands.ts';

const { open } = playGame('flight-simulator', { viewport: { width: 900, height: 600 } });
/** Where the processor draws, and is busy, a frame may take more than the second of `poll`. */
const SLOW = { timeout: 10_000 };

/** Steps in portions, as frames take them. */
async function fly(page: Page, seconds: number) {
  for (let left = 240 * seconds; left > 0; left -= 480) await steps(page, Math.min(480, left));
}

it('takes off by throttle and stick, and says what to do next', async () => {
  const page = await open('manual');
  const task = page.locator('.fs-task');
  await expect.poll(() => task.textContent(), SLOW).toContain('full throttle');
  await page.keyboard.down('t');
  await fly(page, 15);
  expect((await state(page)).game).toMatchObject({ phase: 'flying', onGround: true, throttle: 1 });
  await page.keyboard.down('ArrowDown');
  await fly(page, 4);
  await page.keyboard.up('ArrowDown');
  await fly(page, 12);
  const { game } = await state(page);
  expect(game.phase).toBe('flying');
  expect(game.height).toBeGreaterThan(15);
  await expect.poll(() => task.textContent(), SLOW).toContain('ring 1 of 7');
  await page.keyboard.press('c');
  expect((await state(page)).values.cockpit).toBe(true);
});

it('a key that is held while the flight begins anew acts in the new one', async () => {
  const page = await open('manual');
  await page.keyboard.down('t');
  await fly(page, 1);
  await page.evaluate(() => __game.reset());
  expect((await state(page)).game.throttle).toBe(0);
  await fly(page, 1);
  expect((await state(page)).game.throttle).toBeGreaterThan(0.3);
  await page.keyboard.up('t');
  const { throttle } = (await state(page)).game;
  await fly(page, 1);
  expect((await state(page)).game.throttle).toBe(throttle);
});

describe('a pilot', () => {
  /** What a pilot has in hand. */
  interface Cockpit {
    readonly throttle: Throttle;
    stick(x: number, y: number): Promise<unknown>;
    /** Throttle towards idle, and brake. */
    levers(isIdle: boolean, isBraking: boolean): Promise<unknown>;
  }

  const named = (isIdle: boolean, isBraking: boolean, names: readonly [string, string]) =>
    names.filter((_, i) => [isIdle, isBraking][i]);

  function byKeys(page: Page): Cockpit {
    const hold = holdKeys(page);
    return {
      throttle: 'buttons',
      stick: steerByKeys(page) as Steer,
      levers: (isIdle, isBraking) => hold(named(isIdle, isBraking, ['g', 'n'])),
    };
  }

  function byMouse(page: Page): Cockpit {
    const mouse = mouseOf(page);
    const centre = { x: 300, y: 300 };
    let [wasIdle, wasBraking] = [false, false];
    let isDown = false;
    return {
      throttle: 'lever',
      async stick(x, y) {
        if (!isDown) await mouse.press(centre);
        isDown = true;
        await mouse.move({ x: centre.x + 120 * x, y: centre.y - 120 * y });
      },
      async levers(isIdle, isBraking) {
        if (isIdle && !wasIdle) await page.mouse.wheel(0, 1000);
        if (isBraking && !wasBraking) await page.mouse.wheel(0, 1000);
        [wasIdle, wasBraking] = [isIdle, isBraking];
      },
    };
  }

  async function byTouch(page: Page): Promise<Cockpit> {
    const hand = await handOf(page);
    const hold = holdPad(page, hand);
    return {
      throttle: 'buttons',
      stick: steerByStick(page, hand(0)),
      levers: (isIdle, isBraking) => hold(named(isIdle, isBraking, ['less', 'brake'])),
    };
  }

  const COCKPITS = { keys: byKeys, mouse: byMouse, touch: byTouch };

  it.each(MEANS)(
    'lands by %s, as the same moves do in Node',
    async (means) => {
      const page = await open('manual&mission=landing&seed=1', { ...windowFor(means), prepare: holdablePictures });
      const cockpit = await COCKPITS[means](page);
      await withoutPictures(page, async () => {
        for (const { x, y, isIdle, isBraking, steps: count } of landingMoves(1, cockpit.throttle)) {
          await cockpit.stick(x, y);
          await cockpit.levers(isIdle, isBraking);
          await steps(page, count);
        }
      });
      const { game } = await state(page);
      expect(game).toMatchObject({ phase: 'landed', onGround: true });
      expect(game.score).toBeGreaterThan(200);
      const card = page.getByRole('alert').filter({ hasText: 'Landed!' });
      await expect.poll(() => card.textContent(), SLOW).toContain(String(game.reason));
    },
    120_000,
  );

  it.each(MEANS)('that dives by %s crashes, reads why, and begins again', async (means) => {
    const page = await open('manual&mission=landing', windowFor(means));
    const cockpit = await COCKPITS[means](page);
    await cockpit.stick(0, 1);
    await fly(page, 20);
    const { game } = await state(page);
    expect(game.phase).toBe('crashed');
    const card = page.getByRole('alert').filter({ hasText: 'Crashed' });
    await expect.poll(() => card.textContent(), SLOW).toContain(String(game.reason));
    if (means === 'mouse') await page.mouse.up();
    else await cockpit.stick(0, 0);
    await choose(page, means, page.getByRole('button', { name: 'Play again' }));
    expect((await state(page)).game).toMatchObject({ phase: 'flying', score: 0 });
  });

  it.each(['mouse', 'touch'] as const)('turns by the rudder with %s, and lets go of it', async (means) => {
    const page = await open('manual&mission=landing&assist=off', windowFor(means));
    const slider = page.getByRole('slider', { name: 'Rudder' });
    const box = await slider.boundingBox();
    const right = { x: (box?.x ?? 0) + 0.95 * (box?.width ?? 0), y: (box?.y ?? 0) + 0.5 * (box?.height ?? 0) };
    const fingers = await fingersOf(page);
    if (means === 'mouse') await page.mouse.click(right.x, right.y);
    else await fingers('touchStart', [{ ...right, id: 1 }]);
    await fly(page, 1);
    await expect.poll(() => slider.getAttribute('aria-valuenow'), SLOW).toBe('100');
    // A mouse leaves the pedals where they are; a finger does not.
    if (means === 'mouse') await page.mouse.dblclick(right.x, right.y);
    else await fingers('touchEnd');
    await fly(page, 1);
    await expect.poll(() => slider.getAttribute('aria-valuenow'), SLOW).toBe('0');
    // The keys of a slider are those of the stick until Tab has led to it.
    expect(await slider.evaluate((element) => element === document.activeElement)).toBe(false);
    await slider.focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    await fly(page, 1);
    await expect.poll(() => slider.getAttribute('aria-valuenow'), SLOW).toBe('-20');
  });

  it('of the mouse takes off by the wheel and a drag', async () => {
    const page = await open('manual');
    await page.mouse.move(300, 300);
    await page.mouse.wheel(0, -1000);
    await fly(page, 15);
    expect((await state(page)).game).toMatchObject({ throttle: 1, onGround: true });
    await page.mouse.down();
    await page.mouse.move(300, 420);
    await fly(page, 6);
    await page.mouse.up();
    await fly(page, 6);
    expect((await state(page)).game.height).toBeGreaterThan(10);
  });
});

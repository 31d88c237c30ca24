/** The swarm of the fireworks, held by a mouse, a finger and a key on the real page. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { fingersOf, frames, playGame, state, steps } from '../support/game-page.ts';

/** What the game tells of itself. */
interface Told {
  readonly alive: number;
  readonly cues: readonly { readonly kind: number; readonly power: number }[];
}

const { open: play } = playGame('fireworks', { viewport: { width: 900, height: 560 }, hasTouch: true });

const told = async (page: Page) => (await state(page)).game as unknown as Told;

describe('a swarm', () => {
  /** Holds by one of the ways, for seconds of the game, and lets go. */
  const hands = {
    async mouse(page: Page, seconds: number) {
      await page.mouse.move(300, 160);
      await page.mouse.down();
      await steps(page, 60 * seconds);
      await page.mouse.up();
    },
    async finger(page: Page, seconds: number) {
      const touch = await fingersOf(page);
      await touch('touchStart', [{ x: 300, y: 160, id: 1 }]);
      await steps(page, 60 * seconds);
      await touch('touchEnd');
    },
    async key(page: Page, seconds: number) {
      await page.keyboard.down('Enter');
      await steps(page, 60 * seconds);
      await page.keyboard.up('Enter');
    },
  };

  it.each(['mouse', 'finger', 'key'] as const)(
    'has two stars for every second that a %s holds, bursts at once, and none below a second',
    async (hand) => {
      const page = await play('manual');
      // An empty show instead of the demonstration: the night is dark.
      await page.keyboard.press('l');
      await page.locator('.fw-tray [aria-label^=swarm]').click();
      for (const [seconds, stars] of [
        [0.4, 0],
        [2.5, 4],
      ]) {
        await hands[hand](page, seconds);
        await steps(page, 1);
        expect(await told(page)).toMatchObject({ held: [], fired: stars > 0 ? 1 : 0, alive: stars, flying: 0 });
      }
    },
  );

  it('says how many stars it has got to, and is a shell of shows like others', async () => {
    const page = await play('manual&seed=3');
    await page.keyboard.press('t');
    await page.keyboard.press('l');
    await page.locator('.fw-tray [aria-label^=swarm]').click();
    await page.mouse.move(250, 170);
    await page.mouse.down();
    await steps(page, 310);
    await frames(page);
    expect(await page.locator('.fw-ring').textContent()).toBe('10');
    expect(await page.locator('.fw-mark').count()).toBe(0);
    await page.mouse.up();
    await steps(page, 1);
    expect((await told(page)).alive).toBe(10);
    // A click is no swarm, and nothing to put into a show.
    await page.mouse.click(400, 120);
    await steps(page, 1);
    await frames(page);
    const { cues, alive } = await told(page);
    expect(cues).toHaveLength(1);
    expect(cues[0]).toMatchObject({ kind: 8, power: 1 });
    expect(alive).toBe(10);
    // Played, it is there again.
    await steps(page, 620);
    expect((await told(page)).alive).toBe(0);
    await page.keyboard.press('l');
    await steps(page, 1);
    expect(await told(page)).toMatchObject({ alive: 10, isShowing: false });
  });
});

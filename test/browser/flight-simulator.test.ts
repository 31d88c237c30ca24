/** The flight simulator through its real page: a take-off by keys, and a crash that is explained. */
import { expect, it } from 'vitest';
import { playGame, state, steps } from '../support/game-page.ts';

const { open } = playGame('flight-simulator', { viewport: { width: 900, height: 600 } });
/** Where the processor draws, and is busy, a frame may take more than the second of `poll`. */
const SLOW = { timeout: 10_000 };

/** Steps in portions, as frames take them. */
async function fly(page: Parameters<typeof steps>[0], seconds: number) {
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

it('ends a dive with a reason in words, and begins again', async () => {
  const page = await open('manual&mission=landing');
  await page.keyboard.down('ArrowUp');
  await fly(page, 20);
  await page.keyboard.up('ArrowUp');
  const { game } = await state(page);
  expect(game.phase).toBe('crashed');
  const card = page.getByRole('alert').filter({ hasText: 'Crashed' });
  await expect.poll(() => card.textContent(), SLOW).toContain(String(game.reason));
  await page.getByRole('button', { name: 'Play again' }).click();
  expect((await state(page)).game).toMatchObject({ phase: 'flying', score: 0 });
});

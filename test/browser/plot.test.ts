/** A plot and its numbers show an oscillation at the frequency that it has, however fast it is. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';

const browser = shareBrowser();
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('./plot.page.ts', import.meta.url));
});

afterAll(() => served?.close());

const [FREQUENCY, DT] = [19, 1 / 1000];
/** Relative error of the frequency of velocity Verlet, (ω dt)²/24 (Hairer, Lubich and Wanner 2003, section 2.2). */
const ERROR = (2 * Math.PI * FREQUENCY * DT) ** 2 / 24;

async function play(query: string, plot = 'Position.x,,1'): Promise<Page> {
  const { page } = await openPage(browser(), `${served.url}?plot=${plot}${query}`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  return page;
}

/** The rows of numbers that the plot saves. */
async function rowsOf(page: Page): Promise<readonly (readonly number[])[]> {
  const saved = page.waitForEvent('download');
  await page.getByText('CSV').click();
  const pieces: Buffer[] = [];
  for await (const piece of await (await saved).createReadStream()) pieces.push(piece as Buffer);
  const [, ...rows] = Buffer.concat(pieces).toString().trim().split('\n');
  return rows.map((row) => row.split(',').map(Number));
}

/** Times at which the second column changes its sign, by a straight line between two rows. */
function crossingsOf(rows: readonly (readonly number[])[]): number[] {
  return rows.slice(1).flatMap(([time, x], i) => {
    const [before, last] = rows[i];
    return x * last < 0 ? [before + ((time - before) * last) / (last - x)] : [];
  });
}

function expectOscillation(rows: readonly (readonly number[])[]): void {
  const spaces = rows.slice(1).map(([time], i) => time - rows[i][0]);
  expect(Math.max(...spaces.map((space) => Math.abs(space / DT - 1)))).toBeLessThan(1e-9);
  const crossings = crossingsOf(rows);
  const [first, last] = [crossings[0], crossings.at(-1) as number];
  // A straight line instead of the sine errs by less than (ω dt)²/16 of a step at each end.
  const frequency = (crossings.length - 1) / 2 / (last - first);
  expect(Math.abs(frequency / FREQUENCY - 1)).toBeLessThan(1.05 * ERROR + (0.01 * DT) / (last - first));
}

test('of steps at once there is a row each, for twelve seconds', async () => {
  const page = await play('&manual');
  await page.evaluate(() => __game.step(5000));
  const rows = await rowsOf(page);
  expect([rows.length, rows.at(-1)?.[0]]).toEqual([5001, expect.closeTo(5, 9)]);
  expectOscillation(rows);
  await page.evaluate(() => __game.step(20_000));
  const later = await rowsOf(page);
  expect([later.length, later.at(-1)?.[0]]).toEqual([12_000, expect.closeTo(25, 9)]);
  expectOscillation(later);
  await page.close();
});

test('of a game that runs the rows are evenly spaced, also after it was rewound', async () => {
  const page = await play('');
  const runTo = (time: number) => page.waitForFunction((until) => __game.state().time > until, time);
  await runTo(1.5);
  await page.evaluate(() => __game.rewind(0.7));
  await runTo(2);
  await page.evaluate(() => __game.pause());
  const rows = await rowsOf(page);
  expect(rows.length).toBeGreaterThan(1000);
  expectOscillation(rows);
  await page.close();
});

test('the picture is a band as high as the oscillation', async () => {
  const page = await play('&manual');
  await page.evaluate(() => __game.step(5000));
  await page.waitForTimeout(500);
  const spans = await page.evaluate(() => {
    const canvas = document.querySelector('.uplot canvas') as HTMLCanvasElement;
    const { width, height } = canvas;
    const { data } = (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, width, height);
    const isLine = (x: number, y: number) => {
      const [red, green, blue, alpha] = data.subarray(4 * (y * width + x), 4 * (y * width + x) + 4);
      return alpha > 128 && red > 200 && green < 200 && blue < 180;
    };
    const columns = Array.from({ length: width }, (_, x) =>
      Array.from({ length: height }, (_, y) => y).filter((y) => isLine(x, y)),
    );
    return columns.filter((ys) => ys.length > 0).map((ys) => (ys.at(-1) as number) - ys[0]);
  });
  // A column has 25 ms or more, nearly half of a period, which spans more than half of the height, wherever it begins.
  const height = Math.max(...spans);
  expect(height).toBeGreaterThan(50);
  expect(spans.length).toBeGreaterThan(100);
  expect(spans.slice(1, -1).filter((span) => span < 0.45 * height)).toEqual([]);
  await page.close();
});

test('a quantity of the game takes the place of the one that is called as it, in the list and in the address', async () => {
  const page = await play('&manual', 'Energy');
  const lists = page.locator('.game-card[aria-label="Plot"] select');
  const labels = await lists.first().locator('option').allTextContents();
  expect(labels).toEqual(['Energy', 'Momentum', 'Angular momentum', 'Any value']);
  await page.evaluate(() => __game.step(100));
  expect(await page.evaluate(() => __game.state().plot)).toBe('perMass');
  const values = (await rowsOf(page)).map(([, value]) => value / (0.5 * (2 * Math.PI * FREQUENCY) ** 2));
  // The energy of velocity Verlet goes to and fro by (ω dt)²/4 of itself.
  expect(Math.max(...values.map((value) => Math.abs(value - 1)))).toBeLessThan(6.2 * ERROR);
  await page.close();
});

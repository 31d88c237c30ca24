import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { launchChromium } from '../support/chromium.ts';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import type { FrameCost } from './render-pixi-cost.page.ts';

let browser: Browser;
let served: ServedPage;
let page: Page;
let errors: string[];

beforeAll(async () => {
  served = await servePage(new URL('./render-pixi-cost.page.ts', import.meta.url));
  browser = await launchChromium({ args: ['--enable-precise-memory-info', '--js-flags=--expose-gc'] });
  ({ page, errors } = await openPage(browser, served.url));
  await page.waitForFunction(() => 'pixiCostLab' in globalThis);
});

afterAll(async () => {
  await browser?.close();
  await served?.close();
  expect(errors).toEqual([]);
});

const total = ({ update, render }: FrameCost) => update + render;
const text = ({ update, render }: FrameCost) => `${update.toFixed(3)} + ${render.toFixed(3)} ms`;

it('draws 100 000 bodies with a fraction of the JavaScript of a ParticleContainer', async () => {
  const costs = await page.evaluate(() => pixiCostLab.compare(100_000, 15));
  process.stdout.write(
    `100 000 bodies, update + render: two drawn ${text(costs.twoDrawn)}, all drawn ${text(costs.allDrawn)}, ` +
      `ParticleContainer ${text(costs.particleContainer)}\n`,
  );
  // The ratio was 5 to 20 when measured; a busy machine must not fail the test.
  expect(total(costs.allDrawn)).toBeLessThan(total(costs.particleContainer) / 2);
});

it('leaves no garbage when it uploads', async () => {
  const bytes = await page.evaluate(() => pixiCostLab.garbage(2000, 2000));
  expect(bytes).toBeLessThan(16);
});

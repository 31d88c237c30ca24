/**
 * The picture of each game after so many steps of a seed, against the one it had when somebody last looked at it.
 * `GOLDENS=write npx vitest run --project browser test/browser/goldens.test.ts` keeps the pictures as they are now: look
 * at them first.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { frames, pictureOf, playGame, steps } from '../support/game-page.ts';
import { differences, gridOf, readGrid, writeGrid } from '../support/picture-grid.ts';

/** Light gathers from picture to picture: one after every four steps. */
const watch = (page: Page, count: number) =>
  page.evaluate(async (n) => {
    for (let i = 0; i < n; i += 4) {
      __game.step(4);
      await new Promise((done) => requestAnimationFrame(done));
    }
  }, count);

const fly = async (page: Page) => {
  await page.keyboard.down('ArrowUp');
  await steps(page, 300);
  await page.keyboard.down('ArrowRight');
  await steps(page, 100);
};
const bounce = (page: Page) => steps(page, 55);
const tear = async (page: Page) => {
  await steps(page, 60);
  await page.mouse.move(320, 200);
  await page.mouse.down();
  await page.mouse.move(380, 300);
  await frames(page);
  await steps(page, 60);
};
const burst = (page: Page) => watch(page, 220);

const pictures = [
  ['bouncing-balls', 'pixi', 'count=40&seed=5&collisions=off&restitution=0.8', bounce],
  ['bouncing-balls', 'three', 'count=40&seed=5&collisions=off&restitution=0.8', bounce],
  ['black-hole', 'pixi', 'seed=4', fly],
  ['cloth', 'pixi', 'seed=5', tear],
  ['fireworks', 'pixi', 'seed=5', burst],
  ['fireworks', 'three', 'seed=5', burst],
] as const;

/** What must not go unnoticed. */
const DRAWN_ELSEWHERE = '.game-stage canvas { transform: translate(3px, 2px) }';
const OTHER_COLORS = '.game-stage canvas { filter: hue-rotate(40deg) }';

/** All that is drawn many at a time, and the whole sky of the black holes, is lost. */
function loseLayers(): void {
  const { drawElements } = WebGL2RenderingContext.prototype;
  Object.assign(WebGL2RenderingContext.prototype, {
    drawArraysInstanced() {},
    drawElementsInstanced() {},
    drawElements(this: WebGL2RenderingContext, mode: number, count: number, type: number, offset: number) {
      if (count !== 6 && count < 6000) drawElements.call(this, mode, count, type, offset);
    },
  });
}

describe.each(pictures)('%s in %s', (game, renderer, query, play) => {
  const { open } = playGame(game, { viewport: { width: 640, height: 400 }, reducedMotion: 'reduce' });
  const file = new URL(`./goldens/${game}-${renderer}.txt`, import.meta.url);

  const wanted = () => readGrid(readFileSync(file, 'utf8'));

  async function playTo(prepare?: () => void) {
    const page = await open(`manual&renderer=${renderer}&${query}`, prepare === undefined ? {} : { prepare });
    await play(page);
    return page;
  }

  const look = async (page: Page) =>
    gridOf(
      await pictureOf(
        page,
        '.bh-hud',
        '.fw-desk',
        '.fw-sight',
        '.fw-extras',
        '.cloth-print',
        '.cloth-again',
        '.magnet-button',
      ),
    );

  it('looks as it did; and that it would be noticed if it were drawn elsewhere or in other colours', async () => {
    const page = await playTo();
    const grid = await look(page);
    if (process.env.GOLDENS === 'write') writeFileSync(file, writeGrid(grid));
    expect(grid.bright).toBeGreaterThan(1e-3);
    expect(differences(grid, wanted())).toEqual([]);
    for (const content of [DRAWN_ELSEWHERE, OTHER_COLORS]) {
      const style = await page.addStyleTag({ content });
      expect(differences(await look(page), wanted()), content).not.toEqual([]);
      await style.evaluate((element) => (element as HTMLElement).remove());
    }
  });

  it('is noticed when its bodies are not drawn', async () => {
    expect(differences(await look(await playTo(loseLayers)), wanted())).not.toEqual([]);
  });
});

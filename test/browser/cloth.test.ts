/** Tears the cloth through its real page, by mouse and by fingers. */
import type { Page } from 'playwright-core';
import { PNG } from 'pngjs';
import { describe, expect, it } from 'vitest';
import { CLOTH } from '../../games/cloth/sim.ts';
import { body, fingersOf, frames, loseGraphicsCard, pictureOf, playGame, state, steps } from '../support/game-page.ts';
import { drag, fingerOf, focus, middleOf, mouseOf, tap, windowFor } from '../support/hands.ts';
import { gridOf } from '../support/picture-grid.ts';

const { open: play } = playGame('cloth', { viewport: { width: 900, height: 600 }, hasTouch: true });

const broken = async (page: Page) => ((await state(page)).game as { broken: number }).broken;

/** Where a node is on the page. */
async function nodePlace(page: Page, column: number, row: number) {
  const { screen } = await body(page, CLOTH.columns * row + column);
  return screen as { x: number; y: number };
}

const MIDDLE = CLOTH.columns * 20 + 32;

/** Distance between two nodes left and right of the middle, m. */
async function widthOf(page: Page): Promise<number> {
  const [left, right] = [await body(page, MIDDLE - 6), await body(page, MIDDLE + 6)];
  return right.x - left.x;
}

describe('the cloth', () => {
  it('keeps its hint while one presses play, until one touches it', async () => {
    const page = await play('renderer=pixi', { ...windowFor('touch'), reducedMotion: 'reduce' });
    const hint = page.locator('.game-hint');
    await page.locator('.game-banner:visible button:visible').tap();
    await page.locator('.game-bar button[title^=Resume]').tap();
    expect((await state(page)).paused).toBe(false);
    expect(await hint.count()).toBe(1);
    await page.touchscreen.tap(195, 420);
    expect(await hint.count()).toBe(0);
  });

  it('hangs, and is seen', async () => {
    const page = await play('renderer=pixi&wind=0');
    expect(await broken(page)).toBe(0);
    const { data } = PNG.sync.read(await pictureOf(page));
    let warm = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i] > data[i + 2] + 20) warm++;
    const [from, to] = [await nodePlace(page, 0, 0), await nodePlace(page, CLOTH.columns - 1, CLOTH.rows - 1)];
    const length = CLOTH.columns * (to.y - from.y) + CLOTH.rows * (to.x - from.x);
    // A line of 1.6 pixels reaches two or three pixels across; where threads cross, some count once for two.
    expect(warm / length).toBeGreaterThan(1);
    expect(warm / length).toBeLessThan(3);
  });

  it('tears under the mouse, and is whole again after a reset', async () => {
    const page = await play('renderer=pixi&wind=0');
    const { x, y } = await nodePlace(page, 32, 20);
    await page.mouse.move(x, y);
    await page.mouse.down();
    expect((await state(page)).dragged.length).toBeGreaterThan(10);
    for (let i = 1; i <= 20; i++) {
      await page.mouse.move(x, y + 10 * i);
      await frames(page);
    }
    await page.mouse.up();
    expect(await broken(page)).toBeGreaterThan(10);
    expect((await state(page)).dragged).toEqual([]);
    await page.keyboard.press('r');
    await frames(page);
    expect(await broken(page)).toBe(0);
  });

  it('is held by two fingers at once, each its own piece', async () => {
    const page = await play('renderer=pixi&wind=0&strength=50');
    const touch = await fingersOf(page);
    const fingers = [await nodePlace(page, 12, 30), await nodePlace(page, 52, 30)].map((at, id) => ({ ...at, id }));
    await touch('touchStart', fingers.slice(0, 1));
    await frames(page);
    const one = (await state(page)).dragged.length;
    await touch('touchStart', fingers);
    await frames(page);
    expect(one).toBeGreaterThan(10);
    expect((await state(page)).dragged.length).toBeGreaterThan(one + 10);
    await touch('touchEnd');
    await frames(page);
    expect((await state(page)).dragged).toEqual([]);
  });

  it.each(['pixi', 'three'])('is cut by a swipe that begins beside it, and only by that: %s', async (renderer) => {
    const page = await play(`renderer=${renderer}&wind=0&manual`);
    const threads = async () => ((await state(page)).game as { threads: number }).threads;
    await page.evaluate(() => __game.step(3));
    const before = await threads();
    const [left, right] = [await nodePlace(page, 0, 20), await nodePlace(page, CLOTH.columns - 1, 20)];
    // A drag on the cloth pulls.
    await page.mouse.move(left.x + 60, left.y + 4);
    await page.mouse.down();
    expect((await state(page)).dragged.length).toBeGreaterThan(5);
    await page.mouse.move(left.x + 70, left.y + 14);
    await page.mouse.up();
    expect(await threads()).toBe(before);
    await page.mouse.move(left.x - 40, left.y + 3);
    await page.mouse.down();
    await page.mouse.move(right.x + 40, right.y + 3, { steps: 5 });
    await page.mouse.up();
    // One thread of each column, and in 3D the diagonals beside it.
    expect(await threads()).toBeLessThanOrEqual(before - CLOTH.columns + 2);
  });

  it.each(['mouse', 'touch'] as const)('is cut through by %s until a piece falls', async (means) => {
    const page = await play('renderer=pixi&wind=0&manual', windowFor(means));
    await steps(page, 60);
    const [left, right] = [await nodePlace(page, 0, 20), await nodePlace(page, CLOTH.columns - 1, 20)];
    const lowest = async () => (await body(page, CLOTH.columns * (CLOTH.rows - 1) + 30)).y;
    const before = await lowest();
    const pointer = means === 'touch' ? await fingerOf(page) : mouseOf(page);
    await drag(pointer, { x: Math.max(2, left.x - 30), y: left.y + 3 }, { x: right.x + 20, y: right.y + 3 }, 6);
    await steps(page, 120);
    expect(await lowest()).toBeLessThan(before - 0.5);
  });

  it.each([
    ['mouse', 'three'],
    ['touch', 'three'],
    ['mouse', 'pixi'],
  ] as const)('is blown at by %s after a button, without being dragged or cut: %s', async (means, renderer) => {
    const page = await play(`renderer=${renderer}&wind=0&manual`, windowFor(means));
    await steps(page, 60);
    const at = await nodePlace(page, 32, 20);
    const threads = async () => ((await state(page)).game as { threads: number }).threads;
    const before = { threads: await threads(), width: await widthOf(page), z: (await body(page, MIDDLE)).z };
    const pointer = means === 'touch' ? await fingerOf(page) : mouseOf(page);
    const button = page.locator('.cloth-button', { hasText: 'Blow' });
    await tap(pointer, await middleOf(button));
    expect(await button.getAttribute('aria-pressed')).toBe('true');
    await pointer.press(at);
    expect((await state(page)).dragged).toEqual([]);
    await steps(page, 40);
    if (renderer === 'three') expect((await body(page, MIDDLE)).z).toBeLessThan(before.z - 0.15);
    else expect(await widthOf(page)).toBeGreaterThan(before.width + 0.01);
    await pointer.move({ x: at.x + 30, y: at.y });
    await pointer.release();
    await steps(page, 600);
    expect(Math.abs((await body(page, MIDDLE)).z - before.z)).toBeLessThan(0.05);
    expect(Math.abs((await widthOf(page)) - before.width)).toBeLessThan(0.01);
    expect(await threads()).toBe(before.threads);
    // The button gives the drag back.
    await tap(pointer, await middleOf(button));
    await pointer.press(await nodePlace(page, 32, 20));
    expect((await state(page)).dragged.length).toBeGreaterThan(5);
    await pointer.release();
  });

  it.each(['three', 'pixi'])('is blown at while a key is held, where the mouse is: %s', async (renderer) => {
    const page = await play(`renderer=${renderer}&wind=0&manual`, windowFor('keys'));
    await steps(page, 60);
    const wide = await widthOf(page);
    const { z } = await body(page, MIDDLE);
    const push = async () => (renderer === 'three' ? z - (await body(page, MIDDLE)).z : (await widthOf(page)) - wide);
    const enough = renderer === 'three' ? 0.15 : 0.01;
    // No mouse was there: the middle.
    await page.keyboard.down('a');
    await steps(page, 40);
    expect(await push()).toBeGreaterThan(enough);
    expect(await page.locator('.cloth-ring:visible').count()).toBe(1);
    const corner = await nodePlace(page, 60, 36);
    await page.mouse.move(corner.x, corner.y);
    await steps(page, 600);
    expect(await push()).toBeLessThan(enough);
    await page.keyboard.up('a');
    expect(await page.locator('.cloth-ring:visible').count()).toBe(0);
    expect((await state(page)).dragged).toEqual([]);
  });

  it('is blown at by two fingers at once, each at its own place', async () => {
    const page = await play('renderer=three&wind=0&manual');
    await steps(page, 60);
    await page.locator('.cloth-button', { hasText: 'Blow' }).click();
    const nodes = [12, 52].map((column) => CLOTH.columns * 30 + column);
    const fingers = [await nodePlace(page, 12, 30), await nodePlace(page, 52, 30)].map((at, id) => ({ ...at, id }));
    const touch = await fingersOf(page);
    await touch('touchStart', fingers.slice(0, 1));
    await touch('touchStart', fingers);
    await steps(page, 40);
    for (const node of nodes) expect((await body(page, node)).z).toBeLessThan(-0.15);
    expect((await state(page)).dragged).toEqual([]);
    await touch('touchEnd');
    await steps(page, 600);
    for (const node of nodes) expect(Math.abs((await body(page, node)).z)).toBeLessThan(0.1);
  });

  it('tears under its own weight once keys have made its threads weak', async () => {
    const page = await play('renderer=pixi&wind=0&manual', windowFor('keys'));
    await steps(page, 60);
    expect(await broken(page)).toBe(0);
    for (const [label, value] of [
      ['Gravity', '30'],
      ['Strength', '0.5'],
    ]) {
      await focus(page, page.locator('.lil-controller', { hasText: label }).locator('input').last());
      await page.keyboard.press('Control+a');
      await page.keyboard.type(value);
      await page.keyboard.press('Enter');
    }
    expect((await state(page)).values).toMatchObject({ gravity: 30, strength: 0.5 });
    await steps(page, 240);
    expect(await broken(page)).toBeGreaterThan(10);
  });

  it.each(['pixi', 'three'])('shows the player’s picture, and says what is none: %s', async (renderer) => {
    const page = await play(`renderer=${renderer}&wind=0&manual`);
    const picture = new PNG({ width: 64, height: 40 });
    for (let i = 0; i < picture.data.length; i += 4) picture.data.set([20, 200, 40, 255], i);
    const greenPixels = async () => {
      const { data } = PNG.sync.read(await pictureOf(page, '.cloth-print'));
      let green = 0;
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 1] > data[i] + 30 && data[i + 1] > data[i + 2] + 30) green++;
      return green;
    };
    expect(await greenPixels()).toBe(0);
    const input = page.locator('.cloth-print input');
    await input.setInputFiles({ name: 'green.png', mimeType: 'image/png', buffer: PNG.sync.write(picture) });
    const remove = page.locator('.cloth-print button', { hasText: 'Take it off' });
    await remove.waitFor({ state: 'visible' });
    expect(await greenPixels()).toBeGreaterThan(10_000);
    await input.setInputFiles({ name: 'notes.txt', mimeType: 'image/png', buffer: Buffer.from('no picture') });
    await page.waitForFunction(() => __game.state().banner.includes('“notes.txt” is not a picture'));
    expect(await greenPixels()).toBeGreaterThan(10_000);
    await remove.click();
    expect(await greenPixels()).toBe(0);
    await page.evaluate(
      (bytes) => {
        const data = new DataTransfer();
        data.items.add(new File([new Uint8Array(bytes)], 'green.png', { type: 'image/png' }));
        document.dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
      },
      [...PNG.sync.write(picture)],
    );
    await remove.waitFor({ state: 'visible' });
    expect(await greenPixels()).toBeGreaterThan(10_000);
  });

  it.each(['pixi', 'three'])('shows a tear again slowly, until a press: %s', async (renderer) => {
    const page = await play(`renderer=${renderer}&wind=0&manual`);
    // The cloth comes to rest.
    await page.evaluate(() => __game.step(240));
    const [left, right] = [await nodePlace(page, 0, 20), await nodePlace(page, CLOTH.columns - 1, 20)];
    const whole = await pictureOf(page, '.cloth-print');
    await page.mouse.move(left.x - 40, left.y + 3);
    await page.mouse.down();
    await page.mouse.move(right.x + 40, right.y + 3, { steps: 5 });
    await page.mouse.up();
    const again = page.locator('.cloth-again');
    expect(await again.isVisible()).toBe(false);
    await page.evaluate(() => __game.step(60));
    await again.click();
    // The film begins before the cut, while the world lies where it fell.
    expect(await page.locator('.cloth-film').textContent()).toContain('Slow motion');
    const film = await pictureOf(page, '.cloth-print', '.cloth-film');
    const { tick } = await state(page);
    await page.mouse.click(20, 300);
    const fallen = await pictureOf(page, '.cloth-print');
    expect((await state(page)).tick).toBe(tick);
    // Cells of twenty pixels: a cloth at rest still sways by less than a thread is thick.
    const difference = (a: Buffer, b: Buffer) => {
      const [p, q] = [gridOf(a).cells, gridOf(b).cells];
      return p.reduce((sum, value, i) => sum + Math.abs(value - q[i]), 0);
    };
    expect(difference(film, whole)).toBeLessThan(0.3 * difference(film, fallen));
    expect(await page.locator('.cloth-film').textContent()).toBe('');
    await frames(page);
    expect(await again.isVisible()).toBe(false);
  });

  it('is a lit sheet in 3D, in colours for every eye, and survives the loss of the graphics card', async () => {
    const page = await play('wind=0&manual');
    expect((await state(page)).renderer).toBe('three');
    const sheet = async (is: (r: number, g: number, b: number) => boolean) => {
      const { data } = PNG.sync.read(await pictureOf(page));
      let count = 0;
      for (let i = 0; i < data.length; i += 4) if (is(data[i], data[i + 1], data[i + 2])) count++;
      return count;
    };
    const isWarm = (r: number, _: number, b: number) => r > b + 40;
    const warm = await sheet(isWarm);
    const [from, to] = [await nodePlace(page, 0, 0), await nodePlace(page, CLOTH.columns - 1, CLOTH.rows - 1)];
    // It covers most of the rectangle between its corners.
    expect(warm).toBeGreaterThan(0.7 * Math.abs((to.x - from.x) * (to.y - from.y)));
    await page.keyboard.press('y');
    expect(await sheet((r, _, b) => b > r + 40)).toBeGreaterThan(0.2 * warm);
    await page.keyboard.press('y');
    const giveBack = await loseGraphicsCard(page);
    await giveBack();
    expect(Math.abs((await sheet(isWarm)) / warm - 1)).toBeLessThan(0.2);
  });
});

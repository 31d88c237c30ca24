/** What the shell gives every game, worked with real keys, pointers and files, on the game of bouncing balls. */
import type { Download, Page } from 'playwright-core';
import { PNG } from 'pngjs';
import { describe, expect, it } from 'vitest';
import { body, frames, loseGraphicsCard, playGame, ready, state, steps } from '../support/game-page.ts';

declare global {
  var pictures: number;
}

const { open: openBalls } = playGame('bouncing-balls', {
  viewport: { width: 900, height: 700 },
  acceptDownloads: true,
});

/** Five balls in 2D that pass through each other, unless a test asks for something else. */
const FEW = 'renderer=pixi&count=5&collisions=off&restitution=0.8';
const open = (query: string, options?: Parameters<typeof openBalls>[1]) => openBalls(`${FEW}&${query}`, options);

const card = (page: Page, label: string) => page.locator(`.game-card[aria-label="${label}"]`);

async function contentOf(download: Download): Promise<Buffer> {
  const stream = await download.createReadStream();
  const pieces: Buffer[] = [];
  for await (const piece of stream) pieces.push(piece as Buffer);
  return Buffer.concat(pieces);
}

/** Counts in `pictures` the frames in which anything is drawn. */
const countPictures = () => {
  let isDrawn = false;
  globalThis.pictures = 0;
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'] as const) {
    const draw = WebGL2RenderingContext.prototype[name] as (...values: number[]) => void;
    WebGL2RenderingContext.prototype[name] = function (this: WebGL2RenderingContext, ...values: number[]) {
      isDrawn = true;
      draw.apply(this, values);
    };
  }
  const look = () => {
    if (isDrawn) globalThis.pictures++;
    isDrawn = false;
    requestAnimationFrame(look);
  };
  look();
};

describe('a paused game', () => {
  it('draws a few pictures a second, and one at once when the player does something', async () => {
    const page = await open('', { prepare: countPictures });
    const pictures = () => page.evaluate(() => globalThis.pictures);
    await page.waitForFunction(() => globalThis.pictures > 5);
    await page.keyboard.press(' ');
    expect((await state(page)).paused).toBe(true);
    await page.waitForTimeout(2000);
    const before = await pictures();
    await page.waitForTimeout(2000);
    const after = await pictures();
    // Four a second, and room for what a timer of a busy machine is late.
    expect(after - before).toBeLessThanOrEqual(12);
    expect(after - before).toBeGreaterThan(0);
    await page.mouse.move(300, 300);
    await frames(page);
    expect(await pictures()).toBeGreaterThan(after);
  });
});

describe('time', () => {
  it('runs backwards while B is held, over bits that were there before, and forwards when it is let go', async () => {
    const page = await open('seed=3&count=40');
    // The hash of every step the page ever shows, by step.
    await page.evaluate(() => {
      const seen = new Map<number, string>();
      const look = () => {
        const { tick, hash } = __game.state();
        if (seen.has(tick) && seen.get(tick) !== hash) throw new Error(`Step ${tick} was different before.`);
        seen.set(tick, hash);
        requestAnimationFrame(look);
      };
      look();
    });
    await page.waitForFunction(() => __game.state().tick > 90);
    const before = await state(page);
    await page.keyboard.down('b');
    await page.waitForFunction((tick) => __game.state().tick < tick - 30, before.tick);
    await page.keyboard.up('b');
    const back = await state(page);
    expect(back.rewound).toBe(true);
    expect(back.time).toBeLessThan(before.time);
    await page.waitForFunction((tick) => __game.state().tick > tick, before.tick);
  });

  it('runs backwards while the button is held; a comma goes back by one step', async () => {
    const page = await open('manual&seed=3');
    await steps(page, 60);
    const button = page.locator('.game-bar button').first();
    await button.hover();
    await page.mouse.down();
    await page.waitForFunction(() => __game.state().tick < 50);
    expect(await button.getAttribute('aria-pressed')).toBe('true');
    await page.mouse.up();
    await page.waitForFunction(() => document.querySelector('.game-bar button')?.ariaPressed === 'false');
    const { tick } = await state(page);
    await page.keyboard.press(',');
    expect((await state(page)).tick).toBe(tick - 1);
    await page.keyboard.press(',');
    expect((await state(page)).tick).toBe(tick - 2);
  });

  it('brings back values, and bodies that were thrown', async () => {
    const page = await open('manual&seed=3');
    const hashes = await page.evaluate(() =>
      Array.from({ length: 31 }, (_, tick) => {
        if (tick > 0) __game.step();
        return __game.state().hash;
      }),
    );
    await page.evaluate(() => __game.set('gravity', 1));
    await steps(page, 30);
    await page.evaluate(() => __game.rewind(0.5));
    // To the last moment noted not after step 30; how many are noted depends on the machine.
    const { hash, tick, values } = await state(page);
    expect(tick).toBeLessThanOrEqual(30);
    expect({ hash, gravity: values.gravity }).toEqual({ hash: hashes[tick], gravity: 9.80665 });
    expect(await page.locator('.game-side input[type=text]').nth(1).inputValue()).toBe('9.80665');
  });

  it('runs at a fifth of its pace after S', async () => {
    const page = await open('seed=3');
    await page.keyboard.press('s');
    expect((await state(page)).speed).toBe(0.2);
    expect(await page.locator('button[title="Slow motion (S)"]').getAttribute('aria-pressed')).toBe('true');
    await page.keyboard.press('s');
    expect((await state(page)).speed).toBe(1);
  });
});

describe('the address', () => {
  it('keeps the settings that the panel, a key or a program changed, so that a reload has them', async () => {
    const page = await open('manual&seed=3');
    await page.evaluate(() => __game.set('gravity', 3));
    await page.evaluate(() => __game.set('count', 7));
    await page.waitForFunction(() => /gravity=3/.test(location.search));
    expect(Object.fromEntries(new URL(page.url()).searchParams)).toMatchObject({ gravity: '3', count: '7', seed: '3' });
    await page.reload();
    await ready(page);
    expect(await state(page)).toMatchObject({ seed: 3, count: 7, banner: '', values: { gravity: 3, count: 7 } });
    await page.locator('.game-side button', { hasText: 'Defaults' }).click();
    await page.waitForFunction(() => !/gravity|count/.test(location.search));
    expect(new URL(page.url()).searchParams.get('seed')).toBe('3');
  });
});

describe('figures', () => {
  it('E shows energy, momentum, angular momentum, any column, nothing, and energy again', async () => {
    const page = await open('manual&seed=3');
    const choice = card(page, 'Plot').locator('select').first();
    const seen: string[] = [await choice.inputValue()];
    for (let i = 0; i < 3; i++) {
      await page.keyboard.press('e');
      seen.push(await choice.inputValue());
    }
    expect(seen).toEqual(['Energy', 'Momentum', 'Angular momentum', 'Any value']);
    const columns = card(page, 'Plot').locator('select').nth(1);
    await columns.selectOption('Velocity.y');
    await steps(page, 30);
    await frames(page);
    expect(await card(page, 'Plot').locator('h2 i').allTextContents()).toEqual(['minimum', 'mean', 'maximum']);
    await card(page, 'Plot').locator('input').fill('2');
    await card(page, 'Plot').locator('input').blur();
    expect(await card(page, 'Plot').locator('h2 i').allTextContents()).toEqual(['body 2']);
    await page.keyboard.press('e');
    expect(await card(page, 'Plot').isVisible()).toBe(false);
    await page.keyboard.press('e');
    expect(await choice.inputValue()).toBe('Energy');
  });

  it('plots one quantity against another, with both in the numbers that are saved', async () => {
    const page = await open('manual&seed=3');
    const plot = card(page, 'Plot');
    const chosen = () =>
      plot.locator('select').evaluateAll((all) => all.map((each) => (each as HTMLSelectElement).value));
    await plot.getByText('Phase portrait').click();
    expect(await chosen()).toEqual(['Any value', 'Velocity.x', 'Position.x']);
    await plot.getByText('Path', { exact: true }).click();
    expect(await chosen()).toEqual(['Any value', 'Position.y', 'Position.x']);
    for (let i = 0; i < 5; i++) {
      await steps(page, 3);
      await frames(page);
    }
    const { x, y } = await body(page, 0);
    const saved = page.waitForEvent('download');
    await plot.getByText('CSV').click();
    const rows = String(await contentOf(await saved))
      .trim()
      .split('\n');
    expect(rows[0]).toBe('"t, s","Position.y body 1, m","Position.x, m"');
    expect(rows.at(-1)?.split(',').slice(1).map(Number)).toEqual([y, x]);
    await plot.locator('select').nth(2).selectOption('Energy.kinetic');
    await plot.locator('select').first().selectOption('Momentum');
    expect(await plot.locator('h2 i').allTextContents()).toEqual(['x', 'y']);
    await plot.locator('select').nth(2).selectOption({ label: 'time' });
    await steps(page, 3);
    await frames(page);
  });

  it('O shows where the time of a step goes', async () => {
    const page = await open('seed=3&count=2000');
    await page.keyboard.press('o');
    await page.waitForFunction(() => {
      const times = [...document.querySelectorAll('.game-profile:not([hidden]) dd')].map(
        ({ textContent }) => textContent,
      );
      return times.length === 8 && times.every((time) => /^[\d.]+ ms$/.test(time ?? ''));
    });
    await page.keyboard.press('o');
    expect(await card(page, 'Profile').isVisible()).toBe(false);
  });
});

describe('pictures', () => {
  it('I stores the picture with the ground behind it', async () => {
    const page = await open('manual&seed=3');
    await steps(page, 42);
    const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('i')]);
    expect(download.suggestedFilename()).toBe('bouncing-balls-0.7s.png');
    const { width, height, data } = PNG.sync.read(await contentOf(download));
    expect([width, height]).toEqual([900, 700]);
    let bright = 0;
    let clear = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] !== 255) clear++;
      if (Math.max(data[i], data[i + 1], data[i + 2]) > 200) bright++;
    }
    expect(clear).toBe(0);
    // Five balls of half a metre in a room of 16 m, and the deep blue behind them.
    expect(bright).toBeGreaterThan(500);
    expect(bright).toBeLessThan(0.2 * width * height);
  });

  it('J records a video until it is pressed again', async () => {
    const page = await open('seed=3');
    await page.keyboard.press('j');
    expect((await state(page)).recording).toBe(true);
    expect(await page.locator('.game-tools button[title^="Record video"]').textContent()).toBe('● Stop');
    await page.waitForTimeout(1200);
    const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('j')]);
    expect(download.suggestedFilename()).toMatch(/^bouncing-balls-[\d.]+s\.(mp4|webm)$/);
    const film = await contentOf(download);
    expect(film.length).toBeGreaterThan(5000);
    const plays = await page.evaluate(async (data) => {
      const video = document.createElement('video');
      video.muted = true;
      video.src = `data:video/webm;base64,${data}`;
      await video.play();
      return [video.videoWidth, video.videoHeight];
    }, film.toString('base64'));
    expect(plays).toEqual([900, 700]);
    expect((await state(page)).recording).toBe(false);
  });

  it('says so where the browser cannot film', async () => {
    const page = await open('manual', { prepare: () => Object.assign(globalThis, { MediaRecorder: undefined }) });
    await page.keyboard.press('j');
    expect((await state(page)).banner).toMatch(/cannot record video.*screen recorder/);
  });

  it('the key 8 starts a clip that a press gives up, and that another picture or a lost one ends', async () => {
    const page = await open('seed=3', { prepare: () => Object.assign(navigator, { canShare: () => false }) });
    const clip = page.locator('.game-tools [data-clip]');
    await page.keyboard.press('Space');
    await page.keyboard.press('8');
    // A clip shows play.
    expect((await state(page)).paused).toBe(false);
    expect(await clip.textContent()).toMatch(/^● [78] s$/);
    await clip.click();
    expect(await clip.textContent()).toBe('Share a clip');
    await page.keyboard.press('8');
    await page.keyboard.press('3');
    expect((await state(page)).banner).toMatch(/another picture took its place/);
    expect(await clip.textContent()).toBe('Share a clip');
    await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'three');
    await page.keyboard.press('8');
    expect(await clip.textContent()).toMatch(/^● [78] s$/);
    await loseGraphicsCard(page);
    expect(await clip.textContent()).toBe('Share a clip');
  });

  it('W fills the screen and gives it back, or says that it cannot', async () => {
    const page = await open('manual');
    await page.keyboard.press('w');
    await page.waitForFunction(() => document.fullscreenElement?.className === 'game');
    await page.keyboard.press('w');
    await page.waitForFunction(() => document.fullscreenElement === null);
    await page.evaluate(() => {
      Object.defineProperty(Element.prototype, 'requestFullscreen', { value: undefined });
    });
    await page.keyboard.press('w');
    await page.waitForFunction(() => __game.state().banner.includes('full screen'));
  });
});

describe('looks', () => {
  it('Y gives bodies colours of the Okabe-Ito palette, and the browser remembers', async () => {
    const page = await open('manual&seed=3');
    const before = (await state(page)).hash;
    await page.keyboard.press('y');
    expect((await state(page)).safeColors).toBe(true);
    // Colours are columns as well.
    expect((await state(page)).hash).not.toBe(before);
    await page.reload();
    await ready(page);
    expect((await state(page)).safeColors).toBe(true);
    await page.keyboard.press('y');
    expect(await state(page)).toMatchObject({ safeColors: false, hash: before });
  });

  it('X stops what moves for show', async () => {
    const page = await open('manual&seed=3');
    await page.keyboard.press('x');
    expect((await state(page)).reducedMotion).toBe(true);
    expect(await page.locator('.game').evaluate((game) => game.hasAttribute('data-reduced-motion'))).toBe(true);
  });
});

describe('help', () => {
  it('lists every key, and every key of the list does something', async () => {
    const page = await open('manual&seed=3');
    await page.keyboard.press('h');
    const lines = await page.locator('.game-help dt').allTextContents();
    for (const keys of [
      'Space',
      '.',
      ',',
      'Hold B',
      'S',
      'R',
      'F',
      '+ −',
      'E',
      'O',
      'I',
      'J',
      '8',
      'W',
      'X',
      'Y',
      'P',
      'H',
    ]) {
      expect(lines).toContain(keys);
    }
    await page.keyboard.press('h');
    expect(await page.locator('.game-help').isVisible()).toBe(false);
  });

  it('the canvas can have the keyboard, and says what it is', async () => {
    const page = await open('manual&seed=3');
    const canvas = page.locator('.game-stage canvas');
    await canvas.focus();
    expect(await canvas.evaluate((each) => document.activeElement === each)).toBe(true);
    expect(await canvas.getAttribute('aria-label')).toMatch(/Bouncing balls.*press H/);
  });
});

describe('attention', () => {
  it('a hidden page pauses its game, and the player decides when it goes on', async () => {
    const page = await open('seed=3');
    await page.waitForFunction(() => __game.state().tick > 3);
    await page.evaluate(() => {
      Object.defineProperty(document, 'hidden', { value: true, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
      Reflect.deleteProperty(document, 'hidden');
      document.dispatchEvent(new Event('visibilitychange'));
    });
    const hidden = await state(page);
    expect(hidden).toMatchObject({ paused: true, banner: expect.stringContaining('while the page was hidden') });
    await page.keyboard.press('Space');
    expect(await state(page)).toMatchObject({ paused: false, banner: '' });
  });

  it('a game whose graphics are lost waits, unseen, and goes on with them', async () => {
    const page = await open('seed=3');
    const giveBack = await loseGraphicsCard(page);
    const { tick } = await state(page);
    await page.waitForTimeout(400);
    expect((await state(page)).tick).toBe(tick);
    await giveBack();
    await page.waitForFunction((before) => __game.state().tick > before, tick);
  });

  it('a note leaves by itself, below the bar', async () => {
    const page = await open('manual&colour=red');
    const note = page.locator('.game-banner');
    const { y, height } = (await note.boundingBox()) as { y: number; height: number };
    expect(y + height).toBeLessThan(200);
    await note.waitFor({ state: 'hidden', timeout: 30_000 });
    expect((await state(page)).banner).toBe('');
  });

  it('a clicked button gives the focus back, so that Space pauses; only Tab frames the stage', async () => {
    const page = await open('seed=3');
    await page.locator('button[title="Slow motion (S)"]').click();
    await page.keyboard.press('Space');
    expect(await state(page)).toMatchObject({ paused: true, speed: 0.2 });
    await page.locator('.game-stage canvas').click({ position: { x: 300, y: 300 } });
    await page.locator('.game-stage canvas').focus();
    await page.keyboard.press('s');
    const frame = () => page.locator('.game-stage canvas').evaluate((canvas) => getComputedStyle(canvas).boxShadow);
    expect(await frame()).toBe('none');
    await page.keyboard.press('Tab');
    await page.locator('.game-stage canvas').focus();
    expect(await frame()).not.toBe('none');
  });

  it('keeps sliders from left to right where the page runs from right to left', async () => {
    const page = await open('manual');
    const slider = page.locator('.game-side .lil-slider').first();
    const box = (await slider.boundingBox()) as { x: number; y: number; width: number; height: number };
    const numbers = Object.entries((await state(page)).values).filter(([, value]) => typeof value === 'number');
    const [[name]] = numbers;
    const pressAt = async (share: number) => {
      await page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
      return (await state(page)).values[name];
    };
    const values = [await pressAt(0.25), await pressAt(0.75)];
    await page.evaluate(() => document.documentElement.setAttribute('dir', 'rtl'));
    expect(await slider.boundingBox()).toEqual(box);
    expect([await pressAt(0.25), await pressAt(0.75)]).toEqual(values);
    expect(values[0]).toBeLessThan(Number(values[1]));
  });

  it('leads home', async () => {
    const page = await open('manual');
    expect(await page.locator('.game-bar a[title="All games"]').getAttribute('href')).toBe('../index.html');
  });
});

describe('a phone', () => {
  it.each([
    [390, 844],
    [360, 740],
    [844, 390],
  ])('has buttons of 44 pixels in a bar that fits into %i by %i', async (width, height) => {
    const page = await open('manual', { viewport: { width, height }, isMobile: true, hasTouch: true });
    const boxes = await page.locator('.game-bar :is(button, a):visible').evaluateAll((all) =>
      all.map((each) => {
        const { left, right, width, height } = each.getBoundingClientRect();
        return { left, right, width, height };
      }),
    );
    expect(boxes.length).toBeGreaterThan(5);
    for (const box of boxes) {
      expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(width < 390 ? 40 : 44);
      expect(box.left).toBeGreaterThanOrEqual(0);
      expect(box.right).toBeLessThanOrEqual(width);
    }
  });
});

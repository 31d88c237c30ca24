// The laboratory: its list, and every example on its page.
import { readFileSync } from 'node:fs';
import { COLORS } from '@principia/scenes/examples';
import { EXAMPLES } from '@principia/scenes/examples/list';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { body, fingersOf, frames, playGame, ready, state, steps } from '../support/game-page.ts';
import { playAtRandom } from '../support/random-input.ts';

/** Half seconds of random input for every example: a few in each run, more with `RANDOM_INPUT=120`, which is a minute. */
const RANDOM_ROUNDS = Number(process.env.RANDOM_INPUT ?? 4);
/** Milliseconds that a round takes at most on a busy machine: 60 of steps, and the frames of a software renderer. */
const LONGEST_ROUND = 500;

declare global {
  var messages: string[];
}

/** Keeps what the page writes to the console, and the picture in its canvas, where it can be counted. */
const prepare = () => {
  globalThis.messages = [];
  for (const name of ['log', 'info', 'warn', 'error'] as const) {
    console[name] = (...text: unknown[]) => void globalThis.messages.push(text.join(' '));
  }
  const getContext = HTMLCanvasElement.prototype.getContext as (kind: string, options?: object) => unknown;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, options?: object) {
    return getContext.call(this, kind, kind === 'webgl2' ? { ...options, preserveDrawingBuffer: true } : options);
  } as typeof HTMLCanvasElement.prototype.getContext;
};

const laboratory = playGame('laboratory', { viewport: { width: 900, height: 600 }, prepare });
const consoleOf = (page: Page) => page.evaluate(() => globalThis.messages);

/** Pixels of the canvas that are not of its most frequent colour. */
async function drawnPixels(page: Page): Promise<number> {
  await frames(page);
  return page.evaluate(() => {
    const canvas = document.querySelector('.game-stage canvas') as HTMLCanvasElement;
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext('2d') as OffscreenCanvasRenderingContext2D;
    copy.drawImage(canvas, 0, 0);
    const counts = new Map<number, number>();
    for (const pixel of new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer)) {
      counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
    }
    return width * height - Math.max(...counts.values());
  });
}

/** Opens an example in a page that showed another one before, which takes half the time of a new page. */
async function tryExample(page: Page, { id, title }: (typeof EXAMPLES)[number]): Promise<void> {
  await page.goto(`${laboratory.url}?example=${id}&manual`);
  await ready(page);
  await steps(page, 30);
  expect(await page.title(), id).toContain(title);
  const { banner, tick } = await state(page);
  expect([banner, tick], id).toEqual(['', 30]);
  // A body of ten pixels across has 80.
  expect(await drawnPixels(page), id).toBeGreaterThan(40);
  expect(await consoleOf(page), id).toEqual([]);
  const errors = await playAtRandom(page, RANDOM_ROUNDS, 1 + EXAMPLES.findIndex((each) => each.id === id));
  expect(errors, id).toEqual([]);
}

/** Number and bounds of the pixels of each of some colours. */
async function regions(page: Page, colors: readonly number[]): Promise<{ count: number; box: number[] }[]> {
  await frames(page);
  return page.evaluate((wanted) => {
    const canvas = document.querySelector('.game-stage canvas') as HTMLCanvasElement;
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext('2d') as OffscreenCanvasRenderingContext2D;
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, width, height);
    return wanted.map((color) => {
      let [count, left, right, top, bottom] = [0, width, 0, height, 0];
      for (let i = 0; i < data.length; i += 4) {
        const isIt = [16, 8, 0].every((shift, k) => Math.abs(data[i + k] - ((color >> shift) & 255)) <= 2);
        if (!isIt) continue;
        const [x, y] = [(i / 4) % width, Math.floor(i / 4 / width)];
        count++;
        [left, right, top, bottom] = [
          Math.min(left, x),
          Math.max(right, x + 1),
          Math.min(top, y),
          Math.max(bottom, y + 1),
        ];
      }
      return { count, box: [right - left, bottom - top] };
    });
  }, colors);
}

const chapters = [...new Set(EXAMPLES.map(({ chapter }) => chapter))];

describe.each(chapters)('every example of chapter %i', (chapter) => {
  const examples = EXAMPLES.filter((example) => example.chapter === chapter);
  it(
    'opens, moves, draws and says nothing to the console',
    async () => {
      const page = await laboratory.open('', { until: 'nothing', viewport: { width: 600, height: 400 } });
      for (const example of examples) await tryExample(page, example);
    },
    120_000 + examples.length * RANDOM_ROUNDS * LONGEST_ROUND,
  );
});

describe('the drawing surface', () => {
  it('is 700 by 500, and white all over', async () => {
    const page = await laboratory.open('example=ch02-canvas-minimal&manual');
    const [{ count, box }] = await regions(page, [0xffffff]);
    // But for the dot, which covers a corner.
    expect(box[0] / box[1]).toBeCloseTo(700 / 500, 1);
    expect(count / (box[0] * box[1])).toBeGreaterThan(0.99);
  });

  it('shows on top what was drawn last', async () => {
    const page = await laboratory.open('example=ch02-canvas-layers&manual');
    const shares = async () => {
      const [red, green] = await regions(page, [COLORS.red, COLORS.green]);
      return green.count / red.count;
    };
    // 50 by 100 px of both overlap: red, so that green keeps 75 000 - 5000 px², and then green.
    expect(await shares()).toBeCloseTo(70_000 / 30_000, 1);
    await page.evaluate(() => __game.set('last', 'green'));
    expect(await shares()).toBeCloseTo(75_000 / 25_000, 1);
  });
});

describe('a ball that is dragged', () => {
  it('is where the pointer is, and falls from there', async () => {
    const page = await laboratory.open('example=ch02-drag-drop&manual');
    const on = async () => (await body(page, 0)).screen as { x: number; y: number };
    const stage = (await page.locator('.game-stage').boundingBox()) as { x: number; y: number };
    const { x, y } = await on();
    await page.mouse.move(stage.x + x, stage.y + y);
    await page.mouse.down();
    for (const [dx, dy] of [
      [30, 10],
      [-60, 40],
      [15, 70],
    ]) {
      await page.mouse.move(stage.x + x + dx, stage.y + y + dy, { steps: 4 });
      await steps(page, 60);
      await frames(page);
      const now = await on();
      expect(Math.abs(now.x - x - dx)).toBeLessThan(1);
      expect(Math.abs(now.y - y - dy)).toBeLessThan(1);
    }
    await page.mouse.up();
    const { y: height } = await body(page, 0);
    await steps(page, 60);
    // With y downwards; half a second of 360 px/s² is more than the 20 px that are asked for.
    expect((await body(page, 0)).y).toBeGreaterThan(height + 20);
  });
});

describe('a press on the picture', () => {
  /** Place on the page of a point of the world, by those of two bodies. */
  async function pageOf(page: Page, at: { x: number; y: number }) {
    const [a, b] = await Promise.all([body(page, 1), body(page, 2)]);
    const stage = (await page.locator('.game-stage').boundingBox()) as { x: number; y: number };
    const [p, q] = [a.screen, b.screen] as { x: number; y: number }[];
    return {
      x: stage.x + p.x + ((at.x - a.x) * (q.x - p.x)) / (b.x - a.x),
      y: stage.y + p.y + ((at.y - a.y) * (q.y - p.y)) / (b.y - a.y),
    };
  }

  it('places a planet, on a circle, or with the velocity that a drag draws; a second finger takes it back', async () => {
    const page = await laboratory.open('example=ch10-multiple-orbiters&manual', { hasTouch: true });
    const last = async () => body(page, (await state(page)).count - 1);
    const { count: bodies } = await state(page);
    const from = await pageOf(page, { x: 520, y: 380 });
    await page.mouse.click(from.x, from.y);
    expect((await state(page)).count).toBe(bodies + 1);
    const circling = await last();
    expect([circling.x, circling.y].map((value, i) => Math.abs(value - [520, 380][i]) < 3)).toEqual([true, true]);
    // At right angles to the radius, at √(GM/r).
    expect(Math.abs((circling.x - 400) * circling.vx + (circling.y - 300) * circling.vy)).toBeLessThan(1e-6);
    expect(Math.hypot(circling.vx, circling.vy)).toBeCloseTo(Math.sqrt(1e6 / Math.hypot(120, 80)), 0);
    const start = await pageOf(page, { x: 250, y: 180 });
    const end = await pageOf(page, { x: 310, y: 210 });
    await page.mouse.move(start.x, start.y);
    await page.mouse.down();
    await page.mouse.move(end.x, end.y, { steps: 3 });
    expect((await state(page)).count).toBe(bodies + 1);
    await page.mouse.up();
    const thrown = await last();
    expect(Math.hypot(thrown.vx - 60, thrown.vy - 30)).toBeLessThan(3);
    const touch = await fingersOf(page);
    await touch('touchStart', [{ ...start, id: 0 }]);
    await touch('touchStart', [
      { ...start, id: 0 },
      { ...end, id: 1 },
    ]);
    await touch('touchEnd');
    expect((await state(page)).count).toBe(bodies + 2);
    expect(await page.textContent('.lab-pointer')).toContain('Press the picture: place a planet there');
  });

  it('holds as long as it lasts what an action holds', async () => {
    const page = await laboratory.open('example=ch02-pause&manual');
    await steps(page, 30);
    const { x, y } = (await page.locator('.game-stage').boundingBox()) as { x: number; y: number };
    await page.mouse.move(x + 300, y + 120);
    await page.mouse.down();
    await steps(page, 2);
    const held = await body(page, 0);
    await steps(page, 30);
    expect((await body(page, 0)).x).toBe(held.x);
    await page.mouse.up();
    await steps(page, 30);
    expect((await body(page, 0)).x).toBeGreaterThan(held.x + 20);
  });

  it('acts in a view of three dimensions when it stays; a drag turns the view', async () => {
    const page = await laboratory.open('example=ch15-cube-rotation&manual');
    const energyAfter = async (count: number) => {
      await steps(page, count);
      return (await state(page)).energy.kinetic;
    };
    // The torque is off after 2400 steps, and the cube slows down.
    const slowing = await energyAfter(3600);
    const { x, y } = (await page.locator('.game-stage').boundingBox()) as { x: number; y: number };
    await page.mouse.move(x + 120, y + 120);
    await page.mouse.down();
    await page.mouse.move(x + 160, y + 120, { steps: 4 });
    await page.waitForTimeout(300);
    const dragged = await energyAfter(240);
    expect(dragged).toBeLessThan(slowing);
    await page.mouse.up();
    // The reader did not take part yet.
    const figures = () => page.textContent('.lab-checks');
    expect(await figures()).not.toContain('left alone');
    await page.mouse.down();
    await page.waitForTimeout(300);
    const held = await energyAfter(240);
    expect(held).toBeGreaterThan(dragged);
    await page.mouse.up();
    expect(await energyAfter(240)).toBeLessThan(held);
    await expect.poll(figures).toContain('left alone');
  });
});

describe('the list', () => {
  it('shows all examples with their pictures, and finds some', async () => {
    const page = await laboratory.open('', { until: 'nothing' });
    const items = page.locator('.start li');
    await page.waitForFunction(() => document.querySelectorAll('.start-picture svg').length > 0);
    // Six stand above the chapters as well.
    expect(await page.locator('.start-striking li').count()).toBe(6);
    expect(await items.count()).toBe(EXAMPLES.length + 6);
    expect(await page.locator('.start-picture svg').count()).toBe(EXAMPLES.length + 6);
    await page.fill('input[type=search]', 'orbit fixed');
    expect(await items.allTextContents()).toEqual(expect.arrayContaining([expect.stringContaining('fixed sun')]));
    expect(await items.count()).toBeLessThan(EXAMPLES.length);
    expect(page.url()).toContain('search=orbit');
    await page.click('.start li a');
    await ready(page);
    expect(page.url()).toContain('example=ch06-orbits');
  });

  it('is shown for an example that does not exist, with a sentence', async () => {
    const page = await laboratory.open('example=nonsense', { until: 'nothing' });
    expect(await page.textContent('[role=alert]')).toContain('There is no example “nonsense”');
    expect(await consoleOf(page)).toEqual([]);
  });
});

describe('the page of an example', () => {
  it('proves its figures while one watches', async () => {
    const page = await laboratory.open('example=ch06-orbits&manual');
    const count = (of: string) => page.locator(`.lab-checks li[data-state="${of}"]`).count();
    await page.waitForSelector('.lab-checks li[data-state=waiting]');
    const total = await count('waiting');
    await steps(page, 61 * 60);
    await page.waitForFunction(() => document.querySelector('.lab-checks li[data-state=waiting]') === null);
    expect(await count('passed')).toBe(total);
    expect(await page.textContent('.lab-checks')).toMatch(/computed 25\.54\d*, exact 25\.5449 s, error/);
    expect(await page.textContent('.lab-words')).toContain(`${total} of ${total} figures confirmed`);
    await page.evaluate(() => __game.reset());
    await page.waitForFunction(
      (all) => document.querySelectorAll('.lab-checks li[data-state=waiting]').length === all,
      total,
    );
  });

  it('keeps parameters in the address, and a link to a moment brings back its state to the bit', async () => {
    const page = await laboratory.open('example=ch06-orbits&manual');
    await page.evaluate(() => __game.set('vx', 85));
    expect(page.url()).toMatch(/\?example=ch06-orbits&vx=85&manual/);
    await steps(page, 333);
    const { hash } = await state(page);
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.click('text=Copy link');
    const link = await page.evaluate(() => navigator.clipboard.readText());
    const other = await laboratory.open(new URL(link).search.slice(1));
    await other.waitForFunction(() => __game.state().tick === 333);
    expect((await state(other)).hash).toBe(hash);
  });

  it('brings back in a link which plots are open, and what the plot of the reader shows', async () => {
    const page = await laboratory.open('example=ch08-damped&manual');
    await steps(page, 60);
    const charts = page.locator('.lab-plot');
    await charts.nth(0).locator('button:text("Error")').click();
    await charts.nth(1).locator('.lab-fold').click();
    const own = page.locator('section[aria-label=Plot]');
    await own.getByText('Phase portrait').click();
    expect(await charts.nth(1).locator('.uplot').isVisible()).toBe(false);
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    const links = [];
    // Beside the text of the example, and among the tools.
    for (const button of await page.locator('button:text("Copy link")').all()) {
      await button.click();
      links.push(await page.evaluate(() => navigator.clipboard.readText()));
    }
    expect(links).toHaveLength(2);
    expect(links[1]).toBe(links[0]);
    expect(links[0]).toContain('plot=Velocity.x,Position.x,2&folded=2&errors=1');
    const other = await laboratory.open(new URL(links[0]).search.slice(1));
    await other.waitForFunction(() => __game.state().tick === 60);
    expect(await state(other)).toMatchObject({ banner: '', plot: 'Velocity.x,Position.x,2' });
    const same = other.locator('.lab-plot');
    expect(await same.nth(0).locator('button:text("Error")').getAttribute('aria-pressed')).toBe('true');
    expect(await same.nth(1).locator('.uplot').isVisible()).toBe(false);
    // The lines are there as well: half a second of 20 s, of which a plot takes 400 samples.
    const [saved] = await Promise.all([other.waitForEvent('download'), same.nth(0).locator('text=CSV').click()]);
    expect(
      readFileSync(await saved.path(), 'utf8')
        .trim()
        .split('\n').length,
    ).toBeGreaterThanOrEqual(1 + 10);
  });

  it('copies a link where the browser lets no page copy: into the address bar', async () => {
    const page = await laboratory.open('example=ch06-orbits&manual');
    await page.evaluate(() => {
      navigator.clipboard.writeText = () => Promise.reject(new Error('denied'));
    });
    await page.locator('button:text("Copy link")').first().click();
    await page.waitForFunction(() => document.querySelector('.lab-said')?.textContent?.includes('in the address bar'));
    expect(page.url()).toContain('step=0');
    expect((await state(page)).banner).toBe('');
  });

  it('goes to and fro on the bar of the recorded time, and forgets what came later when it plays on', async () => {
    const page = await laboratory.open('example=ch06-orbits&manual');
    await steps(page, 600);
    await page.waitForFunction(
      () => Number(document.querySelector<HTMLInputElement>('.game-timeline input')?.max) > 30,
    );
    const end = await state(page);
    const bar = page.locator('.game-timeline input');
    const { x, y, width, height } = (await bar.boundingBox()) as {
      x: number;
      y: number;
      width: number;
      height: number;
    };
    expect(height).toBeGreaterThanOrEqual(44);
    await page.mouse.move(x + width - 4, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2, y + height / 2, { steps: 3 });
    const past = await state(page);
    expect(past.time).toBeCloseTo(5, 0);
    expect([past.isPast, past.paused]).toEqual([true, true]);
    await page.mouse.move(x + width - 1, y + height / 2, { steps: 3 });
    await page.mouse.up();
    const { hash, tick, isPast } = await state(page);
    expect([hash, tick, isPast]).toEqual([end.hash, 600, false]);
    // By keyboard, one moment at a time.
    await bar.press('ArrowLeft');
    const before = await state(page);
    expect(before.tick).toBeLessThan(600);
    await bar.press('ArrowLeft');
    await bar.press('ArrowRight');
    expect((await state(page)).hash).toBe(before.hash);
    expect(await bar.getAttribute('aria-valuetext')).toBe(`${before.time.toFixed(2)} s`);
    await steps(page, 600 - before.tick);
    expect(await state(page)).toMatchObject({ hash: end.hash, isPast: false });
  });

  it('flies the camera until the reader takes it, and not where motion is reduced', async () => {
    /** Height of the Sun on the screen, which moves with the camera. */
    const sunAfter = async (page: Page, count: number) => {
      await steps(page, count);
      await frames(page);
      return (await body(page, 0)).screen?.y as number;
    };
    const page = await laboratory.open('example=ch16-solar-animated&manual');
    const [start, flown] = [await sunAfter(page, 0), await sunAfter(page, 2400)];
    expect(Math.abs(flown - start)).toBeGreaterThan(20);
    await page.mouse.click(30, 400);
    const taken = await sunAfter(page, 0);
    expect(await sunAfter(page, 1200)).toBeCloseTo(taken, 0);
    await page.keyboard.press('f');
    expect(Math.abs((await sunAfter(page, 0)) - taken)).toBeGreaterThan(20);
    const still = await laboratory.open('example=ch16-solar-animated&manual', { reducedMotion: 'reduce' });
    expect(await sunAfter(still, 2400)).toBeCloseTo(await sunAfter(still, 0), 0);
  });

  it('says what is wrong with an address, and goes on', async () => {
    const wrong = 'gravity=999&step=x&camera=0,0,-5&plot=Position.q&folded=9&errors=1,a';
    const page = await laboratory.open(`example=ch05-floating-ball&${wrong}&manual#code=garbage`);
    const { banner, values } = await state(page);
    expect(banner).toContain('camera must be 3 numbers');
    expect(banner).toContain('plot must be off, or what is plotted');
    expect(banner).toContain('folded must be numbers of plots');
    expect(banner).toContain('errors must be numbers of plots');
    expect(banner).toContain('The code that this link brings cannot be read');
    expect(banner).toContain('gravity must be a number from 1 to 100 px/s²');
    expect(banner).toContain('step must be a whole number');
    expect(values.gravity).toBe(50);
  });

  it('shows other integrators as ghosts that follow, rewinding included', async () => {
    const page = await laboratory.open('example=ch06-orbits&ghosts=integrators&manual');
    await steps(page, 300);
    await frames(page);
    expect(await page.textContent('.lab-plots')).toContain('explicit Euler');
    await page.evaluate(() => __game.rewind(2));
    await steps(page, 10);
    await frames(page);
    expect(await consoleOf(page)).toEqual([]);
  });
});

describe('the code of an example', () => {
  const edit = async (page: Page, from: string, to: string) => {
    const text = await page.inputValue('.lab-code textarea');
    expect(text).toContain(from);
    await page.fill('.lab-code textarea', text.replace(from, to));
    await page.click('.lab-code button:text("Run")');
  };
  const note = async (page: Page) => {
    await page.waitForFunction(() => !document.querySelector('.lab-code-note')?.textContent?.startsWith('Trying'));
    return page.textContent('.lab-code-note');
  };

  it('begins with a ball to keep up where the reader asks for a new one, and keeps what was made of it', async () => {
    const page = await laboratory.open('', { until: 'nothing' });
    await page.click('.start-new');
    await ready(page);
    await page.waitForSelector('.lab-code textarea');
    await steps(page, 60);
    await edit(page, "title: 'Keep it up'", "title: 'Two balls'");
    await page.waitForFunction(() => document.title.includes('Two balls'));
    await ready(page);
    expect(page.url()).toContain('example=new');
    expect(await consoleOf(page)).toEqual([]);
  });

  it('is closed again by its own button, as on a phone it covers the settings', async () => {
    const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
    const page = await laboratory.open('example=ch06-orbits&code=on&manual', phone);
    await page.locator('.lab-code button:text("Close")').tap();
    expect(await page.locator('.lab-code').isVisible()).toBe(false);
    expect((await state(page)).values.code).toBe(false);
    expect(page.url()).not.toContain('code=on');
  });

  it('is stopped where it prints a million lines, in a sentence with its line', async () => {
    const page = await laboratory.open('example=ch05-floating-ball&code=on&manual');
    await page.waitForSelector('.lab-code textarea');
    await edit(page, 'const body =', 'for (let i = 0; i < 1e6; i++) console.log(i); const body =');
    expect(await note(page)).toMatch(/^Line \d+: The code prints more than 2000 lines/);
    await steps(page, 10);
    expect((await state(page)).tick).toBe(10);
  });

  it('says so where the browser keeps nothing, and takes the original back', async () => {
    const refuse = () => {
      Object.defineProperty(globalThis, 'sessionStorage', {
        get() {
          throw new DOMException('Not allowed.', 'SecurityError');
        },
      });
    };
    const page = await laboratory.open('example=ch05-floating-ball&code=on&manual', { prepare: refuse });
    await page.waitForSelector('.lab-code textarea');
    const original = await page.inputValue('.lab-code textarea');
    await edit(page, "title: 'A ball thrown into water'", "title: 'A ball of my own'");
    expect(await note(page)).toMatch(/^This browser keeps nothing for this page/);
    await steps(page, 10);
    await Promise.all([page.waitForEvent('framenavigated'), page.locator('.lab-code button:text("Original")').click()]);
    await ready(page);
    await page.waitForSelector('.lab-code textarea');
    expect(await page.inputValue('.lab-code textarea')).toBe(original);
  });

  it('names the line of an error, survives a loop without end, and runs what was changed', async () => {
    const page = await laboratory.open('example=ch05-floating-ball&code=on&manual');
    await page.waitForSelector('.lab-code textarea');
    const original = await page.inputValue('.lab-code textarea');
    await edit(page, 'mass: 1, hull', 'mass: 1 hull');
    expect(await note(page)).toMatch(/^Line \d+: Unexpected token/);
    await page.fill('.lab-code textarea', original);
    await edit(page, 'const body =', 'for (;;) {} const body =');
    expect(await note(page)).toMatch(/^Line \d+: This loop did not come to an end/);
    await page.fill('.lab-code textarea', original);
    await edit(page, 'const body =', 'world.phases.input.push(() => { while (world.tick > 700) {} });\nconst body =');
    await page.waitForFunction(() => !document.querySelector('.lab-code-note')?.textContent?.startsWith('Trying'));
    await ready(page);
    await expect(steps(page, 800)).rejects.toThrow('This loop did not come to an end');
    await page.fill('.lab-code textarea', original);
    await edit(page, "title: 'A ball thrown into water'", "title: 'A ball of my own'");
    await page.waitForFunction(() => document.title.includes('my own'));
    await ready(page);
    expect(await consoleOf(page)).toEqual([]);
  });

  it('is in the link to a moment, which opens the same state once its reader runs it', async () => {
    const page = await laboratory.open('example=new&code=on&manual');
    await page.waitForSelector('.lab-code textarea');
    await edit(page, "title: 'Keep it up'", "title: 'Two balls'");
    await page.waitForFunction(() => document.title.includes('Two balls'));
    await ready(page);
    await steps(page, 54);
    const { hash } = await state(page);
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.click('.lab-about button:text("Copy link")');
    const link = new URL(await page.evaluate(() => navigator.clipboard.readText()));
    const other = await laboratory.open(link.search.slice(1) + link.hash);
    await other.waitForSelector('.lab-code textarea');
    expect(await other.title()).toContain('Keep it up');
    expect(await other.inputValue('.lab-code textarea')).toContain('Two balls');
    await other.click('.lab-code button:text("Run")');
    await other.waitForFunction(() => document.title.includes('Two balls'));
    await other.waitForFunction(() => (globalThis as { __game?: typeof __game }).__game?.state().tick === 54);
    expect((await state(other)).hash).toBe(hash);
  });
});

it('has the words beside the picture on a phone on its side', async () => {
  const phone = { viewport: { width: 740, height: 360 }, hasTouch: true, isMobile: true };
  const page = await laboratory.open('example=ch17-character&manual', phone);
  const side = (await page.locator('.game-side').boundingBox()) as { x: number; y: number; height: number };
  const bar = (await page.locator('.game-bar').boundingBox()) as { x: number; width: number };
  const timeline = (await page.locator('.game-timeline').boundingBox()) as { x: number; y: number; width: number };
  expect(side.x).toBeGreaterThan(740 / 2);
  expect(side.height).toBeGreaterThan(300);
  expect(bar.x + bar.width).toBeLessThanOrEqual(side.x);
  expect(timeline.x + timeline.width).toBeLessThanOrEqual(side.x);
  // The picture has the height between the bar and the recorded time.
  expect(timeline.y).toBeGreaterThan(300);
});

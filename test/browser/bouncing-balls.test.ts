/** Plays the game of bouncing balls through its real page: keys, mouse, fingers, address. */
import { stateHash, step } from '@principia/physics';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { applyColors } from '../../games/bouncing-balls/colors.ts';
import { createBalls, parameters } from '../../games/bouncing-balls/sim.ts';
import { body, fingersOf, frames, loseGraphicsCard, pictureOf, playGame, state, steps } from '../support/game-page.ts';

const GRAVITY = 9.80665;
const DT = 1 / 60;

const { open } = playGame('bouncing-balls', { viewport: { width: 900, height: 600 }, hasTouch: true });

/** Five balls in 2D that pass through each other, unless a test asks for something else. */
const FEW = 'renderer=pixi&count=5&collisions=off&restitution=0.8';
const play = (query: string, options?: Parameters<typeof open>[1]) => open(`${FEW}&${query}`, options);

/** Pixels of the picture that are as bright and coloured as nothing but balls is. */
async function brightPixels(page: Page): Promise<number> {
  const png = (await pictureOf(page)).toString('base64');
  return page.evaluate(async (data) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const canvas = new OffscreenCanvas(image.width, image.height).getContext('2d') as OffscreenCanvasRenderingContext2D;
    canvas.drawImage(image, 0, 0);
    const { data: bytes } = canvas.getImageData(0, 0, image.width, image.height);
    let bright = 0;
    for (let i = 0; i < bytes.length; i += 4) {
      const low = Math.min(bytes[i], bytes[i + 1], bytes[i + 2]);
      const high = Math.max(bytes[i], bytes[i + 1], bytes[i + 2]);
      if (high > 150 && high - low > 80) bright++;
    }
    return bright;
  }, png);
}

/** CSS pixels per metre of the 2D picture, and the place of the world's origin on the canvas. */
async function scaleOf(page: Page) {
  const [a, b] = [await body(page, 0), await body(page, 1)];
  const [p, q] = [a.screen, b.screen] as { x: number; y: number }[];
  const pixels = Math.hypot(p.x - q.x, p.y - q.y) / Math.hypot(a.x - b.x, a.y - b.y);
  return { pixels, x: p.x - a.x * pixels, y: p.y + a.y * pixels };
}

describe('the page', () => {
  it('lets balls fall, and draws them', async () => {
    const page = await play('seed=8');
    const before = await state(page);
    expect(before.count).toBe(5);
    await page.waitForFunction((tick) => __game.state().tick > tick + 20, before.tick);
    await page.evaluate(() => __game.pause());
    const pixels = (await scaleOf(page)).pixels;
    const after = await state(page);
    expect(after.hash).not.toBe(before.hash);
    expect(after.energy.potential).toBeLessThan(before.energy.potential);
    // Highlights and marks are not coloured, and balls may cover each other.
    const discs = 5 * Math.PI * (0.25 * pixels) ** 2;
    const seen = await brightPixels(page);
    expect(seen).toBeGreaterThan(0.5 * discs);
    expect(seen).toBeLessThan(1.02 * discs);
  });

  it.each([2, 3] as const)('gives the bits that Node gives, in %iD', async (dimensions) => {
    const page = await play(`manual&seed=7&count=300&drag=1.2&renderer=${dimensions === 2 ? 'pixi' : 'three'}`);
    await steps(page, 200);
    const values = {
      count: 300,
      gravity: parameters.gravity.initial,
      restitution: 0.8,
      drag: 1.2,
      friction: 0.3,
      collisions: false,
      wrap: false,
    };
    const sim = createBalls({ values, seed: 7, dimensions });
    applyColors(sim, 7);
    for (let i = 0; i < 200; i++) step(sim.world, sim.dt);
    expect((await state(page)).hash).toBe(stateHash(sim.world));
  });

  it('bounces to e² of the height', async () => {
    const page = await play('manual&count=1&friction=0&restitution=0.7&seed=5');
    const start = await body(page, 0);
    expect(start.vy).toBeLessThan(2); // else it would meet the ceiling
    const fallen = start.y - start.radius + start.vy ** 2 / (2 * GRAVITY);
    const flight = await page.evaluate(() =>
      Array.from({ length: 150 }, () => {
        __game.step();
        return __game.body(0);
      }),
    );
    const bounce = flight.findIndex(({ vy }, i) => vy > 0 && flight[i - 1]?.vy < 0);
    const apex = Math.max(...flight.slice(bounce).map(({ y, radius }) => y - radius));
    // A step may straddle the apex: half a step away from it the ball is g dt²/8 lower.
    const missed = (GRAVITY * DT ** 2) / 8 / (0.49 * fallen);
    expect(apex / (0.49 * fallen)).toBeGreaterThan(1 - missed - 1e-4);
    expect(apex / (0.49 * fallen)).toBeLessThan(1 + 1e-4);
  });

  it('says what it cannot take from the address, and plays on', async () => {
    const page = await play('manual&count=abc&seed=-1&colour=red&renderer=four&gravity=1000');
    const { banner, values, seed, renderer } = await state(page);
    expect(await page.locator('.game-banner').isVisible()).toBe(true);
    expect(banner).toContain('count must be a whole number from 1 to 100000, but it was “abc”. Using 5 instead.');
    expect(banner).toContain('seed must be a whole number from 0 to 4294967295');
    expect(banner).toContain('“colour”, which this game does not have');
    expect(banner).toContain('renderer must be three or pixi');
    expect(banner).toContain('gravity must be a number from 0 to 30 m/s²');
    expect({ count: values.count, seed, renderer }).toEqual({ count: 5, seed: 1, renderer: 'pixi' });
  });

  it('waits where the system asks for little motion', async () => {
    const page = await play('', { reducedMotion: 'reduce' });
    expect(await state(page)).toMatchObject({ paused: true, tick: 0 });
    expect((await state(page)).banner).toContain('reduced motion');
  });
});

describe('keys and the panel', () => {
  it('pauses without changing a bit, steps once, and starts again at the same bits', async () => {
    const page = await play('seed=5');
    await page.waitForFunction(() => __game.state().tick > 3);
    await page.keyboard.press('Space');
    const paused = await state(page);
    expect(paused.paused).toBe(true);
    await page.waitForTimeout(300);
    expect((await state(page)).hash).toBe(paused.hash);
    await page.keyboard.press('.');
    const stepped = await state(page);
    expect(stepped.tick).toBe(paused.tick + 1);
    expect(stepped.hash).not.toBe(paused.hash);
    await page.keyboard.press('r');
    const fresh = await state(page);
    expect(fresh).toMatchObject({ tick: 0, time: 0 });
    await steps(page, 50);
    await page.keyboard.press('r');
    expect((await state(page)).hash).toBe(fresh.hash);
    await page.keyboard.press('Space');
    await page.waitForFunction(() => __game.state().tick > 0);
  });

  it('changes the world with sliders and switches', async () => {
    const page = await play('manual');
    const rows = page.locator('.lil-gui .lil-controller');
    const drag = async (label: string, to: number) => {
      const box = await rows.filter({ hasText: label }).locator('.lil-slider').boundingBox();
      if (box === null) throw new Error(`no slider ${label}`);
      await page.mouse.move(box.x + 5, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + to * box.width, box.y + box.height / 2, { steps: 4 });
      await page.mouse.up();
    };
    await drag('Balls', 0.6);
    // The slider is logarithmic: 0.6 of the way from 1 to 100 000 is 1000, within a pixel of some ninety.
    await page.waitForFunction(() => __game.state().count > 800 && __game.state().count < 1250);
    await drag('Gravity', 0.5);
    expect((await state(page)).values.gravity).toBeCloseTo(15, -0.5);
    const restitution = rows.filter({ hasText: 'Restitution' }).locator('input');
    await restitution.fill('0.25');
    await restitution.press('Enter');
    expect((await state(page)).values.restitution).toBe(0.25);
    const typed = rows.filter({ hasText: 'Balls' }).locator('input');
    await typed.fill('321');
    await typed.press('Enter');
    await page.waitForFunction(() => __game.state().count === 321);
    await page.locator('canvas').first().focus();
    await page.keyboard.press('t');
    expect((await state(page)).values.trails).toBe(true);
    await steps(page, 10);
    await frames(page);
  });

  it('keeps the values from 2D to 3D and back', async () => {
    const page = await play('manual&count=40&restitution=0.5&trails');
    const flat = await state(page);
    await page.keyboard.press('3');
    await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'three');
    const solid = await state(page);
    expect(solid).toMatchObject({ count: 40, values: flat.values });
    expect(solid.hash).not.toBe(flat.hash);
    await steps(page, 40);
    expect(Math.abs((await body(page, 3)).z)).toBeGreaterThan(0.01);
    expect(await brightPixels(page)).toBeGreaterThan(500);
    await page.keyboard.press('2');
    await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'pixi');
    expect(await state(page)).toMatchObject({ count: 40, values: flat.values, hash: flat.hash });
    expect(await brightPixels(page)).toBeGreaterThan(500);
  });
});

describe('holding and throwing', () => {
  it.each(['pixi', 'three'])('a ball follows the mouse: %s', async (renderer) => {
    const page = await play(`manual&renderer=${renderer}&friction=0`);
    await steps(page, 20);
    const ball = await body(page, 2);
    const from = ball.screen as { x: number; y: number };
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    expect((await state(page)).dragged).toEqual([ball.id]);
    await page.mouse.move(from.x + 72, from.y + 48, { steps: 6 });
    // A hand moves a ball at 50 m/s at most: it takes a few steps to get there.
    await steps(page, 4);
    const carried = await body(page, 2);
    expect(carried.screen?.x).toBeCloseTo(from.x + 72, -0.3);
    expect(carried.screen?.y).toBeCloseTo(from.y + 48, -0.3);
    await page.waitForTimeout(150);
    await page.mouse.up();
    // The mouse rested before it let go: the ball is dropped, not thrown.
    expect((await state(page)).dragged).toEqual([]);
    expect(await body(page, 2)).toMatchObject({ vx: 0, vy: 0 });
  });

  it.each(['pixi', 'three'])('a thrown ball leaves with the velocity of the mouse: %s', async (renderer) => {
    const page = await play(`manual&friction=0&renderer=${renderer}`);
    await steps(page, 20);
    const client = await page.context().newCDPSession(page);
    const { screen, x, y } = await body(page, 2);
    const from = screen as { x: number; y: number };
    // The browser takes these for what the mouse reported, with times of its own: a busy machine changes nothing.
    const start = Date.now() / 1000;
    const mouse = (type: 'mousePressed' | 'mouseMoved' | 'mouseReleased', frame: number, dx: number, dy: number) =>
      client.send('Input.dispatchMouseEvent', {
        type,
        x: from.x + dx,
        y: from.y + dy,
        timestamp: start + frame / 100,
        button: 'left' as const,
        buttons: 1,
        clickCount: 1,
      });
    await mouse('mousePressed', 0, 0, 0);
    for (let i = 1; i <= 20; i++) await mouse('mouseMoved', i, 5 * i, 3 * i);
    // A hand moves a ball at 50 m/s at most: it takes a few steps to get there.
    await steps(page, 4);
    const carried = await body(page, 2);
    await mouse('mouseReleased', 20, 100, 60);
    const thrown = await body(page, 2);
    // The ball went as far in its world as the mouse, in the 0.2 s that the mouse took; the browser's clock for events
    // is rounded to 0.1 ms, of the 80 ms that the estimate looks back.
    expect(Math.abs(thrown.vx / ((carried.x - x) / 0.2) - 1)).toBeLessThan(0.005);
    expect(Math.abs(thrown.vy / ((carried.y - y) / 0.2) - 1)).toBeLessThan(0.005);
    expect(thrown.vx).toBeGreaterThan(3);
    await steps(page, 6);
    const flown = await body(page, 2);
    expect(flown.x - thrown.x).toBeCloseTo(thrown.vx * 0.1, 3);
    expect(flown.y - thrown.y).toBeCloseTo(thrown.vy * 0.1 - (GRAVITY * 0.1 ** 2) / 2, 3);
  });

  it('a held ball pushes the others, where balls meet', async () => {
    // Thick air stops both on the floor, far from the walls.
    const page = await play('manual&count=2&collisions&restitution=0&friction=0&drag=100');
    await steps(page, 300);
    const [held, other] = [await body(page, 0), await body(page, 1)];
    const from = held.screen as { x: number; y: number };
    const to = other.screen as { x: number; y: number };
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    for (let i = 1; i <= 60; i++) {
      await page.mouse.move(from.x + (i * (to.x - from.x)) / 60, from.y);
      await steps(page, 1);
    }
    const [after, pushed] = [await body(page, 0), await body(page, 1)];
    expect(after.x).toBeCloseTo(other.x, 1);
    expect(Math.hypot(pushed.x - after.x, pushed.y - after.y)).toBeGreaterThan(1.9 * held.radius);
    expect((await state(page)).contacts).toBeGreaterThanOrEqual(0);
    await page.mouse.up();
    await page.keyboard.press('c');
    expect((await state(page)).contacts).toBeUndefined();
  });

  it('two fingers hold two balls', async () => {
    const page = await play('manual&count=6&friction=0');
    await steps(page, 20);
    const touch = await fingersOf(page);
    const all = await Promise.all(Array.from({ length: 6 }, (_, i) => body(page, i)));
    // A finger takes the nearest ball, so only balls that no other covers will do.
    const clear = all.filter((a) =>
      all.every((b) => a === b || Math.hypot(a.x - b.x, a.y - b.y) > a.radius + b.radius),
    );
    const before = clear.slice(0, 2);
    expect(before).toHaveLength(2);
    const fingers = before.map(({ screen }, id) => ({ x: screen?.x ?? 0, y: screen?.y ?? 0, id }));
    await touch('touchStart', fingers.slice(0, 1));
    await touch('touchStart', fingers);
    await page.waitForFunction(() => __game.state().dragged.length === 2);
    expect((await state(page)).dragged).toEqual(before.map(({ id }) => id));
    const moved = fingers.map(({ x, y, id }) => ({ x: x + 30, y: y + (id === 0 ? 40 : 25), id }));
    await touch('touchMove', moved);
    await page.waitForTimeout(100);
    await steps(page, 2);
    for (const [i, { id }] of before.entries()) {
      const { screen } = await body(
        page,
        all.findIndex((ball) => ball.id === id),
      );
      expect(screen?.x).toBeCloseTo(moved[i].x, -0.5);
      expect(screen?.y).toBeCloseTo(moved[i].y, -0.5);
    }
    await touch('touchEnd', moved.slice(1));
    await page.waitForFunction(() => __game.state().dragged.length === 1);
    expect((await state(page)).dragged).toEqual([before[0].id]);
    await touch('touchEnd', moved.slice(0, 1));
    await page.waitForFunction(() => __game.state().dragged.length === 0);
  });

  it('moves the view with the right button, the middle one or the space bar, and scales it', async () => {
    const page = await play('manual');
    const before = await scaleOf(page);
    const drag = async (button: 'left' | 'middle' | 'right', dx: number, dy: number) => {
      await page.mouse.move(450, 480);
      await page.mouse.down({ button });
      await page.mouse.move(450 + dx, 480 + dy, { steps: 3 });
      await page.mouse.up({ button });
    };
    // A drag that misses a ball leaves the view alone.
    await drag('left', 60, 40);
    expect(await scaleOf(page)).toEqual(before);
    await drag('right', 10, -20);
    await drag('middle', 10, 5);
    const { paused } = await state(page);
    await page.keyboard.down(' ');
    await drag('left', 10, 5);
    await page.keyboard.up(' ');
    expect((await state(page)).paused).toBe(paused);
    const moved = await scaleOf(page);
    expect(moved.x - before.x).toBeCloseTo(30, 1);
    expect(moved.y - before.y).toBeCloseTo(-10, 1);
    const { screen } = await body(page, 1);
    await page.mouse.wheel(0, -200);
    await page.waitForFunction((x) => __game.body(1).screen?.x !== x, screen?.x);
    expect((await scaleOf(page)).pixels).toBeGreaterThan(1.2 * before.pixels);
    await page.keyboard.press('f');
    const fitted = await scaleOf(page);
    expect(fitted.pixels).toBeCloseTo(before.pixels, 3);
    expect(fitted.x).toBeCloseTo(before.x, 3);
    await page.mouse.wheel(0, -200);
    await page.waitForFunction((x) => __game.body(1).screen?.x !== x, screen?.x);
    await page.keyboard.press('r');
    expect((await scaleOf(page)).pixels).toBeCloseTo(before.pixels, 3);
  });
});

describe('bad weather', () => {
  it.each(['pixi', 'three'])('survives a window without size and a lost graphics card: %s', async (renderer) => {
    const page = await play(`manual&count=30&renderer=${renderer}`);
    await steps(page, 20);
    const whole = await brightPixels(page);
    await page.addStyleTag({
      content: '.nothing { width: 0 !important; height: 0 !important; inset: auto !important }',
    });
    await page.evaluate(() => document.querySelector('.game-stage')?.classList.add('nothing'));
    await frames(page);
    await page.evaluate(() => document.querySelector('.game-stage')?.classList.remove('nothing'));
    expect(await brightPixels(page)).toBe(whole);
    const giveBack = await loseGraphicsCard(page);
    await steps(page, 1);
    await frames(page);
    await giveBack();
    expect(Math.abs((await brightPixels(page)) - whole)).toBeLessThan(0.2 * whole);
  });

  it('runs a hundred thousand balls', async () => {
    const page = await play('count=100000');
    await page.waitForFunction(() => __game.state().tick > 8);
    const { count, timing, banner } = await state(page);
    expect({ count, banner }).toEqual({ count: 100_000, banner: '' });
    expect(timing.step).toBeGreaterThan(0);
    await page.evaluate(() => __game.pause());
    expect(await brightPixels(page)).toBeGreaterThan(1000);
  });
});

describe('playing', () => {
  it('opens with 200 balls that meet, in 3D, from another launch each time', async () => {
    const page = await open('');
    const first = await state(page);
    expect(first).toMatchObject({ count: 200, renderer: 'three' });
    expect(first.contacts).toBeGreaterThanOrEqual(0);
    await page.waitForTimeout(20);
    await page.reload();
    await page.waitForFunction(() => globalThis.__game?.state().ready);
    expect((await state(page)).seed).not.toBe(first.seed);
    const chosen = await open('seed=77');
    expect((await state(chosen)).seed).toBe(77);
  });

  it.each(['pixi', 'three'])('a tap blows up what is there: %s', async (renderer) => {
    const page = await play(`manual&count=60&gravity=0&renderer=${renderer}`);
    await steps(page, 30);
    const kinetic = async () => (await state(page)).energy.kinetic;
    const before = await kinetic();
    const { screen } = await body(page, 20);
    // A drag is no tap.
    await page.mouse.move(10, 590);
    await page.mouse.down();
    await page.mouse.move(60, 560);
    await page.mouse.up();
    expect(await kinetic()).toBeCloseTo(before, 6);
    await page.mouse.click((screen?.x ?? 0) + 3, (screen?.y ?? 0) + 40);
    await steps(page, 1);
    const blown = await kinetic();
    expect(blown).toBeGreaterThan(before);
  });

  it.each(['pixi', 'three'])('a tap of a finger blows up what is there: %s', async (renderer) => {
    const touch = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
    const page = await play(`manual&count=60&gravity=0&renderer=${renderer}`, touch);
    await steps(page, 30);
    const kinetic = async () => (await state(page)).energy.kinetic;
    const before = await kinetic();
    const { screen } = await body(page, 20);
    const at = { x: (screen?.x ?? 0) + 3, y: (screen?.y ?? 0) + 20 };
    // What slides is no tap.
    const fingers = await fingersOf(page);
    await fingers('touchStart', [{ x: 8, y: 640, id: 1 }]);
    await fingers('touchMove', [{ x: 8, y: 700, id: 1 }]);
    await fingers('touchEnd');
    expect(await kinetic()).toBeCloseTo(before, 6);
    await page.touchscreen.tap(at.x, at.y);
    await steps(page, 1);
    expect(await kinetic()).toBeGreaterThan(before);
  });

  it.each(['mouse', 'touch'])('a press that rests stops time while it lasts: %s', async (means) => {
    const page = await play('count=40&renderer=pixi', { hasTouch: true });
    const fingers = await fingersOf(page);
    const tick = async () => (await state(page)).tick;
    // The upper edge of the room has no balls by then.
    await page.waitForFunction(() => __game.state().tick > 60);
    if (means === 'mouse') {
      await page.mouse.move(560, 200);
      await page.mouse.down();
    } else await fingers('touchStart', [{ x: 560, y: 200, id: 1 }]);
    await page.locator('.magnet-ring').waitFor({ state: 'visible' });
    await frames(page);
    const held = await tick();
    await page.waitForTimeout(500);
    expect(await tick()).toBe(held);
    if (means === 'mouse') await page.mouse.up();
    else await fingers('touchEnd');
    await page.waitForFunction((before) => __game.state().tick > before, held);
    expect(await page.locator('.magnet-ring').isVisible()).toBe(false);
  });

  it('a button makes the hold a magnet', async () => {
    const page = await play('manual&count=40');
    await page.getByRole('button', { name: 'Magnet' }).click();
    expect((await state(page)).values.magnet).toBe(true);
    await page.keyboard.press('g');
    expect((await state(page)).values.magnet).toBe(false);
  });

  it.each(['pixi', 'three'])(
    'a press that rests is a magnet where one wants it, until it is let go: %s',
    async (renderer) => {
      const page = await play(`manual&count=40&gravity=0&magnet=on&renderer=${renderer}`);
      const ring = page.locator('.magnet-ring');
      const inwards = async (x: number, y: number) => {
        const balls = await Promise.all(Array.from({ length: 40 }, (_, i) => body(page, i)));
        return balls.filter((ball) => ball.vx * (x - ball.x) + ball.vy * (y - ball.y) > 0).length;
      };
      await page.mouse.move(560, 320);
      await page.mouse.down();
      await ring.waitFor({ state: 'visible' });
      // The ring follows the pointer, and the view stays.
      const before = await body(page, 0);
      await page.mouse.move(600, 340, { steps: 4 });
      expect((await body(page, 0)).screen).toEqual(before.screen);
      const { x, width, y, height } = (await ring.boundingBox()) as {
        x: number;
        y: number;
        width: number;
        height: number;
      };
      expect([x + width / 2, y + height / 2]).toEqual([expect.closeTo(600, 0), expect.closeTo(340, 0)]);
      await steps(page, 20);
      // In the plane of the picture all balls of the upper left corner fly to the middle of the room by now.
      expect(await inwards(5, 2.5)).toBeGreaterThan(30);
      const { energy } = await state(page);
      expect(energy.kinetic).toBeGreaterThan(0);
      await page.mouse.up();
      expect(await ring.isVisible()).toBe(false);
      // A hold is no tap.
      await steps(page, 2);
      const free = await body(page, 3);
      await steps(page, 1);
      expect((await body(page, 3)).vx).toBe(free.vx);
    },
  );

  it('tilts where there is a sensor, and asks where that is wanted', async () => {
    const tiltTo = (page: Page, beta: number | null, gamma: number | null) =>
      page.evaluate(
        (angles) => dispatchEvent(new DeviceOrientationEvent('deviceorientation', { alpha: 0, ...angles })),
        { beta, gamma },
      );
    const page = await play('manual&seed=1&count=5&gravity=10&collisions=off');
    const button = page.locator('.tilt-button');
    await tiltTo(page, null, null);
    expect(await button.isVisible()).toBe(false);
    await tiltTo(page, 60, 0);
    expect(await button.isVisible()).toBe(true);
    const acceleration = async () => {
      await steps(page, 1);
      const before = await body(page, 0);
      await steps(page, 1);
      const { vx, vy } = await body(page, 0);
      return [(vx - before.vx) * 60, (vy - before.vy) * 60];
    };
    const switchTo = async (isOn: boolean) => {
      await button.click();
      await page.locator(`.tilt-button[aria-pressed=${isOn}]`).waitFor();
    };
    const straight = [expect.closeTo(0, 2), expect.closeTo(-10, 2)];
    expect(await acceleration()).toEqual(straight);
    await switchTo(true);
    // Half a right angle to the right: gravity in steps of 1/64.
    await tiltTo(page, 0, 30);
    expect(await acceleration()).toEqual([expect.closeTo(5, 2), expect.closeTo(0, 2)]);
    await page.keyboard.press('r');
    await frames(page);
    expect(await acceleration()).toEqual([expect.closeTo(5, 2), expect.closeTo(0, 2)]);
    await switchTo(false);
    expect(await acceleration()).toEqual(straight);
    const asks = await play('manual', {
      prepare: () => {
        Object.assign(DeviceOrientationEvent, { requestPermission: async () => 'denied' });
        // As on a device that says nothing before it is allowed to.
        addEventListener('deviceorientation', (event) => event.stopImmediatePropagation(), true);
      },
    });
    await asks.locator('.tilt-button').click();
    await asks.waitForFunction(() => __game.state().banner.includes('Allow motion'));
    expect(await asks.locator('.tilt-button').getAttribute('aria-pressed')).toBe('false');
  });

  it('V pours balls from the ceiling, and their number stays', async () => {
    const page = await play('manual&count=50');
    await steps(page, 300);
    await page.keyboard.down('v');
    await steps(page, 60);
    await page.keyboard.up('v');
    const balls = await Promise.all(Array.from({ length: 50 }, (_, i) => body(page, i)));
    expect(balls.filter(({ y, vy }) => vy < -2.9 && y > 0.5).length).toBeGreaterThan(2);
    expect((await state(page)).count).toBe(50);
  });

  it('has the gravity of planets in a list', async () => {
    const page = await play('manual');
    const list = page.locator('.game-side select', { hasText: 'Jupiter' });
    await list.selectOption('Moon');
    expect((await state(page)).values.gravity).toBe(1.62);
    await page.evaluate(() => __game.set('gravity', 24.79));
    expect(await list.inputValue()).toBe('Jupiter');
  });

  it('hears impacts once somebody has touched the page, and copies a link to the same launch', async () => {
    const page = await play('seed=5&count=30');
    await page.mouse.click(400, 300);
    const [link] = await Promise.all([
      page.waitForFunction(() => __game.state().banner),
      page.locator('.game-tools button', { hasText: 'Copy link' }).click(),
    ]);
    expect(await link.jsonValue()).toContain('link to this game');
  });
});

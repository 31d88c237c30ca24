/** Plays the game of black holes through its real page: keys, mouse, fingers, a gamepad. */
import { step } from '@principia/physics';
import type { BlackHole, LoggedInput } from '@principia/scenes';
import type { Page } from 'playwright-core';
import { PNG } from 'pngjs';
import { describe, expect, it } from 'vitest';
import { createGame, type Input } from '../../games/black-hole/sim.ts';
import { HANDS, perform, VALUES, winningMoves } from '../support/black-hole-bot.ts';
import {
  body,
  fingersOf,
  frames,
  loseGraphicsCard,
  pictureOf,
  playGame,
  ready,
  state,
  steps,
} from '../support/game-page.ts';

/** What the game tells of itself. */
interface Told {
  readonly phase: string;
  readonly lives: number;
  readonly score: number;
  readonly dodged: number;
  readonly heading: string;
  readonly push?: { readonly x: number; readonly y: number };
  readonly goalPoints: number;
  readonly isDemo: boolean;
  readonly isReplay: boolean;
  readonly hash: string;
  readonly log: LoggedInput<Input>[];
  readonly holes: BlackHole['holes'];
}

const { open: play } = playGame('black-hole', { viewport: { width: 640, height: 420 }, hasTouch: true });

const told = async (page: Page) => (await state(page)).game as unknown as Told;
const picture = (page: Page) => pictureOf(page, '.bh-hud');

/** Where the ship is on the page. */
async function shipPlace(page: Page) {
  const { screen } = await body(page, 0);
  return screen as { x: number; y: number };
}

describe('playing', () => {
  const plan = winningMoves(4);

  it.each(Object.entries(HANDS))('%s win a level, and the log plays the same game in Node', async (_, take) => {
    const page = await play('manual&seed=4');
    expect(await told(page)).toMatchObject({ phase: 'ready', lives: 3, score: 0 });
    await perform(page, await take(page), plan);
    // The next holes appear after a moment's breath.
    await steps(page, 120);
    const won = await told(page);
    expect(won).toMatchObject({ dodged: 1, score: 1, goalPoints: 2, lives: 3 });
    expect(won.holes).toHaveLength(2);
    await frames(page);
    expect(await page.locator('.bh-score').textContent()).toBe('1 hole dodged');
    const again = createGame({ values: VALUES, seed: 4, log: won.log });
    for (let i = (await state(page)).tick; i > 0; i--) step(again.world, again.dt);
    expect(again.hash()).toBe(won.hash);
  });

  it.each(Object.entries(HANDS))('%s that launch and let go lose three ships, and play again', async (_, take) => {
    const page = await play('manual&seed=2');
    const hand = await take(page);
    for (let i = 0; i < 40 && (await told(page)).phase !== 'over'; i++) {
      await hand.push('up');
      await steps(page, 1);
      await hand.push(undefined);
      await steps(page, 600);
    }
    expect(await told(page)).toMatchObject({ phase: 'over', lives: 0 });
    const card = page.locator('.game-outcome');
    await card.waitFor({ state: 'visible' });
    expect(await card.textContent()).toContain('Game over');
    await card.locator('button', { hasText: 'Play again' }).click();
    expect(await told(page)).toMatchObject({ phase: 'ready', lives: 3, score: 0 });
    expect((await state(page)).seed).toBe(3);
    await frames(page);
    expect(await card.isVisible()).toBe(false);
  });

  it('a game can be watched again, to the same end, and does not count twice', async () => {
    const page = await play('manual&seed=2');
    await page.keyboard.press('u');
    for (let i = 0; i < 40 && (await told(page)).phase !== 'over'; i++) {
      await page.keyboard.press(i % 2 === 0 ? 'ArrowUp' : 'ArrowLeft');
      await steps(page, 500);
    }
    const { tick } = await state(page);
    const end = await told(page);
    expect(end.phase).toBe('over');
    await page.locator('.game-outcome button', { hasText: 'Watch replay' }).click();
    expect(await state(page)).toMatchObject({ tick: 0, rewound: true });
    await steps(page, tick);
    expect((await told(page)).hash).toBe(end.hash);
    await frames(page);
    expect(await page.locator('.game-outcome').textContent()).toContain('Not ranked');
    // By key, from the beginning again; and whoever pushes an arrow plays on.
    await page.keyboard.press('z');
    await steps(page, 1);
    expect(await told(page)).toMatchObject({ isReplay: true });
    await frames(page);
    expect(await page.locator('.bh-call').textContent()).toContain('Replay');
    await page.keyboard.down('ArrowDown');
    await steps(page, 1);
    expect(await told(page)).toMatchObject({ isReplay: false, heading: 'down' });
  });

  it('goes back over a fall: the life is there again, and the game does not count', async () => {
    const page = await play('manual&seed=2');
    await page.keyboard.press('ArrowUp');
    for (let i = 0; i < 40 && (await told(page)).lives === 3; i++) await steps(page, 120);
    await steps(page, 120);
    const { holes, lives } = await told(page);
    expect(lives).toBe(2);
    await page.keyboard.down('b');
    await page.waitForFunction(() => __game.state().game.lives === 3);
    await page.keyboard.up('b');
    const back = await told(page);
    expect(back.holes).not.toEqual(holes);
    expect((await state(page)).rewound).toBe(true);
  });

  it('any key let go cuts the thrust, the last one pressed decides', async () => {
    const page = await play('manual&seed=4');
    const heading = async () => {
      await steps(page, 1);
      return (await told(page)).heading;
    };
    await page.keyboard.down('ArrowUp');
    expect(await heading()).toBe('up');
    await page.keyboard.down('ArrowRight');
    expect(await heading()).toBe('right');
    await page.keyboard.up('ArrowUp');
    expect(await heading()).toBe('');
    await page.keyboard.down('ArrowLeft');
    expect(await heading()).toBe('left');
  });

  it('pauses, and starts again at the same holes', async () => {
    const page = await play('seed=4');
    const { holes } = await told(page);
    await page.keyboard.down('ArrowUp');
    await page.waitForFunction(() => __game.state().tick > 5);
    await page.keyboard.press('Space');
    const paused = await state(page);
    await page.waitForTimeout(200);
    expect((await state(page)).hash).toBe(paused.hash);
    await page.keyboard.press('r');
    expect(await told(page)).toMatchObject({ phase: 'ready', holes });
  });
});

describe('the ghost', () => {
  const isPale = (r: number, g: number, b: number) => r > 120 && g > 120 && b > 130 && Math.abs(r - b) < 60;

  /** Without sparks, so that two pictures of the same moment differ by the ghost alone. */
  const CALM = { reducedMotion: 'reduce' } as const;

  /** Pale pixels that Ghost, key C, adds to the picture, half a second after a launch or into a replay. */
  async function palePixels(page: Page, doesLaunch = true): Promise<number> {
    if (doesLaunch) await page.keyboard.down('ArrowLeft');
    await steps(page, 60);
    // The ship has turned to its heading by then, to a part in ten thousand.
    await page.waitForTimeout(600);
    const shown = await picture(page);
    await page.keyboard.press('c');
    expect((await state(page)).values.ghost).toBe(false);
    const hidden = await picture(page);
    if (doesLaunch) await page.keyboard.up('ArrowLeft');
    return countOf(shown, isPale) - countOf(hidden, isPale);
  }

  async function win(page: Page): Promise<void> {
    await perform(page, await HANDS.keys(page), winningMoves(4));
    await frames(page);
    expect(await told(page)).toMatchObject({ dodged: 1 });
  }

  it('flies the best flight past the same holes again, also after a reload, but not in a replay', async () => {
    const page = await play('manual&seed=4', CALM);
    await win(page);
    // The first flight has nothing to be compared with.
    expect(await page.locator('.bh-toast').textContent()).toBe('Dodged! +1');
    await page.keyboard.press('z');
    await frames(page);
    expect(await palePixels(page, false)).toBeLessThan(10);
    await page.reload();
    await ready(page);
    expect(await palePixels(page)).toBeGreaterThan(10);
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    await win(page);
    expect(await page.locator('.bh-toast').textContent()).toContain('as fast as your ghost');
  });

  it.each(['full', 'absent'])('lasts as long as the page where the storage is %s', async (kind) => {
    const prepare = {
      full: () => {
        Storage.prototype.setItem = () => {
          throw new DOMException('The quota has been exceeded.', 'QuotaExceededError');
        };
      },
      absent: () =>
        Object.defineProperty(globalThis, 'localStorage', {
          get() {
            throw new DOMException('Access is denied.', 'SecurityError');
          },
        }),
    }[kind] as () => void;
    const page = await play('manual&seed=4', { prepare, ...CALM });
    await win(page);
    await page.keyboard.press('r');
    expect(await palePixels(page)).toBeGreaterThan(10);
  });
});

describe('other hands', () => {
  it('the ship is pushed towards the mouse, the harder the farther it is; the button draws other holes', async () => {
    const page = await play('manual&seed=4');
    const { x, y } = await shipPlace(page);
    await page.mouse.move(x - 80, y - 20);
    await page.mouse.down();
    await steps(page, 1);
    const { push } = await told(page);
    // Up and to the left, as the mouse is.
    expect(push?.x).toBeCloseTo(-80 / Math.hypot(80, 20), 1);
    expect(push?.y).toBeCloseTo(20 / Math.hypot(80, 20), 1);
    await page.mouse.move(x, y + 34);
    await steps(page, 1);
    expect((await told(page)).push).toEqual({ x: 0, y: -0.5 });
    await page.mouse.move(x + 5, y - 90);
    await steps(page, 1);
    expect((await told(page)).heading).toBe('up');
    await page.mouse.up();
    await steps(page, 1);
    const before = await told(page);
    expect(before.heading).toBe('');
    await page.mouse.dblclick(300, 200);
    await steps(page, 1);
    // Quick taps steer; they cost no bonus.
    expect((await told(page)).holes).toEqual(before.holes);
    await page.keyboard.press('n');
    await steps(page, 1);
    const drawn = await told(page);
    await frames(page);
    await page.locator('.bh-redraw').click();
    await steps(page, 1);
    const after = await told(page);
    expect(after.goalPoints).toBe(1);
    expect(drawn.holes).not.toEqual(before.holes);
    expect(after.holes).not.toEqual(drawn.holes);
  });

  it('a finger steers', async () => {
    const page = await play('manual&seed=4');
    const touch = await fingersOf(page);
    const { x, y } = await shipPlace(page);
    await touch('touchStart', [{ x: x + 70, y: y - 10 }]);
    await steps(page, 1);
    expect((await told(page)).heading).toBe('right');
    await touch('touchEnd');
    await steps(page, 1);
    expect((await told(page)).heading).toBe('');
  });

  it('the stick of the touch pad and that of a gamepad steer', async () => {
    const page = await play('manual&seed=4');
    await page.addStyleTag({ content: '.game-pad { display: grid !important }' });
    const stick = (await page.locator('.game-stick').boundingBox()) as { x: number; y: number; width: number };
    await page.mouse.move(stick.x + 0.1 * stick.width, stick.y + 0.5 * stick.width);
    await page.mouse.down();
    await steps(page, 1);
    expect((await told(page)).heading).toBe('left');
    await page.mouse.up();
    await page.evaluate(() => {
      const buttons = Array.from({ length: 17 }, () => ({ pressed: false, touched: false, value: 0 }));
      const gamepad = { connected: true, index: 0, axes: [0, -1, 0, 0], buttons };
      Object.assign(globalThis, { gamepad });
      navigator.getGamepads = () => [gamepad as unknown as Gamepad];
      dispatchEvent(new Event('gamepadconnected'));
    });
    await frames(page);
    await steps(page, 1);
    expect((await told(page)).heading).toBe('up');
    await page.evaluate(() => {
      (globalThis as unknown as { gamepad: { axes: number[] } }).gamepad.axes[1] = 0;
    });
    await frames(page);
    await steps(page, 1);
    expect((await told(page)).heading).toBe('');
  });

  it('a phone lying on its side has the touch pad to itself until the settings are asked for', async () => {
    const page = await play('manual&seed=4', { viewport: { width: 780, height: 390 }, isMobile: true });
    const stick = page.locator('.game-stick');
    const { x, y, height } = (await stick.boundingBox()) as { x: number; y: number; height: number };
    await page.mouse.move(x + 10, y + height / 2);
    await page.mouse.down();
    await steps(page, 1);
    expect((await told(page)).heading).toBe('left');
    await page.mouse.up();
    expect(await page.locator('.game-side').isVisible()).toBe(false);
    await page.keyboard.press('p');
    expect(await page.locator('.game-side').isVisible()).toBe(true);
    expect(await stick.isVisible()).toBe(false);
  });

  it('a phone lying on its side shows the whole card of the result with a full list of scores, and all of the help', async () => {
    const size = { width: 844, height: 390 };
    const page = await play('manual&seed=2', {
      viewport: size,
      prepare: () => {
        const scores = [1200, 900, 800, 700, 600].map((score) => ({ score, day: '2001-12-31' }));
        localStorage.setItem('principia scores: Black hole', JSON.stringify(scores));
      },
    });
    await page.keyboard.press('h');
    const [foot, lines] = [page.locator('.game-help footer'), page.locator('.game-help dl')];
    await lines.evaluate((list) => list.lastElementChild?.scrollIntoView({ block: 'end' }));
    await lines.evaluate((list) => list.parentElement?.scrollTo(0, 1e4));
    const [below, above] = [await foot.boundingBox(), await lines.boundingBox()];
    expect((above?.y ?? 0) + (above?.height ?? 1e4)).toBeLessThanOrEqual(below?.y ?? 0);
    await page.keyboard.press('h');
    for (let i = 0; i < 40 && (await told(page)).phase !== 'over'; i++) {
      await page.keyboard.down('ArrowUp');
      await steps(page, 1);
      await page.keyboard.up('ArrowUp');
      await steps(page, 600);
    }
    const card = page.locator('.game-outcome');
    await card.waitFor();
    expect(await card.locator('li').count()).toBe(5);
    const { x, y, width, height } = (await card.boundingBox()) as {
      x: number;
      y: number;
      width: number;
      height: number;
    };
    expect(Math.min(x, y)).toBeGreaterThanOrEqual(8);
    expect(x + width).toBeLessThanOrEqual(size.width - 8);
    expect(y + height).toBeLessThanOrEqual(size.height - 8);
    expect(await card.evaluate((each) => each.scrollHeight - each.clientHeight)).toBe(0);
  });

  it('plays itself when nobody does, until somebody does', async () => {
    const page = await play('manual&seed=4');
    await steps(page, 120 * 14);
    expect(await told(page)).toMatchObject({ isDemo: true, phase: 'flying' });
    await frames(page);
    expect(await page.locator('.bh-call').textContent()).toContain('Demo');
    await page.keyboard.down('ArrowUp');
    await steps(page, 2);
    expect(await told(page)).toMatchObject({ isDemo: false, phase: 'flying', score: 0, heading: 'up' });
  });
});

describe('the picture', () => {
  it('changes as the ship flies, and with bent light', async () => {
    const page = await play('manual&seed=4');
    const waiting = await picture(page);
    await page.keyboard.down('ArrowUp');
    await steps(page, 120);
    const flying = await picture(page);
    expect(flying.equals(waiting)).toBe(false);
    await page.keyboard.press('l');
    expect((await state(page)).values.lens).toBe(false);
    expect((await picture(page)).equals(flying)).toBe(false);
  });

  it('has other colours for those who see red and green alike, and says which', async () => {
    const page = await play('manual&seed=4');
    const usual = await picture(page);
    expect(await page.locator('.bh-call').textContent()).toContain('green line');
    await page.keyboard.press('y');
    const safe = await picture(page);
    expect(await page.locator('.bh-call').textContent()).toContain('blue line');
    expect(countOf(usual, isGreen)).toBeGreaterThan(200);
    expect(countOf(safe, isGreen)).toBeLessThan(20);
    // What happened before the colours changed is not news again.
    await steps(page, 1);
    await frames(page);
    expect(await page.locator('.bh-toast').textContent()).toBe('');
  });

  it('Q gives another game, in which the holes pull after Paczyński and Wiita', async () => {
    const page = await play('manual&seed=4');
    const fall = async () => {
      await page.keyboard.down('ArrowUp');
      await steps(page, 240);
      await page.keyboard.up('ArrowUp');
      const { x } = await body(page, 0);
      return 400 - x;
    };
    const newton = await fall();
    const [{ x, y, radius }] = (await told(page)).holes;
    const distance = Math.hypot(x - 400, y - 50);
    await page.keyboard.press('q');
    await page.waitForFunction(() => __game.state().values.steep === true && __game.state().tick === 0);
    const steep = await fall();
    // The hole lies to the left. Its pull is greater by (d/(d - r))², and more so the nearer the ship gets: 15 m of it.
    const share = (d: number) => (d / (d - radius)) ** 2;
    expect(steep / newton).toBeGreaterThan(0.99 * share(distance));
    expect(steep / newton).toBeLessThan(1.01 * share(distance - 20));
  });

  it('survives the loss of the graphics card', async () => {
    const page = await play('manual&seed=4');
    const whole = await picture(page);
    const giveBack = await loseGraphicsCard(page);
    await steps(page, 1);
    await frames(page);
    await giveBack();
    const back = await picture(page);
    // Compressed size tells a sky of stars from a black picture.
    expect(back.length).toBeGreaterThan(0.8 * whole.length);
  });
});

/** Pixels of a picture that are as `is` says, of red, green and blue from 0 to 255. */
function countOf(png: Buffer, is: (r: number, g: number, b: number) => boolean): number {
  const { data } = PNG.sync.read(png);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) if (is(data[i], data[i + 1], data[i + 2])) count++;
  return count;
}

const isGreen = (r: number, g: number, b: number) => g > 90 && g > 1.3 * r && g > 1.25 * b;

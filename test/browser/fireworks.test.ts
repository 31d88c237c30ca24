/** Plays the fireworks through their real page: mouse, fingers, keys, and the address. */
import { step } from '@principia/physics';
import type { LoggedInput } from '@principia/scenes';
import type { Page } from 'playwright-core';
import { PNG } from 'pngjs';
import { describe, expect, it } from 'vitest';
import { DEMO_SHOW } from '../../games/fireworks/demo-show.ts';
import { GALLERY } from '../../games/fireworks/gallery.ts';
import { quantize } from '../../games/fireworks/show.ts';
import { type Cue, createGame, type Input } from '../../games/fireworks/sim.ts';
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
import { focus } from '../support/hands.ts';

const VALUES = { wind: 0, barrage: false, sparks: 100_000 };

/** What the game tells of itself. */
interface Told {
  readonly hash: string;
  readonly log: LoggedInput<Input>[];
  readonly alive: number;
  readonly flying: number;
  readonly fired: number;
  readonly isShowing: boolean;
  readonly isDemo: boolean;
  readonly held: readonly number[];
  readonly crosshair: { readonly x: number; readonly y: number };
  readonly cues: readonly Cue[];
  readonly sound: { readonly state: string; readonly heard: number; readonly lastDelay: number };
}

const { open: play } = playGame('fireworks', { viewport: { width: 900, height: 560 }, hasTouch: true });

const told = async (page: Page) => (await state(page)).game as unknown as Told;
const kinds = ({ log }: Told) => log.flatMap(({ input }) => (input.do === 'fire' ? [input.kind] : []));

/** Steps with a picture after each few, so that light can gather. */
const watch = (page: Page, count: number) =>
  page.evaluate(async (n) => {
    for (let i = 0; i < n; i += 3) {
      __game.step(3);
      await new Promise((done) => requestAnimationFrame(done));
    }
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  }, count);

/** Pixels of the sky that are as bright as only sparks are, and how many of them are coloured rather than white. */
async function brightness(page: Page) {
  const { data, width, height } = PNG.sync.read(await pictureOf(page, '.fw-extras'));
  const found = { bright: 0, colored: 0 };
  for (let i = 0; i < width * Math.floor(0.7 * height); i++) {
    const [r, g, b] = data.subarray(4 * i, 4 * i + 3);
    const most = Math.max(r, g, b);
    if (most < 150) continue;
    found.bright++;
    if (most - Math.min(r, g, b) > 70) found.colored++;
  }
  return found;
}

describe.each(['pixi', 'three'])('in %s', (renderer) => {
  it('a click sends up a shell that fills the sky with coloured light, and the log plays it again in Node', async () => {
    const page = await play(`manual&seed=5&renderer=${renderer}`);
    // The demo, which nobody has interrupted yet.
    await steps(page, 6);
    const dark = await brightness(page);
    await page.mouse.click(300, 150);
    await steps(page, 150);
    expect((await told(page)).fired).toBe(1);
    await watch(page, 60);
    const lit = await brightness(page);
    expect(dark.bright).toBeLessThan(60);
    expect(lit.bright).toBeGreaterThan(400);
    expect(lit.colored).toBeGreaterThan(0.3 * lit.bright);
    const { hash, log } = await told(page);
    const dimensions = renderer === 'pixi' ? 2 : 3;
    const again = createGame({ values: VALUES, seed: 5, dimensions, opening: DEMO_SHOW, isDemo: true, log });
    for (let i = (await state(page)).tick; i > 0; i--) step(again.world, again.dt);
    expect(again.hash()).toBe(hash);
  });
});

describe('hands', () => {
  it('of keys aim and fire, and choose the shell', async () => {
    const page = await play('manual');
    await page.keyboard.press('k');
    await page.keyboard.press('k');
    await page.keyboard.down('ArrowRight');
    await steps(page, 60);
    await page.keyboard.up('ArrowRight');
    await page.keyboard.down('Enter');
    await steps(page, 90);
    await page.keyboard.up('Enter');
    await steps(page, 1);
    const { crosshair, fired, log } = await told(page);
    expect(crosshair.x).toBeCloseTo(30, 6);
    expect(fired).toBe(1);
    expect(log.at(-1)?.input).toMatchObject({ do: 'fire', x: crosshair.x, y: crosshair.y, kind: 1 });
    // The arrow steers here: it is not the key for one step.
    expect((await state(page)).tick).toBe(151);
  });

  it('that press a button of the page fire nothing', async () => {
    const page = await play('manual');
    await focus(page, page.locator('.fw-extra', { hasText: 'Write' }));
    await page.keyboard.press('Enter');
    await steps(page, 2);
    expect(await told(page)).toMatchObject({ isDemo: true, fired: 0, held: [] });
    expect(await page.locator('.fw-text').isVisible()).toBe(true);
  });

  it('of a gamepad aim with the stick, hold and fire with the first button', async () => {
    const page = await play('manual');
    await page.evaluate(() => {
      const buttons = Array.from({ length: 17 }, () => ({ pressed: false, touched: false, value: 0 }));
      const gamepad = { connected: true, index: 0, axes: [-1, 0, 0, 0], buttons };
      Object.assign(globalThis, { gamepad });
      navigator.getGamepads = () => [gamepad as unknown as Gamepad];
      dispatchEvent(new Event('gamepadconnected'));
    });
    const push = (axis: number, pressed: boolean) =>
      page.evaluate(
        ([x, on]) => {
          const { gamepad } = globalThis as unknown as { gamepad: { axes: number[]; buttons: { pressed: boolean }[] } };
          gamepad.axes[0] = x as number;
          gamepad.buttons[0].pressed = on as boolean;
        },
        [axis, pressed],
      );
    await frames(page);
    await steps(page, 30);
    expect((await told(page)).crosshair.x).toBeCloseTo(-15, 6);
    await push(0, true);
    await frames(page);
    await steps(page, 60);
    expect((await told(page)).held).toHaveLength(1);
    await push(0, false);
    await frames(page);
    await steps(page, 1);
    const { crosshair, fired, log } = await told(page);
    expect(crosshair.x).toBeCloseTo(-15, 6);
    expect(fired).toBe(1);
    expect(log.at(-1)?.input).toMatchObject({ do: 'fire', x: crosshair.x, y: crosshair.y });
  });

  it('of two fingers hold two shells at once; one that is taken away is forgotten', async () => {
    const page = await play('manual');
    const touch = await fingersOf(page);
    const [left, right] = [
      { x: 200, y: 150, id: 1 },
      { x: 420, y: 200, id: 2 },
    ];
    await touch('touchStart', [left, right]);
    await steps(page, 30);
    expect((await told(page)).held).toHaveLength(2);
    expect(await page.locator('.fw-ring').count()).toBe(2);
    await touch('touchEnd', [left]);
    await touch('touchEnd');
    await steps(page, 1);
    expect(await told(page)).toMatchObject({ fired: 2, held: [], isDemo: false });
    await touch('touchStart', [left]);
    await touch('touchCancel');
    await steps(page, 1);
    expect(await told(page)).toMatchObject({ fired: 2, held: [] });
    expect(await page.locator('.fw-ring').count()).toBe(0);
  });

  it('that drag turn the view in 3D and send nothing up', async () => {
    const page = await play('manual&renderer=three');
    const before = await page.evaluate(() => __game.body(0).screen);
    await page.mouse.move(200, 200);
    await page.mouse.down();
    await page.mouse.move(330, 210, { steps: 5 });
    await page.mouse.up();
    await steps(page, 1);
    await frames(page);
    expect(await told(page)).toMatchObject({ fired: 0, held: [] });
    expect(await page.evaluate(() => __game.body(0).screen)).not.toEqual(before);
  });
});

describe('a show', () => {
  it('is composed by clicks, played, and comes back from its link', async () => {
    const page = await play('manual');
    await page.locator('.fw-tray button', { hasText: 'Show' }).click();
    await page.locator('.fw-tray [aria-label^=palm]').click();
    await page.locator('.fw-tray [aria-label^=green]').click();
    for (const [x, y] of [
      [150, 120],
      [300, 130],
      [450, 140],
    ])
      await page.mouse.click(x, y);
    await steps(page, 1);
    await frames(page);
    const composed = await told(page);
    expect(composed.cues.map(({ tick, kind, color }) => [tick, kind, color])).toEqual([
      [0, 4, 3],
      [36, 4, 3],
      [72, 4, 3],
    ]);
    expect(kinds(composed)).toEqual([4, 4, 4]);
    // The last mark goes to the end of the line, 15 s; a tenth of a second is a step of the timeline.
    const line = await page.locator('.fw-line').boundingBox();
    const mark = await page.locator('.fw-mark').nth(2).boundingBox();
    if (line === null || mark === null) throw new Error('There is no timeline.');
    await page.mouse.move(mark.x + 9, mark.y + 9);
    await page.mouse.down();
    await page.mouse.move(line.x + line.width / 3, line.y + 17, { steps: 4 });
    await page.mouse.up();
    await frames(page);
    expect((await told(page)).cues[2].tick / 60).toBeCloseTo(5, 0);
    await page.keyboard.press('l');
    await steps(page, 350);
    expect(await told(page)).toMatchObject({ isShowing: false, fired: 3 });
    await page.locator('[data-do=share]').click();
    await page.waitForFunction(() => __game.state().banner.includes('link to your show'));
    const link = page.url();
    expect(link).toMatch(/#show=3\.[\w-]+$/);
    const { cues } = await told(page);
    const guest = await page.context().newPage();
    await guest.goto(link);
    await ready(guest);
    await steps(guest, 1);
    expect(await told(guest)).toMatchObject({ cues, isShowing: true, isDemo: false, flying: 1 });
  });

  it('of the list is chosen by touch or keys, runs, and can be changed and shared', async () => {
    const page = await play('manual', { viewport: { width: 390, height: 844 } });
    const button = page.locator('.fw-extra', { hasText: 'Shows' });
    const list = page.locator('.fw-gallery');
    await button.tap();
    const heights = await list.locator('button').evaluateAll((all) => all.map((each) => each.clientHeight));
    expect(heights).toHaveLength(GALLERY.length);
    expect(Math.min(...heights)).toBeGreaterThanOrEqual(44);
    const [box, desk] = await Promise.all([list.boundingBox(), page.locator('.fw-desk').boundingBox()]);
    if (box === null || desk === null) throw new Error('There is no list.');
    expect(box.x + box.width).toBeLessThanOrEqual(390);
    expect(box.y + box.height).toBeLessThanOrEqual(desk.y);
    await page.keyboard.press('Escape');
    expect(await list.isVisible()).toBe(false);
    // The button has the focus again. The keys that aim and fire elsewhere choose here.
    await page.keyboard.press('Enter');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    expect(await list.isVisible()).toBe(false);
    await steps(page, 60);
    const [first, second] = GALLERY.map(({ cues }) => cues.map(quantize));
    expect(await told(page)).toMatchObject({ cues: second, isShowing: true, isDemo: false, fired: 0, held: [] });
    await button.tap();
    await list.locator('button').first().tap();
    await steps(page, 60);
    expect(await told(page)).toMatchObject({ cues: first, isShowing: true, fired: 0 });
    await page.keyboard.press('t');
    await frames(page);
    expect(await page.locator('.fw-mark').count()).toBe(first.length);
    await page.locator('.fw-mark').last().tap();
    await page.keyboard.press('Delete');
    expect((await told(page)).cues).toEqual(first.slice(0, -1));
    await page.locator('[data-do=share]').tap();
    await page.waitForFunction(() => location.hash.startsWith('#show=3.'));
  });

  it('takes back, takes out and clears', async () => {
    const page = await play('manual');
    await page.keyboard.press('t');
    for (const x of [150, 300, 450]) await page.mouse.click(x, 120);
    await page.keyboard.press('Backspace');
    expect((await told(page)).cues).toHaveLength(2);
    await frames(page);
    await page.locator('.fw-mark').first().click();
    await page.keyboard.press('Delete');
    expect((await told(page)).cues.map(({ tick }) => tick)).toEqual([36]);
    await frames(page);
    await page.locator('[data-do=clear]').click();
    expect((await told(page)).cues).toEqual([]);
  });

  it.each(['1.AAAA', '7.abc', '%00', '1.!!', ''])(
    'that is malformed, #show=%s, gets a sentence, and the game plays',
    async (text) => {
      const page = await play(`manual#show=${text}`);
      await page.waitForFunction(() => __game.state().banner !== '');
      expect((await state(page)).banner).toMatch(/^The show in the address .*The demo show plays instead\.$/);
      await steps(page, 2);
      expect(await told(page)).toMatchObject({ isDemo: true, isShowing: true, flying: 3 });
    },
  );
});

describe('words and music', () => {
  it('a text is launched by its button or a press in the sky, and the log writes it again in Node', async () => {
    const page = await play('manual&seed=5');
    await page.locator('.fw-extra', { hasText: 'Write' }).click();
    await page.keyboard.type('Ada k');
    await page.keyboard.press('Enter');
    await steps(page, 1);
    await page
      .locator('canvas')
      .first()
      .click({ position: { x: 300, y: 250 } });
    await steps(page, 400);
    const told = (await state(page)).game as { hash: string; fired: number; log: LoggedInput<Input>[]; kind: number };
    expect(told.fired).toBe(2);
    const written = told.log.flatMap(({ input }) => (input.do === 'write' ? [input] : []));
    expect(written).toHaveLength(2);
    expect(written[0].points.length / 3).toBeGreaterThan(60);
    expect(written[1].x).toBeLessThan(written[0].x);
    const { values } = await state(page);
    const again = createGame({
      values: values as unknown as Parameters<typeof createGame>[0]['values'],
      seed: 5,
      dimensions: 2,
      opening: DEMO_SHOW,
      isDemo: true,
      log: told.log,
    });
    for (let i = (await state(page)).tick; i > 0; i--) step(again.world, again.dt);
    expect(again.hash()).toBe(told.hash);
    // Without letters there is nothing to write.
    await page.locator('.fw-text input').fill('   ');
    await page.locator('.fw-text button').click();
    await page.waitForFunction(() => __game.state().banner.includes('Write a name'));
  });

  it('shells burst on the beats of a file, whose times are in the log; what is no music is said', async () => {
    const page = await play('manual&seed=5');
    const input = page.locator('.fw-extras input[type=file]');
    await input.setInputFiles({ name: 'notes.mp3', mimeType: 'audio/mpeg', buffer: Buffer.from('no music') });
    await page.waitForFunction(() => __game.state().banner.includes('“notes.mp3” is not music'));
    await input.setInputFiles({ name: 'drum.wav', mimeType: 'audio/wav', buffer: drumFile(8) });
    await page.locator('.fw-extra', { hasText: 'Stop music' }).waitFor();
    await steps(page, 1);
    const { game } = await state(page);
    const [played] = (game as { log: LoggedInput<Input>[] }).log.flatMap(({ input }) =>
      input.do === 'play' ? [input.cues] : [],
    );
    // Two strokes a second, without those of the first seconds, in which no shell could have risen.
    expect(played.length).toBeGreaterThanOrEqual(9);
    expect(played.length).toBeLessThanOrEqual(15);
    await steps(page, 300);
    expect((await state(page)).game).toMatchObject({ isShowing: true });
    await page.locator('.fw-extra', { hasText: 'Stop music' }).click();
    await steps(page, 1);
    expect((await state(page)).game).toMatchObject({ isShowing: false });
  });
});

/** A WAV file of one channel with a stroke of a drum every half second. */
function drumFile(seconds: number): Buffer {
  const rate = 8000;
  const file = Buffer.alloc(44 + 2 * rate * seconds);
  file.write('RIFF', 0);
  file.writeUInt32LE(file.length - 8, 4);
  file.write('WAVEfmt ', 8);
  for (const [at, value] of [
    [16, 16],
    [24, rate],
    [28, 2 * rate],
    [40, file.length - 44],
  ])
    file.writeUInt32LE(value, at);
  for (const [at, value] of [
    [20, 1],
    [22, 1],
    [32, 2],
    [34, 16],
  ])
    file.writeUInt16LE(value, at);
  file.write('data', 36);
  for (let i = 0; i < rate * seconds; i++) {
    const t = (i / rate) % 0.5;
    file.writeInt16LE(Math.round(20_000 * Math.exp(-t / 0.04) * Math.sin(600 * t)), 44 + 2 * i);
  }
  return file;
}

describe('sound', () => {
  it('waits for a gesture, and is heard as late as sound takes', async () => {
    const page = await play('manual');
    await steps(page, 10);
    await frames(page);
    expect((await told(page)).sound).toMatchObject({ state: 'waiting', heard: 0 });
    await page.mouse.click(400, 100);
    await steps(page, 1);
    await frames(page);
    const { sound } = await told(page);
    expect(sound.state).toBe('on');
    expect(sound.heard).toBeGreaterThan(0);
    // From 140 m away, and at most 48 m to the side.
    expect(sound.lastDelay).toBeGreaterThanOrEqual(140 / 343);
    expect(sound.lastDelay).toBeLessThan(150 / 343);
    await page.keyboard.press('m');
    await page.mouse.click(420, 100);
    await steps(page, 1);
    await frames(page);
    expect((await told(page)).sound.heard).toBe(sound.heard);
  });

  it.each(['missing', 'blocked'])('that is %s is said once, and the game plays on', async (how) => {
    const page = await play('manual', { prepare: how === 'missing' ? hideAudio : blockAudio });
    await page.mouse.click(400, 100);
    await page.waitForFunction(() => __game.state().banner.includes('No sound'));
    await page.mouse.click(300, 150);
    await steps(page, 1);
    expect(await told(page)).toMatchObject({ fired: 2, sound: { state: 'blocked' } });
  });
});

function hideAudio(): void {
  Reflect.deleteProperty(globalThis, 'AudioContext');
}

function blockAudio(): void {
  globalThis.AudioContext = class {
    constructor() {
      throw new Error('blocked');
    }
  } as unknown as typeof AudioContext;
}

describe('a clip', () => {
  it('of eight seconds is a video of the sky with its bangs, from a button beside the picture', async () => {
    const page = await play('renderer=pixi&seed=2', {
      acceptDownloads: true,
      prepare: () => Object.assign(navigator, { canShare: () => false }),
    });
    const clip = page.locator('.fw-extra[data-clip]');
    const [download] = await Promise.all([page.waitForEvent('download', { timeout: 60_000 }), clip.click()]);
    expect(download.suggestedFilename()).toMatch(/^fireworks-[\d.]+s\.(mp4|webm)$/);
    expect((await state(page)).banner).toContain(download.suggestedFilename());
    const pieces: Buffer[] = [];
    for await (const piece of await download.createReadStream()) pieces.push(piece as Buffer);
    const { seconds, loudest } = await page.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const sound = await new AudioContext().decodeAudioData(bytes.buffer);
      return {
        seconds: sound.duration,
        loudest: sound.getChannelData(0).reduce((most, value) => Math.max(most, value), 0),
      };
    }, Buffer.concat(pieces).toString('base64'));
    // A busy machine without a graphics card makes few frames a second.
    expect(seconds).toBeGreaterThan(7);
    expect(seconds).toBeLessThan(10);
    // The demo show plays from the start, and its bursts are heard within two seconds.
    expect(loudest).toBeGreaterThan(0.02);
  });
});

describe('the picture', () => {
  it('keeps a barrage of sparks alive, and stays a picture', async () => {
    const page = await play('manual&sparks=4000');
    await page.locator('.fw-tray [aria-label^=Barrage]').click();
    await page.waitForFunction(() => __game.state().values.barrage === true && __game.state().tick === 0);
    await steps(page, 2);
    await watch(page, 40);
    expect((await told(page)).alive).toBeGreaterThan(3500);
    await page.waitForFunction(() => / sparks alight$/.test(document.querySelector('.fw-hint')?.textContent ?? ''));
    const { bright, colored } = await brightness(page);
    expect(bright).toBeGreaterThan(2000);
    expect(colored).toBeGreaterThan(0.2 * bright);
  });

  it('keeps the desk in its window: one line at 960 pixels beside the panel, two or three of 44 pixels on a phone', async () => {
    const wide = await play('manual', { viewport: { width: 960, height: 600 }, hasTouch: false });
    expect(await wide.locator('.game-side').isVisible()).toBe(true);
    expect((await wide.locator('.fw-tray').boundingBox())?.height).toBeLessThan(55);
    const page = await play('manual', { viewport: { width: 390, height: 800 } });
    const tray = page.locator('.fw-tray');
    await page.keyboard.press('t');
    // A phone held sideways has two lines of 44 pixels, and nothing that scrolls.
    for (const [width, height, most] of [
      [390, 800, 150],
      [360, 800, 150],
      [844, 390, 92],
      [568, 320, 92],
    ]) {
      await page.setViewportSize({ width, height });
      await page.waitForTimeout(400);
      expect((await tray.boundingBox())?.height).toBeLessThan(most);
      const boxes = await page.locator('.fw-tray button').evaluateAll((buttons) =>
        buttons.map((button) => {
          const { left, right, width, height } = button.getBoundingClientRect();
          return { left, right, size: Math.min(width, height) };
        }),
      );
      for (const { left, right, size } of boxes) {
        expect(left).toBeGreaterThanOrEqual(0);
        expect(right).toBeLessThanOrEqual(width);
        expect(size).toBeGreaterThanOrEqual(44);
      }
    }
  });

  it('a shell bursts where a phone held upright is tapped, however high', async () => {
    const page = await play('manual&seed=3', { viewport: { width: 390, height: 844 }, isMobile: true });
    await page.touchscreen.tap(195, 120);
    await steps(page, 1);
    const { x, y } = (await told(page)).log.flatMap(({ input }) => (input.do === 'fire' ? [input] : []))[0];
    expect(x).toBeCloseTo(0, 6);
    // The window shows 72 m of width; any body gives the place of the waterline.
    const pixels = 390 / 72;
    const known = await body(page, 0);
    const waterline = (known.screen?.y ?? 0) + known.y * pixels;
    expect(y).toBeCloseTo((waterline - 120) / pixels, 6);
    expect(y).toBeGreaterThan(80);
  });

  it('survives a window of no size and the loss of the graphics card', async () => {
    const page = await play('manual');
    await page.setViewportSize({ width: 1, height: 1 });
    await watch(page, 6);
    await page.setViewportSize({ width: 700, height: 420 });
    await page.mouse.click(300, 120);
    await steps(page, 150);
    const giveBack = await loseGraphicsCard(page);
    await steps(page, 1);
    await frames(page);
    await giveBack();
    await watch(page, 45);
    expect((await brightness(page)).bright).toBeGreaterThan(300);
  });
});

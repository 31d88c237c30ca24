/** Clips of a real canvas: whether they play, who gets them, and what becomes of the recorder. */
import type { Download, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';
import type {} from './clip.page.ts';

const browser = shareBrowser({ args: ['--autoplay-policy=no-user-gesture-required'] });
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('./clip.page.ts', import.meta.url));
});

afterAll(() => served?.close());

/** Opens the page, plays the test, and expects no uncaught error. */
async function withPage(play: (page: Page) => Promise<void>, prepare?: () => void): Promise<void> {
  const context = await browser().newContext({ viewport: { width: 390, height: 844 }, acceptDownloads: true });
  const errors: string[] = [];
  const page = await context.newPage();
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  // Without this the share sheet of a desktop would open, which no test can close.
  await page.addInitScript(() => Object.assign(navigator, { canShare: () => false, share: undefined }));
  if (prepare !== undefined) await page.addInitScript(prepare);
  await page.goto(served.url);
  await page.waitForFunction(() => globalThis.clipLab !== undefined);
  await play(page);
  expect(errors).toEqual([]);
  await context.close();
}

const clipButton = (page: Page) => page.locator('[data-clip]');
const message = (page: Page) => page.evaluate(() => clipLab.text());
const card = (page: Page) => page.locator('.game-clip');

async function base64Of(download: Download): Promise<string> {
  const pieces: Buffer[] = [];
  for await (const piece of await download.createReadStream()) pieces.push(piece as Buffer);
  return Buffer.concat(pieces).toString('base64');
}

/** A share sheet that takes files, and keeps what it was given. `answer` is what becomes of it. */
function shareSheet(answer: 'taken' | 'AbortError' | 'NotAllowedError' | 'none') {
  return `Object.assign(navigator, { canShare: ({ files }) => ${answer !== 'none'} && files.length === 1,
    share: async (given) => {
      globalThis.given = given;
      if ('${answer}' !== 'taken') throw new DOMException('The sheet said no.', '${answer}');
    } })`;
}

/** Records a clip until its card is there. */
async function clipOnCard(page: Page, answer: Parameters<typeof shareSheet>[0]): Promise<void> {
  await page.evaluate(shareSheet(answer));
  await clipButton(page).click();
  await card(page).waitFor();
}

test.each([0, 1, 2])('is a video that plays, of the length it promised, with the sound of %i contexts', (sounds) =>
  withPage(async (page) => {
    await page.evaluate((count) => clipLab.hum(count), sounds);
    const [download] = await Promise.all([page.waitForEvent('download'), clipButton(page).click()]);
    expect(download.suggestedFilename()).toMatch(/^black-hole-12\.3s\.(mp4|webm)$/);
    expect(await message(page)).toBe(`Your clip was saved as ${download.suggestedFilename()}.`);
    const type = download.suggestedFilename().endsWith('mp4') ? 'video/mp4' : 'video/webm';
    const clip = await page.evaluate(([data, kind]) => clipLab.inspect(data, kind), [await base64Of(download), type]);
    // At most 1280 pixels wide, of even size.
    expect(clip).toMatchObject({ width: 1280, height: 640 });
    const wanted = await page.evaluate(() => clipLab.SECONDS);
    // A busy machine without a graphics card makes few frames a second, and its sound begins before its pictures.
    expect(clip.seconds).toBeGreaterThan(wanted - 1.5);
    expect(clip.seconds).toBeLessThan(wanted + 2);
    expect(clip.loudness > 0.05).toBe(sounds > 0);
    expect(await page.evaluate(() => clipLab.resumed())).toBe(1);
  }),
);

test('shows the title and what the game marks, but no buttons and nothing hidden', () =>
  withPage(async (page) => {
    const [download] = await Promise.all([page.waitForEvent('download'), clipButton(page).click()]);
    const type = download.suggestedFilename().endsWith('mp4') ? 'video/mp4' : 'video/webm';
    const clip = await page.evaluate(([data, kind]) => clipLab.inspect(data, kind), [await base64Of(download), type]);
    // Letters cover a tenth of their box; the picture behind has neither black nor white.
    expect(clip.shown.black).toBeGreaterThan(0.6);
    expect(clip.shown.white).toBeGreaterThan(0.03);
    expect(clip.title.white).toBeGreaterThan(0.03);
    for (const { black, white } of [clip.hidden, clip.button, clip.unmarked]) expect(black + white).toBeLessThan(0.01);
  }));

test('counts down on its button, which gives the clip up when it is pressed again', () =>
  withPage(async (page) => {
    const before = await clipButton(page).textContent();
    await clipButton(page).click();
    expect(await clipButton(page).textContent()).toMatch(/^● [23] s$/);
    expect(await clipButton(page).getAttribute('aria-pressed')).toBe('true');
    const done = () => clipButton(page).evaluate((button) => Number(button.style.getPropertyValue('--done')));
    const first = await done();
    await page.waitForTimeout(500);
    expect(await done()).toBeGreaterThan(first);
    await clipButton(page).click();
    expect(await clipButton(page).textContent()).toBe(before);
    const download = page.waitForEvent('download', { timeout: 3500 }).catch(() => 'none');
    expect(await download).toBe('none');
    expect(await message(page)).toBe('');
  }));

test('is handed to the share sheet as a file of its type after a press', () =>
  withPage(async (page) => {
    await clipOnCard(page, 'taken');
    await card(page).locator('button', { hasText: 'Share' }).click();
    const given = await page.waitForFunction(() => {
      const [file] = (globalThis as unknown as { given?: ShareData }).given?.files ?? [];
      return file && { name: file.name, type: file.type, size: file.size };
    });
    expect(await given.jsonValue()).toEqual({
      name: expect.stringMatching(/^black-hole-12\.3s\.(mp4|webm)$/),
      type: expect.stringMatching(/^video\/(mp4|webm)$/),
      size: expect.any(Number),
    });
    const box = await card(page).boundingBox();
    expect(box).toMatchObject({ width: expect.any(Number) });
    expect((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 999) <= 390).toBe(true);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      card(page).locator('button', { hasText: 'Save' }).click(),
    ]);
    expect(download.suggestedFilename()).toContain('black-hole');
    await card(page).locator('button', { hasText: 'Close' }).click();
    expect(await card(page).isVisible()).toBe(false);
  }));

test('a closed sheet says nothing, and a refused one saves the clip with a sentence', () =>
  withPage(async (page) => {
    await clipOnCard(page, 'AbortError');
    await card(page).locator('button', { hasText: 'Share' }).click();
    await page.waitForTimeout(200);
    expect(await message(page)).toBe('');
    await page.evaluate(shareSheet('NotAllowedError'));
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      card(page).locator('button', { hasText: 'Share' }).click(),
    ]);
    expect(download.suggestedFilename()).toContain('black-hole');
    expect(await message(page)).toMatch(/did not share/);
  }));

test.each([
  ['there is no recorder', () => Object.assign(globalThis, { MediaRecorder: undefined })],
  ['no format is known', () => Object.assign(MediaRecorder, { isTypeSupported: () => false })],
])('says so where %s', (_why, prepare) =>
  withPage(
    async (page) => {
      await clipButton(page).click();
      expect(await message(page)).toMatch(/cannot record video/);
      expect(await page.evaluate(() => clipLab.sharing.secondsLeft)).toBeUndefined();
      expect(await page.evaluate(() => clipLab.resumed())).toBe(0);
    },
    prepare as () => void,
  ),
);

test('a recorder that fails to start leaves a sentence and no clip', () =>
  withPage(
    async (page) => {
      await clipButton(page).click();
      expect(await message(page)).toBe('The encoder is busy.');
      expect(await page.evaluate(() => clipLab.sharing.secondsLeft)).toBeUndefined();
    },
    () => {
      MediaRecorder.prototype.start = () => {
        throw new Error('The encoder is busy.');
      };
    },
  ));

test('is given up when its picture goes away, with one sentence, and lets go of the recorder', () =>
  withPage(
    async (page) => {
      await page.evaluate(() => clipLab.hum(1));
      await clipButton(page).click();
      await page.evaluate(() => clipLab.sharing.dropClip('The picture went away.'));
      await page.evaluate(() => clipLab.sharing.dropClip('Again.'));
      expect(await message(page)).toBe('The picture went away.');
      expect(await page.evaluate(() => clipLab.sharing.secondsLeft)).toBeUndefined();
      const recorders = await page.evaluate(() =>
        (globalThis as unknown as { recorders: MediaRecorder[] }).recorders.map(({ state, stream }) => [
          state,
          ...stream.getTracks().map(({ readyState }) => readyState),
        ]),
      );
      expect(recorders).toEqual([['inactive', 'ended', 'ended']]);
    },
    () => {
      const made: MediaRecorder[] = [];
      const Recorder = MediaRecorder;
      const Watched = class extends Recorder {
        constructor(...given: ConstructorParameters<typeof MediaRecorder>) {
          super(...given);
          made.push(this);
        }
      };
      Object.assign(globalThis, { MediaRecorder: Watched, recorders: made });
    },
  ));

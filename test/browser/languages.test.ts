/** Games in German: whether every word is, whether the words fit, and who gets which language. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { WORDS_BY_LANGUAGE as BLACK_HOLE } from '../../games/black-hole/words.ts';
import { WORDS_BY_LANGUAGE as BOUNCING_BALLS } from '../../games/bouncing-balls/words.ts';
import { WORDS_BY_LANGUAGE as CLOTH } from '../../games/cloth/words.ts';
import { WORDS_BY_LANGUAGE as FIREWORKS } from '../../games/fireworks/words.ts';
import { WORDS_BY_LANGUAGE as FLIGHT_SIMULATOR } from '../../games/flight-simulator/words.ts';
import { WORDS_BY_LANGUAGE as LABORATORY } from '../../games/laboratory/words.ts';
import { WORDS_BY_LANGUAGE as SOLAR_SYSTEM } from '../../games/solar-system/words.ts';
import { WORDS_BY_LANGUAGE as STACKING } from '../../games/stacking/words.ts';
import { WORDS_BY_LANGUAGE as SUBMARINE } from '../../games/submarine/words.ts';
import { WORDS_BY_LANGUAGE as SHELL } from '../../packages/shell/src/words.ts';
import { playGame, state } from '../support/game-page.ts';
import { textsOf } from '../support/words.ts';

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true } as const;

/** Everything that is written or read out on a page, but what is marked as English. */
const written = (page: Page) =>
  page.evaluate(() =>
    [...document.body.querySelectorAll('*')].flatMap((element) => {
      if (/^(STYLE|SCRIPT|NOSCRIPT)$/.test(element.tagName)) return [];
      if (element.closest('[lang]')?.getAttribute('lang') === 'en') return [];
      const own = [...element.childNodes].filter(({ nodeType }) => nodeType === Node.TEXT_NODE);
      const said = ['title', 'aria-label', 'placeholder'].map((name) => element.getAttribute(name) ?? '');
      return [...own.map(({ textContent }) => (textContent ?? '').trim()), ...said].filter((text) => text !== '');
    }),
  );

/** English words that German has another one for; single letters are names of keys as well. */
function foreignWords(english: Parameters<typeof textsOf>[0], german: Parameters<typeof textsOf>[0]): Set<string> {
  const known = new Set(textsOf(german).map(([, text]) => text));
  return new Set(
    textsOf(english).flatMap(([, text]) => (known.has(text) || text.trim().length === 1 ? [] : [text.trim()])),
  );
}

/** What a page writes into its console, kept in a list. */
function listenToConsole(): void {
  const said: string[] = [];
  Object.assign(globalThis, { consoleSays: said });
  for (const kind of ['log', 'warn', 'error'] as const) {
    console[kind] = (...parts: unknown[]) => said.push(parts.join(' '));
  }
}

/** What the page wrote into its console. */
const consoleOf = (page: Page) => page.evaluate(() => (globalThis as unknown as { consoleSays: string[] }).consoleSays);

/** What must fit: buttons, headings, cards of the shell and texts over the picture. */
const FITTING =
  'button:not(.ss-label), a, h1, dt, .game-card, .game-hint, .fw-hint, .sub-panel > *, .bh-hud > *, .cloth-print, .st-tools, .fs-task, .ss-date > *, .ss-menu';

/** Buttons and headings whose text is cut off, and what sticks out of the window. */
const overflows = (page: Page) =>
  page.evaluate(
    (fitting) =>
      [...document.body.querySelectorAll<HTMLElement>(fitting)].flatMap((element) => {
        if (!element.checkVisibility({ visibilityProperty: true }) || element.lang === 'en') return [];
        const { left, right } = element.getBoundingClientRect();
        const isCut = element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).display !== 'inline';
        const isOut = left < -0.5 || right > innerWidth + 0.5;
        return isCut || isOut ? [`“${element.textContent}” ${isCut ? 'is cut off' : 'sticks out'}`] : [];
      }),
    FITTING,
  );

describe('fireworks', () => {
  const { open } = playGame('fireworks', { viewport: { width: 1280, height: 800 } });

  it('speak German where the browser does, or where the address says so, and English otherwise', async () => {
    const languageOf = async (query: string, locale: string) => {
      const page = await open(`manual&renderer=pixi${query}`, {
        locale,
        viewport: { width: 480, height: 320 },
        until: 'game',
      });
      const title = await page.locator('h1').textContent();
      const found = [await page.locator('html').getAttribute('lang'), title, (await state(page)).banner];
      await page.close();
      return found;
    };
    expect(await languageOf('', 'de-AT')).toEqual(['de', 'Feuerwerk', '']);
    expect(await languageOf('&lang=de', 'en-GB')).toEqual(['de', 'Feuerwerk', '']);
    expect(await languageOf('&lang=en', 'de-DE')).toEqual(['en', 'Fireworks', '']);
    expect(await languageOf('', 'fr-FR')).toEqual(['en', 'Fireworks', '']);
  });

  it.each([
    ['a phone', PHONE],
    ['a desk', {}],
  ])('have no English word left on %s, and every word fits', async (_name, options) => {
    const page = await open('manual&renderer=pixi&lang=de&barrage=on', options);
    if (!(await page.locator('.game-side').isVisible())) await page.keyboard.press('p');
    expect(await overflows(page)).toEqual([]);
    // The editor of shows, the field for text, the list of shows, the time of a step and the help, each of which is hidden at first.
    await page.keyboard.press('o');
    const [write, shows] = await page.locator('.fw-extra[aria-expanded]').all();
    await write.evaluate((button: HTMLElement) => button.click());
    await page.keyboard.press('Escape');
    await write.evaluate((button: HTMLElement) => button.click());
    await shows.evaluate((button: HTMLElement) => button.click());
    await page
      .locator('.fw-tray button')
      .first()
      .evaluate((button: HTMLElement) => button.click());
    await page.evaluate(() => __game.step(40));
    // On a phone Escape also closes the panel, whose times are only written while it is open.
    if (!(await page.locator('.game-side').isVisible())) await page.keyboard.press('p');
    await page.waitForFunction(() => / ms$/.test(document.querySelector('.game-stats dd')?.textContent ?? ''));
    expect(await overflows(page)).toEqual([]);
    const foreign = new Set([...foreignWords(SHELL.en, SHELL.de), ...foreignWords(FIREWORKS.en, FIREWORKS.de)]);
    expect(foreign.size).toBeGreaterThan(100);
    const texts = await written(page);
    expect(texts.length).toBeGreaterThan(100);
    expect(texts.filter((text) => foreign.has(text))).toEqual([]);
    expect(texts).toContain('Grün (Barium) (C)');
    expect(texts.filter((text) => /^\d+\.\d+ (s|ms)$/.test(text))).toEqual([]);
    expect(texts.some((text) => /^0,\d s$/.test(text))).toBe(true);
  });
});

describe('submarine', () => {
  const { open } = playGame('submarine', { viewport: { width: 1280, height: 800 } });

  it.each([
    ['a phone', PHONE],
    ['a phone on its side', { ...PHONE, viewport: { width: 844, height: 390 } }],
    ['a desk', {}],
  ])('has no English word left on %s, and every word fits', async (_name, options) => {
    const page = await open('manual&lang=de', options);
    expect(await overflows(page)).toEqual([]);
    if (!(await page.locator('.game-side').isVisible())) await page.keyboard.press('p');
    expect(await overflows(page)).toEqual([]);
    const foreign = new Set([...foreignWords(SHELL.en, SHELL.de), ...foreignWords(SUBMARINE.en, SUBMARINE.de)]);
    const texts = await written(page);
    expect(texts).toEqual(
      expect.arrayContaining([
        'U-Boot',
        'Hol 3 Kisten herauf zum Schiff, bevor die Luft zu Ende ist: 0 an Bord',
        'Druckluft',
      ]),
    );
    expect(texts.some((text) => / m, \d,\d atm · Dichte 0,9/.test(text))).toBe(true);
    expect(texts.filter((text) => foreign.has(text))).toEqual([]);
  });
});

type Texts = Parameters<typeof textsOf>[0];

/** The other games: their words, and some German ones that are seen at once. */
const GAMES: readonly (readonly [
  name: string,
  words: Readonly<Record<'en' | 'de', Texts>>,
  seen: readonly string[],
])[] = [
  ['black-hole', BLACK_HOLE, ['Schwarzes Loch', 'Tagesaufgabe', 'zählt 1 · Bonus 0']],
  ['bouncing-balls', BOUNCING_BALLS, ['Hüpfende Bälle', 'Gießen', 'Schwerkraft, m/s²', 'Erde']],
  ['cloth', CLOTH, ['Ein Tuch zum Zerreißen', 'Bild aufdrucken', 'Reißkraft, N']],
  ['stacking', STACKING, ['Stapeln und umwerfen', 'Kleben', 'Dominosteine', 'Hüllen und Schlaf']],
  ['flight-simulator', FLIGHT_SIMULATOR, ['Flugsimulator', 'Seitenwind, m/s', 'Eine Platzrunde']],
  ['solar-system', SOLAR_SYSTEM, ['Sonnensystem', 'Schwung am Jupiter', 'Missionen', 'Erde']],
];

describe.each(GAMES)('%s', (name, words, seen) => {
  const { open } = playGame(name, { viewport: { width: 1280, height: 800 }, prepare: listenToConsole });

  it.each([
    ['a phone', PHONE],
    ['a desk', {}],
  ])('has no English word left on %s, and every word fits', async (_name, options) => {
    const page = await open('manual&lang=de', options);
    await page.evaluate(() => __game.step(20));
    expect(await page.locator('html').getAttribute('lang')).toBe('de');
    expect(await overflows(page)).toEqual([]);
    if (!(await page.locator('.game-side').isVisible())) await page.keyboard.press('p');
    expect(await overflows(page)).toEqual([]);
    const texts = await written(page);
    expect(seen.filter((text) => !texts.includes(text))).toEqual([]);
    const foreign = new Set([...foreignWords(SHELL.en, SHELL.de), ...foreignWords(words.en, words.de)]);
    expect(texts.filter((text) => foreign.has(text))).toEqual([]);
    expect(await consoleOf(page)).toEqual([]);
  });
});

describe('laboratory', () => {
  const { open } = playGame('laboratory', { viewport: { width: 1280, height: 800 }, prepare: listenToConsole });
  const foreign = new Set([...foreignWords(SHELL.en, SHELL.de), ...foreignWords(LABORATORY.en, LABORATORY.de)]);
  const seenOn = async (page: Page, seen: readonly string[]) => {
    expect(await page.locator('html').getAttribute('lang')).toBe('de');
    const texts = await written(page);
    expect(seen.filter((text) => !texts.includes(text))).toEqual([]);
    expect(texts.filter((text) => foreign.has(text))).toEqual([]);
    expect(await overflows(page)).toEqual([]);
    expect(await consoleOf(page)).toEqual([]);
  };

  it.each([
    ['a phone', PHONE],
    ['a desk', {}],
  ])('has a list with no English word but those of the examples on %s', async (_name, options) => {
    const page = await open('lang=de', { ...options, until: 'nothing' });
    await page.locator('.start-picture svg').first().waitFor();
    await seenOn(page, ['Das Labor', 'Kapitel 17 · Über das Buch hinaus', 'Beginne mit einem von diesen']);
    expect(await page.locator('.start a[href*="example="]').first().getAttribute('href')).toContain('lang=de');
    expect(page.url()).toContain('lang=de');
  });

  it.each([
    ['a phone', PHONE],
    ['a desk', {}],
  ])('has an example with no English word around it on %s', async (_name, options) => {
    const page = await open('example=ch08-free-oscillations&ghosts=integrators&manual&lang=de', options);
    await page.evaluate(() => __game.step(60));
    if (!(await page.locator('.game-side').isVisible())) await page.keyboard.press('p');
    // The names of what is plotted are English, and so is the sentence about it.
    await page.waitForFunction(() => /After 1\.0 s/.test(document.querySelector('.lab-words')?.textContent ?? ''));
    await seenOn(page, ['Probier das', 'Berechnet und exakt', 'Der des Beispiels', 'Verlet, Geschwindigkeit', 'exakt']);
    expect(await page.locator('.lab-checks').innerText()).not.toMatch(/computed|\d\.\d/);
    await page.keyboard.press('k');
    await page.locator('.lab-code textarea').fill('export default 3;');
    await page.locator('.lab-code button').first().click();
    // It is tried in a worker, which speaks the language of the page.
    const note = page.locator('.lab-code-note');
    await expect.poll(() => note.textContent(), { timeout: 8000 }).toBe(LABORATORY.de.code.noExample);
  });
});

describe('numbers in the panel', () => {
  const { open } = playGame('cloth', { viewport: { width: 1280, height: 800 } });

  it.each([
    ['a phone', 'de', PHONE, ['2,5', '9,81']],
    ['a desk', 'de', {}, ['2,5', '9,81']],
    ['a desk', 'en', {}, ['2.5', '9.81']],
  ] as const)(
    'on %s in %s have its decimal sign, and are taken with comma and point',
    async (_name, lang, options, shown) => {
      const page = await open(`manual&renderer=pixi&lang=${lang}`, options);
      if (!(await page.locator('.game-side').isVisible())) await page.keyboard.press('p');
      const field = (label: string) => page.locator('.lil-controller', { hasText: label }).locator('input');
      const [strength, gravity] = [field(', N'), field('m/s²')];
      const read = async () => [await strength.inputValue(), await gravity.inputValue()];
      expect(await read()).toEqual(shown);
      for (const [strengthTyped, gravityTyped] of [
        ['3,5', '1.6'],
        ['3.5', '1,6'],
      ]) {
        await strength.fill('1');
        await strength.fill(strengthTyped);
        await gravity.fill('2');
        await gravity.fill(gravityTyped);
        await gravity.blur();
        const { values } = await state(page);
        expect([values.strength, values.gravity]).toEqual([3.5, 1.6]);
        expect(await read()).toEqual(lang === 'de' ? ['3,5', '1,6'] : ['3.5', '1.6']);
      }
      await gravity.press('ArrowUp');
      expect((await state(page)).values.gravity).toBe(1.7);
      expect(await gravity.inputValue()).toBe(lang === 'de' ? '1,7' : '1.7');
      // What is typed between two steps of the slider is kept, and so are its digits.
      await gravity.fill('9.81');
      await gravity.press('ArrowUp');
      await gravity.press('Shift+ArrowDown');
      expect((await state(page)).values.gravity).toBe(8.91);
      await page.locator('.lil-controller button', { hasText: lang === 'de' ? 'Standard' : 'Defaults' }).click();
      expect(await read()).toEqual(shown);
    },
  );
});

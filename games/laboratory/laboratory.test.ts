import { EXAMPLES } from '@principia/scenes/examples/list';
import { csvOf } from '@principia/shell';
import { expect, test } from 'vitest';
import { csvNames } from './csv-names.ts';
import { unitsOf } from './example-units.ts';
import { gridLines } from './grid-lines.ts';
import { percentage, plainNumber } from './number-text.ts';
import { plotSentence } from './plot-sentence.ts';
import { Samples } from './samples.ts';
import { isFound } from './search.ts';

test('samples keep the whole run in a fixed memory, and forget what was rewound', () => {
  const samples = new Samples(1, 0.1, 100);
  let added = 0;
  for (let i = 0; i <= 10_000; i++) {
    const time = i / 60;
    if (!samples.isDue(time)) continue;
    samples.add(time, [2 * time]);
    added++;
  }
  const [times, values] = samples.columns;
  expect(added).toBeGreaterThan(100);
  expect(times.length).toBeLessThanOrEqual(100);
  expect(times[0]).toBe(0);
  expect(times.at(-1)).toBeGreaterThan(0.95 * (10_000 / 60));
  expect(values).toEqual(times.map((time) => 2 * time));
  expect(samples.discardAfter(50)).toBe(true);
  expect(samples.columns[0].at(-1)).toBeLessThanOrEqual(50);
  expect(samples.discardAfter(50)).toBe(false);
});

test('grid lines are round and within the range', () => {
  expect(gridLines(0, 1440, 180)).toEqual([0, 180, 360, 540, 720, 900, 1080, 1260, 1440]);
  expect(gridLines(-1.2, 1.2)).toEqual([-1, -0.5, 0, 0.5, 1]);
  expect(gridLines(0, 0.3)).toEqual([0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3]);
});

test('a plot in words has its title, and each series its value and its unit', () => {
  const of = (label: string, value: number) => ({ label, value: () => value });
  const fall = { title: 'Speed', y: { label: 'v, px/s' }, series: [of('stepped', 16.5819), of('without air', -20)] };
  expect(plotSentence(fall)).toBe('Speed: stepped 16.5819 px/s, without air −20 px/s');
  const parts = { title: 'The four numbers', y: { label: 'part' }, series: [of('x', 0), of('w', 1)] };
  expect(plotSentence(parts)).toBe('The four numbers: x 0, w 1');
});

test('numbers are short and plain', () => {
  expect([0, 1.99314159, -9.043, 1e-5, -5e-5, 15_000, 3e9, Number.NaN].map(plainNumber)).toEqual([
    '0',
    '1.99314',
    '−9.043',
    '1.00e−5',
    '−5.00e−5',
    '15000',
    '3.00e9',
    '–',
  ]);
  expect([0, 0.0006, 2e-9, 0.5].map(percentage)).toEqual(['0 %', '0.06 %', '2e−7 %', '50 %']);
});

test('tables have a line of names, which are quoted where they have a comma', () => {
  expect(
    csvOf(
      ['t, s', 'x'],
      [
        [0, 1],
        [2, 3.5],
      ],
    ),
  ).toBe('"t, s",x\n0,2\n1,3.5\n');
});

test('the columns of a plot have its unit', () => {
  expect(csvNames(['stepped', 'exact'], 'x, px')).toEqual(['t, s', 'x, px (stepped)', 'x, px (exact)']);
  expect(csvNames(['path'], 'v, px/s', 'x, px')).toEqual(['t, s', 'x, px (path)', 'v, px/s (path)']);
});

test('no plot of an example has the name of a general one of its page', async () => {
  for (const entry of EXAMPLES) {
    const titles = (await entry.load()).start().plots.map(({ title }) => title);
    for (const total of ['Energy', 'Momentum', 'Angular momentum']) expect(titles, entry.id).not.toContain(total);
    expect(new Set(titles).size, entry.id).toBe(titles.length);
  }
});

test('an example in pixels has them on its whole page', async () => {
  const unitsOfExample = async (id: string) => {
    const entry = EXAMPLES.find((each) => each.id === id);
    return unitsOf((await entry?.load())?.start().plots ?? []);
  };
  expect(await unitsOfExample('ch08-damped')).toMatchObject({ m: 'px', J: 'kg px²/s²' });
  expect(await unitsOfExample('ch05-projectile-energy')).toMatchObject({ 'm/s': 'px/s' });
  expect(await unitsOfExample('ch12-fireworks')).toEqual({});
});

test('a search for a chapter finds that chapter alone, and other words wherever they are', () => {
  const chaptersOf = (search: string) => {
    const found = EXAMPLES.filter((entry) => isFound(entry, search));
    return { chapters: [...new Set(found.map(({ chapter }) => chapter))], count: found.length };
  };
  const all = (chapter: number) => EXAMPLES.filter((entry) => entry.chapter === chapter).length;
  for (const chapter of [1, 3, 8, 17]) {
    const found = { chapters: [chapter], count: all(chapter) };
    expect(chaptersOf(`chapter ${chapter}`)).toEqual(found);
    expect(chaptersOf(`Kapitel  ${chapter} `)).toEqual(found);
  }
  expect(chaptersOf('Chapter 8 bungee').chapters).toEqual([8]);
  expect(chaptersOf('chapter').count).toBe(EXAMPLES.length);
  expect(chaptersOf('chapter 8 chapter 9').count).toBe(0);
  expect(chaptersOf('orbit').count).toBeGreaterThan(10);
});

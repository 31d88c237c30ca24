import { expect, it } from 'vitest';
import { readAddress, withSettings, writeAddress } from './address.ts';
import { numberSetting, switchSetting } from './settings.ts';

const settings = {
  count: numberSetting({ unit: '', initial: 5, min: 1, max: 100, integer: true }, { label: 'Balls' }),
  trails: switchSetting('Trails', false),
};
const read = (query: string) => readAddress(query, settings, ['pixi', 'three']);

it('has the initial values when nothing is asked for', () => {
  expect(read('')).toEqual({
    values: { count: 5, trails: false },
    seed: 1,
    renderer: 'pixi',
    plot: undefined,
    manual: false,
    problems: [],
  });
});

it('leaves the language and the preview to others', () => {
  expect(read('?lang=de&preview=action').problems).toEqual([]);
});

it('takes what it can take', () => {
  expect(read('?seed=7&count=20&trails&renderer=three&plot=Momentum&manual')).toEqual({
    values: { count: 20, trails: true },
    seed: 7,
    renderer: 'three',
    plot: 'Momentum',
    manual: true,
    problems: [],
  });
});

it('ignores what others append to links', () => {
  const query = '?fbclid=IwAR0&utm_source=news&utm_medium=mail&gclid=1&msclkid=2&ref=site&count=9';
  expect(read(query)).toMatchObject({ values: { count: 9 }, problems: [] });
});

it('has a sentence for everything else, and keeps what there was', () => {
  const { values, seed, renderer, problems } = read('?count=0&seed=x&renderer=toString&toString=1&trails=maybe');
  expect({ values, seed, renderer }).toEqual({ values: { count: 5, trails: false }, seed: 1, renderer: 'pixi' });
  expect(problems).toEqual([
    'In the address, count must be a whole number from 1 to 100, but it was 0. Using 5 instead.',
    'In the address, seed must be a whole number from 0 to 4294967295, but it was “x”. Using 1 instead.',
    'In the address, renderer must be pixi or three, but it was “toString”. Using 2D instead.',
    'In the address, trails must be on or off, but it was “maybe”. Using off instead.',
    'The address names “toString”, which this game does not have. The settings are count, trails, seed, renderer, plot, manual.',
  ]);
});

it('lists the settings once, however many unknown names there are', () => {
  expect(read('?a=1&b=2&a=3').problems).toEqual([
    'The address names “a”, “b”, which this game does not have. The settings are count, trails, seed, renderer, plot, manual.',
  ]);
});

it('writes what it reads', () => {
  const wanted = { values: { count: 7, trails: true }, seed: 42, renderer: 'three', plot: 'Position.y,,1' };
  const link = writeAddress('https://example.org/game/?utm_source=x&count=3#part', settings, wanted);
  expect(link).toBe('https://example.org/game/?seed=42&renderer=three&count=7&trails=true&plot=Position.y%2C%2C1#part');
  expect(read(new URL(link).search)).toMatchObject(wanted);
});

it('changes the settings of an address, and leaves what else it says', () => {
  const page = 'https://example.org/game/?lang=de&count=3&manual&own=1#part';
  const link = withSettings(page, settings, { count: 5, trails: true });
  expect(link).toBe('https://example.org/game/?lang=de&manual=&own=1&trails=true#part');
  expect(read(new URL(link).search)).toMatchObject({ values: { count: 5, trails: true }, manual: true });
});

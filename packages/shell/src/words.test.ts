import { afterEach, describe, expect, it, vi } from 'vitest';
import { wordProblems } from '../../../test/support/words.ts';
import { chooseWords } from './choose-words.ts';
import { decimal, grouped, LANGUAGES, language, preferredLanguage, speak } from './language.ts';
import { decimalsOf, plainNumber } from './number-field.ts';
import { siNumber } from './si-number.ts';
import { WORDS_BY_LANGUAGE, words } from './words.ts';

it.each(LANGUAGES)('has every word and every placeholder in the language %s', (name) => {
  expect(wordProblems(WORDS_BY_LANGUAGE.en, WORDS_BY_LANGUAGE[name])).toEqual([]);
});

it('notices a key or a placeholder that is missing', () => {
  const given = { a: 'one', b: (x: string) => `two ${x}`, c: ['x', 'y'] };
  expect(wordProblems(given, { a: '', b: () => 'zwei', c: ['x'] })).toEqual([
    'a is empty',
    'b lacks 70001',
    'only one language has c.1',
  ]);
});

it.each([
  ['', [], 'en'],
  ['', ['fr-FR', 'de-CH', 'en'], 'de'],
  ['', ['en-GB', 'de'], 'en'],
  ['?seed=3&lang=de', ['en'], 'de'],
  ['?lang=EN', ['de'], 'en'],
  ['?lang=fr', ['de-AT'], 'de'],
  ['?lang=fr', ['fr'], 'en'],
] as const)('of the address %j and the wishes %j chooses %s', (query, wishes, chosen) => {
  expect(preferredLanguage(query, wishes, LANGUAGES)).toBe(chosen);
});

describe('a game in a language that the shell has not', () => {
  const texts = { en: 'Fall', de: 'Fall (de)', fr: 'Chute' };
  const fr = { settings: 'Réglages', plots: { Energy: 'Énergie' }, bodyNumber: (index: number) => `corps ${index}` };
  const open = (search: string, languages: readonly string[]) => {
    vi.stubGlobal('location', { search });
    vi.stubGlobal('navigator', { languages });
    return chooseWords(texts, { fr });
  };

  afterEach(() => {
    vi.unstubAllGlobals();
    speak('en');
  });

  it('supplies words of the shell, English ones stand for the others', () => {
    expect(open('', ['fr-CA', 'de'])).toBe('Chute');
    expect(language()).toBe('fr');
    const { settings, plots, bodyNumber, restart } = words();
    expect([settings, plots.Energy, plots.Momentum, bodyNumber(2), restart]).toEqual([
      'Réglages',
      'Énergie',
      'Momentum',
      'corps 2',
      'Restart',
    ]);
    expect(wordProblems(WORDS_BY_LANGUAGE.en, words())).toEqual([]);
    expect([decimal(1.5, 2), siNumber(1500, 'm')]).toEqual(['1,50', '1,5 km']);
  });

  it('is chosen by the address before the browser', () => {
    expect(open('?lang=fr', ['de'])).toBe('Chute');
    expect([open('?lang=en', ['fr']), words()]).toEqual(['Fall', WORDS_BY_LANGUAGE.en]);
    expect([open('?lang=ja', ['de']), words()]).toEqual(['Fall (de)', WORDS_BY_LANGUAGE.de]);
  });
});

it.each([
  ['9.81', false, '9.81'],
  ['9,81', false, '9.81'],
  [' −1,5 ', false, '-1.5'],
  ['1.234,5', false, '1234.5'],
  ['1,234.5', false, '1234.5'],
  ['1,250', false, '1.250'],
  ['1 000', false, '1000'],
  ['1 000,5', false, '1000.5'],
  ['100,000', true, '100000'],
  ['100.000', true, '100000'],
  ['1 000 000', true, '1000000'],
  ['1e5', true, '1e5'],
  ['', false, ''],
])('reads %j, whole: %j, as %j', (typed, isWhole, plain) => {
  expect(plainNumber(typed, isWhole)).toBe(plain);
});

it.each([
  [9.81, 1, '9.81'],
  [9, 1, '9.0'],
  [250, 0, '250'],
  [0.1 + 0.2, 1, '0.3'],
  [1 / 3, 1, '0.3333333'],
  [-2.5e-6, 2, '-0.0000025'],
  [123_456.789, 0, '123456.8'],
  [0, 2, '0.00'],
])('shows %j in full, with %j decimals at least: %j', (value, least, shown) => {
  expect(value.toFixed(decimalsOf(value, least))).toBe(shown);
});

it('speaks English outside a page', () => {
  expect(language()).toBe('en');
  expect(words()).toBe(WORDS_BY_LANGUAGE.en);
  expect([decimal(1234.5, 2), grouped(1234), siNumber(1.5, 'm')]).toEqual(['1234.50', '1,234', '1.5 m']);
  expect([decimal(-0.04, 1), decimal(-0.06, 1), decimal(0, 0)]).toEqual(['0.0', '-0.1', '0']);
});

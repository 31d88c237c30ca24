/** What players read: the same words and placeholders in every language, wherever a file offers several. */
import { readdirSync, readFileSync } from 'node:fs';
import { SHELL_NAMES, STAR_COLORS } from '@principia/scenes';
import { expect, it } from 'vitest';
import { WORDS_BY_LANGUAGE as FIREWORKS } from '../../games/fireworks/words.ts';
import { LANGUAGES } from '../../packages/shell/src/language.ts';
import { wordProblems } from '../support/words.ts';

type Texts = Parameters<typeof wordProblems>[0];

const files = ['games', 'packages']
  .flatMap((folder) => readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((file) => `${folder}/${file}`))
  .map((file) => file.replaceAll('\\', '/'))
  .filter((file) => /^(games\/[^/]+|packages\/[^/]+\/src)\/words\.(ts|mjs)$/.test(file));

it.each(files)('%s has every word and every placeholder in every language', async (file) => {
  const { WORDS_BY_LANGUAGE } = (await import(`../../${file}`)) as { WORDS_BY_LANGUAGE?: Record<string, Texts> };
  if (WORDS_BY_LANGUAGE === undefined) return;
  expect(Object.keys(WORDS_BY_LANGUAGE).toSorted()).toEqual([...LANGUAGES].toSorted());
  for (const name of LANGUAGES) expect(wordProblems(WORDS_BY_LANGUAGE.en, WORDS_BY_LANGUAGE[name])).toEqual([]);
});

it('finds the words of the shell and of fireworks', () => {
  expect(files).toEqual(expect.arrayContaining(['games/fireworks/words.ts', 'packages/shell/src/words.ts']));
});

it('calls shells and colours in English what their scene calls them', () => {
  expect(FIREWORKS.en.shells).toEqual(SHELL_NAMES);
  expect(FIREWORKS.en.colors).toEqual(STAR_COLORS.map(({ name }) => name));
});

it.each(files.filter((file) => /^games\/.*\.ts$/.test(file)))(
  '%s and its line on the front page agree',
  async (file) => {
    const { WORDS_BY_LANGUAGE: words } = (await import(`../../${file}`)) as Record<
      string,
      Record<string, { title: string }>
    >;
    const html = readFileSync(file.replace('words.ts', 'index.html'), 'utf8');
    expect(html).toContain(`<title>${words.en.title}</title>`);
    expect(html).toContain(`<meta name="title" lang="de" content="${words.de.title}">`);
    expect(html).toMatch(/<meta name="description" lang="de" content="[^"]+">/);
  },
);

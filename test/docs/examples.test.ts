import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { WORDS_BY_LANGUAGE } from '../../games/laboratory/words.ts';
import type { Example } from '../../packages/scenes/src/examples/define-example.ts';
import { EXAMPLES } from '../../packages/scenes/src/examples/examples.gen.ts';
import { withMarkedPart } from './marked-table.ts';

const page = readFileSync('docs/examples.md', 'utf8');
const subjects: Readonly<Record<number, string>> = WORDS_BY_LANGUAGE.en.chapters;

const firstSentence = (text: string) => /^.*?[.!?](?=\s|$)/.exec(text)?.[0] ?? text;
const cell = (text: string) => text.replaceAll('|', '\\|');

function row({ id, title, about, checks }: Example): string {
  const source = `../packages/scenes/src/examples/${id.replace('-', '/')}.ts`;
  const figures = checks.map(({ label }) => cell(label)).join('<br>');
  return `| [${cell(title)}](${source}) | ${cell(firstSentence(about))} | ${figures} |`;
}

function tables(examples: readonly Example[]): string {
  const chapters = [...new Set(examples.map(({ chapter }) => chapter))];
  return chapters
    .map((chapter) => {
      const rows = examples.filter((example) => example.chapter === chapter).map(row);
      return `\n## ${chapter}. ${subjects[chapter]}\n\n| example | what it shows | checked |\n|---|---|---|\n${rows.join('\n')}`;
    })
    .join('\n');
}

test('docs/examples.md lists every example; `npx vitest run test/docs/examples.test.ts -u` writes it', async () => {
  const examples = await Promise.all(EXAMPLES.map(({ load }) => load()));
  await expect(withMarkedPart(page, tables(examples))).toMatchFileSnapshot('../../docs/examples.md');
});

/** The table of docs/faults.md: every case of bad input, by the titles of the tests that hold it. */
import { readFileSync } from 'node:fs';
import { typescriptFiles } from '../rules/sources.ts';

/** Cases without a test, because what they need does not exist yet. */
export const MISSING: readonly (readonly [first: number, last: number, what: string])[] = [[41, 41, 'meshes']];

interface Case {
  readonly number: string;
  readonly title: string;
}

/** The cases in the titles of a test file: a number or a list of numbers, and what happens. */
function casesIn(path: string): Case[] {
  const text = readFileSync(path, 'utf8');
  const titles = [...text.matchAll(/\(\s*(['"`])(\d{1,2}(?:, \d{1,2})*) (?=\D)(.+?)\1,/g)];
  return titles.flatMap(([, , numbers, title]) => numbers.split(', ').map((number) => ({ number, title })));
}

/** Placeholders of tables of tests. */
const readable = (title: string) => title.replace(/ ?\((%[sdi])[^)]*\)/g, '').replace(/%[sdi]|\$title/g, '…');

function rowsOf(cases: readonly Case[]): string[] {
  const numbers = [...new Set(cases.map(({ number }) => Number(number)))].sort((a, b) => a - b);
  return numbers.map((number) => {
    const titles = cases.filter((each) => Number(each.number) === number).map(({ title }) => readable(title));
    return `| ${number} | ${[...new Set(titles)].join('<br>')} |`;
  });
}

const tests = typescriptFiles.filter((path) => /^(test|packages\/physics\/src)\/.*\.test\.ts$/.test(path));
const TRIALS = 'test/faults/trials.test.ts';

export const numbered = tests
  .filter((path) => path !== TRIALS && path !== 'test/determinism/golden.test.ts')
  .flatMap(casesIn);

export function faultsTable(): string {
  const missing = MISSING.map(
    ([first, last, what]) => `| ${first === last ? first : `${first}–${last}`} | not yet: ${what} |`,
  );
  const head = ['| case | what happens |', '|---|---|'];
  const battery = [...head, ...rowsOf(numbered), ...missing];
  const attacks = [...head, ...rowsOf(casesIn(TRIALS))];
  return [...battery, '', '### Found by attacks', '', ...attacks].join('\n');
}

// docs/glossary.md gives each idea one word, and lists the words that are not used for it. Names that the packages export
// use none of those.
import { readFileSync } from 'node:fs';
import { COMPONENT_NAMES, COMPONENTS } from '@principia/physics';
import { expect, test } from 'vitest';
import { packageNames } from '../../scripts/lib/packages.mjs';

interface Entry {
  readonly term: string;
  readonly meaning: string;
  readonly rejected: readonly string[];
}

const rows = readFileSync('docs/glossary.md', 'utf8')
  .split('\n')
  .filter((line) => /^\| (?!term)/.test(line));
const entries: readonly Entry[] = rows.map((line) => {
  const [term = '', meaning = '', not = ''] = line
    .split('|')
    .slice(1)
    .map((cell) => cell.trim());
  return { term, meaning, rejected: [...not.matchAll(/`([^`]+)`/g)].map(([, word]) => word) };
});

/** Names that still use a rejected word; each leaves this list when it is renamed. */
const ALLOWED: readonly string[] = [
  // Of the scenes: how long a finger is held.
  'maxHoldSeconds',
  'Stretch',
];

/** `Looks` and `holdBodies` as the words they are made of, in lower case and between spaces. */
function wordsOf(name: string): string {
  const parts = name.split(/_|(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])/);
  return ` ${parts.join(' ').toLowerCase()} `;
}

function uses(name: string, rejected: string): boolean {
  return rejected.endsWith('()') ? `${name}()` === rejected : wordsOf(name).includes(` ${rejected} `);
}

/** Names with a rejected word, each with the word to say. */
function rejectedNames(names: readonly string[]): string[] {
  return names.flatMap((name) =>
    entries
      .filter(({ rejected }) => rejected.some((word) => uses(name, word)))
      .map(({ term }) => `${name}: say “${term}”`),
  );
}

/** What an index exports, by the names that users write. */
function exportedNames(packageName: string): string[] {
  const text = readFileSync(`packages/${packageName}/src/index.ts`, 'utf8').replaceAll(/\/\*[\s\S]*?\*\//g, '');
  const lists = [...text.matchAll(/export (?:type )?\{([\s\S]*?)\}/g)].flatMap(([, list]) => list.split(','));
  return lists
    .map((item) =>
      item
        .trim()
        .replace(/^type /, '')
        .replace(/^.* as /, ''),
    )
    .filter(Boolean);
}

const publicNames = [
  ...packageNames.flatMap(exportedNames),
  ...COMPONENT_NAMES.flatMap((name) => [name, ...Object.keys(COMPONENTS[name].fields)]),
];

test('every term has one line, a meaning, and its place in the alphabet', () => {
  expect(entries.length).toBeGreaterThan(60);
  const terms = entries.map(({ term }) => term.toLowerCase());
  expect(terms).toEqual([...new Set(terms)].toSorted());
  for (const { term, meaning } of entries) expect(meaning.length, term).toBeGreaterThan(10);
});

test('no word is a term and rejected, and none is rejected twice', () => {
  const words = entries.flatMap(({ rejected }) => rejected);
  expect(words.length).toBe(new Set(words).size);
  const terms = entries.flatMap(({ term }) => term.toLowerCase().split(', '));
  expect(words.filter((word) => terms.includes(word))).toEqual([]);
});

test('the index of every package is read', () => {
  expect(publicNames).toEqual(expect.arrayContaining(['spawn', 'realField', 'BodyLayer', 'startGame', 'Mass', 'mu']));
});

test('exported names use no word that the glossary rejects', () => {
  expect(rejectedNames(publicNames.filter((name) => !ALLOWED.includes(name)))).toEqual([]);
});

test('nor do the names that pages on additions to the package have readers export', () => {
  const pages = ['adding-a-force', 'adding-an-integrator', 'adding-a-joint', 'adding-a-shape'];
  const names = pages.flatMap((page) =>
    [...readFileSync(`docs/${page}.md`, 'utf8').matchAll(/export (?:const|function|interface) (\w+)/g)].map(
      ([, name]) => name,
    ),
  );
  expect(names).toEqual(expect.arrayContaining(['bowl', 'explicitEuler', 'groove', 'GrooveOptions', 'triangle']));
  expect(rejectedNames(names)).toEqual([]);
});

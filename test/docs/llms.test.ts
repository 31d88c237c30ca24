import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { llmsTxt } from '../../scripts/lib/llms-txt.mjs';

const text = readFileSync('llms.txt', 'utf8');

test('llms.txt is what the pages make (node scripts/llms-txt.mjs)', () => {
  expect(llmsTxt()).toBe(text);
});

test('it has a title, a summary, and a line with a sentence for each page', () => {
  expect(text).toMatch(/^# Principia\n\n> \S.{100,}\n\n## /);
  const lines = [...text.matchAll(/^- \[(.+)\]\((.+)\): (.+)$/gm)];
  for (const [, title, path, sentence] of lines) {
    expect(title.length, path).toBeGreaterThan(3);
    expect(sentence.length, path).toBeGreaterThan(20);
    expect(existsSync(path), path).toBe(true);
  }
  const pages = readdirSync('docs').filter((name) => name.endsWith('.md'));
  for (const page of pages) expect(lines.filter(([, , path]) => path === `docs/${page}`)).toHaveLength(1);
});

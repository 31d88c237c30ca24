/** The search for examples. */
import type { ExampleEntry } from '@principia/scenes/examples/list';
import { chapterTitle } from './chapters.ts';

/** A chapter by its number, in any language of the page. */
const CHAPTER = /\b(?:chapter|kapitel)\s+(\d+)\b/g;

/**
 * Whether a search finds an example: every word must occur in its title, chapter, tags, text or id, and a chapter with its
 * number must be its own.
 */
export function isFound({ id, title, chapter, tags, about }: ExampleEntry, search: string): boolean {
  const wanted = search.toLowerCase();
  const chapters = [...wanted.matchAll(CHAPTER)].map(([, number]) => Number(number));
  if (chapters.some((number) => number !== chapter)) return false;
  const text = [id, title, `chapter ${chapter}`, chapterTitle(chapter), ...tags, about].join(' ').toLowerCase();
  return wanted
    .replace(CHAPTER, '')
    .split(/\s+/)
    .every((word) => text.includes(word));
}

import { WORDS } from './words.ts';

/** Number and subject of a chapter. */
export function chapterTitle(chapter: number): string {
  const subject = (WORDS.chapters as Readonly<Record<number, string>>)[chapter];
  const title = WORDS.chapter(chapter);
  return subject === undefined ? title : `${title} · ${subject}`;
}

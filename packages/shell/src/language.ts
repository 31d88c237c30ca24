/** The language of the page, and how it writes numbers. */

export const LANGUAGES = ['en', 'de'] as const;
/** A language that the shell has words in. */
export type Language = (typeof LANGUAGES)[number];

/** English until a page says that it has its words in all languages: no page mixes two. */
let spoken = 'en';
/** What stands before the decimals. */
let sign = '.';

/** The language of the page, such as `de`. */
export const language = (): string => spoken;

/** Changes the language of the page, of `<html lang>` and of numbers. */
export function speak(name: string): void {
  spoken = name;
  const parts = new Intl.NumberFormat(name, { numberingSystem: 'latn' }).formatToParts(0.5);
  sign = parts.find(({ type }) => type === 'decimal')?.value ?? '.';
  // A worker has none.
  if (typeof document !== 'undefined') document.documentElement.lang = name;
}

/**
 * The language that a reader wants: that of `?lang=`, else the first known one of the browser's, else English.
 * @param query as in `location.search` @param wishes as in `navigator.languages` @param known languages, such as `de`
 */
export function preferredLanguage(query: string, wishes: readonly string[], known: readonly string[]): string {
  const asked = new URLSearchParams(query).get('lang') ?? '';
  return (
    [asked, ...wishes].map((wish) => wish.toLowerCase().split('-')[0]).find((wish) => known.includes(wish)) ?? 'en'
  );
}

/** An address with the language that this page was asked for by its own, such as `../index.html?lang=de`. */
export function withLanguage(address: string): string {
  const asked = new URLSearchParams(globalThis.location?.search).get('lang');
  const [page, ...hash] = address.split('#');
  if (asked === null || /[?&]lang=/.test(page)) return address;
  return [`${page}${page.includes('?') ? '&' : '?'}lang=${encodeURIComponent(asked)}`, ...hash].join('#');
}

/** A number with a fixed number of decimals, and no sign if all are zero. Short enough to be made in every frame. */
export function decimal(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return inLanguage(Number(text) === 0 ? text.replace('-', '') : text);
}

/** A number as JavaScript writes it, with the decimal sign of the language. */
export function inLanguage(number: string): string {
  return sign === '.' ? number : number.replace('.', sign);
}

/** Formats with separators between thousands, by language. */
const GROUPED = new Map<string, Intl.NumberFormat>();

/** A whole number with separators between thousands. */
export function grouped(value: number): string {
  let format = GROUPED.get(spoken);
  if (format === undefined) {
    format = new Intl.NumberFormat(spoken, { useGrouping: true });
    GROUPED.set(spoken, format);
  }
  return format.format(value);
}

/** The language of the page, and how it writes numbers. */

export const LANGUAGES = ['en', 'de'] as const;
/** A language of the shell. */
export type Language = (typeof LANGUAGES)[number];

/** English until a page says that it has its words in all languages: no page mixes two. */
let spoken: Language = 'en';

/** The language of the page. */
export const language = (): Language => spoken;

/**
 * The language that a reader wants: that of `?lang=`, else the first known one of the browser's, else English.
 * @param query as in `location.search` @param wishes as in `navigator.languages`
 */
export function preferredLanguage(query: string, wishes: readonly string[]): Language {
  const asked = new URLSearchParams(query).get('lang') ?? '';
  const known = [asked, ...wishes].map((wish) => wish.toLowerCase().split('-')[0]);
  return (known.find((wish) => (LANGUAGES as readonly string[]).includes(wish)) as Language | undefined) ?? 'en';
}

/**
 * Chooses the words of a game, and with them the language of its page: of the buttons around it, of `<html lang>` and of
 * numbers. Call it once, where the words stand.
 */
export function chooseWords<Words>(texts: Readonly<Record<Language, Words>>): Words {
  // A worker has no document, but an address.
  if (typeof location !== 'undefined') spoken = preferredLanguage(location.search, navigator.languages ?? []);
  if (typeof document !== 'undefined') document.documentElement.lang = spoken;
  return texts[spoken];
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
  return spoken === 'en' ? number : number.replace('.', ',');
}

/** Formats with separators between thousands, by language. */
const GROUPED = new Map<Language, Intl.NumberFormat>();

/** A whole number with separators between thousands. */
export function grouped(value: number): string {
  let format = GROUPED.get(spoken);
  if (format === undefined) {
    format = new Intl.NumberFormat(spoken, { useGrouping: true });
    GROUPED.set(spoken, format);
  }
  return format.format(value);
}

/** Compares the words of a language with the English ones. */

type Text = string | readonly string[] | ((...given: never[]) => string) | { readonly [name: string]: Text };

/** A value that no text has by itself, for the `index`-th placeholder: a number, which every text can take. */
const MARK = (index: number) => 70_001 + index;

/** Sentences about keys that only one has, and about placeholders that only one shows. */
export function wordProblems(english: Text, other: Text, path = ''): string[] {
  if (typeof english === 'function' && typeof other === 'function') {
    if (english.length < other.length) return [`${path} takes ${other.length} values, but there are ${english.length}`];
    const given = Array.from({ length: english.length }, (_, i) => MARK(i)) as never[];
    const [shown, wanted] = [other(...given), english(...given)];
    const differs = (mark: number) => wanted.includes(String(mark)) !== shown.includes(String(mark));
    return given.filter(differs).map((mark) => `${path} lacks ${mark}`);
  }
  if (typeof english === 'object' && typeof other === 'object') {
    const [wanted, given] = [english, other] as Record<string, Text>[];
    const names = new Set([...Object.keys(wanted), ...Object.keys(given)]);
    return [...names].flatMap((name) => {
      const at = path === '' ? name : `${path}.${name}`;
      if (!(name in wanted) || !(name in given)) return [`only one language has ${at}`];
      return wordProblems(wanted[name], given[name], at);
    });
  }
  if (typeof english !== typeof other) return [`${path} is of another type`];
  return other === '' && english !== '' ? [`${path} is empty`] : [];
}

/** All texts without placeholders, by their path. */
export function textsOf(words: Text, path = ''): [path: string, text: string][] {
  if (typeof words === 'string') return [[path, words]];
  if (typeof words === 'function') return [];
  return Object.entries(words as Record<string, Text>).flatMap(([name, text]) => textsOf(text, `${path}.${name}`));
}

/** The list of all examples: by chapter, with a search. */

import { EXAMPLES, type ExampleEntry } from '@principia/scenes/examples/list';
import { element, withLanguage } from '@principia/shell';
import { chapterTitle } from './chapters.ts';
import { isFound } from './search.ts';
import { addStartStyles } from './start-styles.ts';
import { WORDS } from './words.ts';

/** Examples to begin with, of all that the framework can do. */
const STRIKING = [
  'ch17-figure-eight',
  'ch17-galaxy-collision',
  'ch17-double-pendulums',
  'ch13-cloth',
  'ch15-wing-nut',
  'ch17-magnetic-pendulum',
];

/** @param search words to begin with @param unknown example that was asked for and does not exist; null for none */
export function showStartPage(parent: HTMLElement, search: string, unknown: string | null): void {
  document.title = WORDS.title;
  const words = WORDS.list;
  addStartStyles();
  const field = element('input', '', {
    type: 'search',
    placeholder: words.searchHint,
    'aria-label': words.search,
    value: search,
  });
  const count = element('p', 'start-count', { role: 'status' });
  const list = element('div', '');
  const tags = element('div', 'start-tags', { role: 'group', 'aria-label': words.subjects });
  let pictures: Readonly<Record<string, string>> = {};
  const show = () => {
    const found = EXAMPLES.filter((entry) => isFound(entry, field.value));
    for (const button of tags.children) button.setAttribute('aria-pressed', String(button.textContent === field.value));
    count.textContent = found.length === 0 ? words.nothing : words.count(found.length);
    list.replaceChildren(...(field.value === '' ? [striking(pictures)] : []), ...chapters(found, pictures));
    const query = field.value === '' ? location.pathname : `?search=${encodeURIComponent(field.value)}`;
    history.replaceState(null, '', withLanguage(query));
  };
  for (const tag of commonTags()) {
    const button = element('button', '', { type: 'button', lang: 'en' }, tag);
    button.addEventListener('click', () => {
      field.value = field.value === tag ? '' : tag;
      show();
    });
    tags.append(button);
  }
  // The pictures come later than the list, which is useful without them.
  void import('./pictures.gen.ts').then(({ PICTURES }) => {
    pictures = PICTURES;
    show();
  });
  field.addEventListener('input', show);
  document.addEventListener('keydown', (event) => {
    if (event.key !== '/' || event.target === field) return;
    event.preventDefault();
    field.focus();
  });
  const note = element('p', 'start-problem', { role: 'alert' }, unknown === null ? '' : words.unknown(unknown));
  note.hidden = unknown === null;
  parent.append(
    element(
      'main',
      'start',
      {},
      element('a', 'start-home', { href: withLanguage('../index.html') }, words.home),
      element('h1', '', {}, WORDS.title),
      element('p', '', {}, words.lead),
      note,
      element('p', '', {}, element('a', 'start-new', { href: withLanguage('?example=new&code=on') }, words.new)),
      field,
      tags,
      count,
      list,
    ),
  );
  show();
}

/** The tags that most examples have. */
function commonTags(): string[] {
  const counts = new Map<string, number>();
  for (const tag of EXAMPLES.flatMap(({ tags }) => tags)) counts.set(tag, (counts.get(tag) ?? 0) + 1);
  const list = [...counts].sort(([a, m], [b, n]) => n - m || (a < b ? -1 : 1));
  return list.slice(0, 24).map(([tag]) => tag);
}

function striking(pictures: Readonly<Record<string, string>>): HTMLElement {
  const entries = STRIKING.flatMap((id) => EXAMPLES.filter((entry) => entry.id === id));
  return section(WORDS.list.begin, entries, pictures, 'start-striking');
}

function chapters(entries: readonly ExampleEntry[], pictures: Readonly<Record<string, string>>): HTMLElement[] {
  const numbers = [...new Set(entries.map(({ chapter }) => chapter))];
  return numbers.map((number) => {
    const own = entries.filter(({ chapter }) => chapter === number);
    return section(chapterTitle(number), own, pictures);
  });
}

function section(
  title: string,
  entries: readonly ExampleEntry[],
  pictures: Readonly<Record<string, string>>,
  name = '',
): HTMLElement {
  const list = element('ul', '');
  list.append(...entries.map((entry) => item(entry, pictures[entry.id] ?? '')));
  return element('section', name, {}, element('h2', '', {}, title), list);
}

function item({ id, title, tags }: ExampleEntry, picture: string): HTMLElement {
  const frame = element('div', 'start-picture', { 'aria-hidden': 'true' });
  frame.innerHTML = picture;
  const text = [element('b', '', { lang: 'en' }, title), element('span', '', { lang: 'en' }, tags.join(' · '))];
  return element('li', '', {}, element('a', '', { href: withLanguage(`?example=${id}`) }, frame, ...text));
}

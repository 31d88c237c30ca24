/** The list of all examples: by chapter, with a search. */
import { EXAMPLES, type ExampleEntry } from '@principia/scenes/examples/list';
import { chapterTitle } from './chapters.ts';
import { make } from './make.ts';
import { addStartStyles } from './start-styles.ts';

/** @param search words to begin with @param problem a sentence above the list; empty for none */
export function showStartPage(parent: HTMLElement, search: string, problem: string): void {
  addStartStyles();
  const field = make('input', '', {
    type: 'search',
    placeholder: 'Search: orbit, drag, chapter 8 …',
    'aria-label': 'Search',
    value: search,
  });
  const count = make('p', 'start-count', { role: 'status' });
  const list = make('div', '');
  const tags = make('div', 'start-tags', { role: 'group', 'aria-label': 'Subjects' });
  let pictures: Readonly<Record<string, string>> = {};
  const show = () => {
    const found = EXAMPLES.filter((entry) => matches(entry, field.value));
    for (const button of tags.children) button.setAttribute('aria-pressed', String(button.textContent === field.value));
    count.textContent = found.length === 1 ? '1 example' : `${found.length} examples`;
    list.replaceChildren(...chapters(found, pictures));
    const query = field.value === '' ? location.pathname : `?search=${encodeURIComponent(field.value)}`;
    history.replaceState(null, '', query);
  };
  for (const tag of commonTags()) {
    const button = make('button', '', { type: 'button' }, tag);
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
  const note = make('p', 'start-problem', { role: 'alert' }, problem);
  note.hidden = problem === '';
  const about = 'Every example of a physics book: play with it, and watch its figures being proven.';
  parent.append(
    make(
      'main',
      'start',
      {},
      make('a', 'start-home', { href: '../index.html' }, 'All games'),
      make('h1', '', {}, 'The laboratory'),
      make('p', '', {}, about),
      note,
      field,
      tags,
      count,
      list,
    ),
  );
  show();
}

/** Every word of the search must occur in the title, the chapter, the tags, the text or the id. */
function matches({ id, title, chapter, tags, about }: ExampleEntry, search: string): boolean {
  const text = [id, title, chapterTitle(chapter), ...tags, about].join(' ').toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

/** The tags that most examples have. */
function commonTags(): string[] {
  const counts = new Map<string, number>();
  for (const tag of EXAMPLES.flatMap(({ tags }) => tags)) counts.set(tag, (counts.get(tag) ?? 0) + 1);
  const list = [...counts].sort(([a, m], [b, n]) => n - m || (a < b ? -1 : 1));
  return list.slice(0, 24).map(([tag]) => tag);
}

function chapters(entries: readonly ExampleEntry[], pictures: Readonly<Record<string, string>>): HTMLElement[] {
  const numbers = [...new Set(entries.map(({ chapter }) => chapter))];
  return numbers.map((number) => {
    const items = entries
      .filter(({ chapter }) => chapter === number)
      .map((entry) => item(entry, pictures[entry.id] ?? ''));
    const list = make('ul', '');
    list.append(...items);
    return make('section', '', {}, make('h2', '', {}, chapterTitle(number)), list);
  });
}

function item({ id, title, tags }: ExampleEntry, picture: string): HTMLElement {
  const frame = make('div', 'start-picture', { 'aria-hidden': 'true' });
  frame.innerHTML = picture;
  const text = [make('b', '', {}, title), make('span', '', {}, tags.join(' · '))];
  return make('li', '', {}, make('a', '', { href: `?example=${id}` }, frame, ...text));
}

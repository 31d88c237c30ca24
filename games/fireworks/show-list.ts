/** A button that opens a list of shows; a tap plays one from its beginning and puts it on the timeline. */
import { element, type ViewContext } from '@principia/shell';
import type { PlayerControls } from './controls.ts';
import { GALLERY, type GalleryShow, secondsOf } from './gallery.ts';
import type { Settings } from './settings.ts';
import type { FireworksGame } from './sim.ts';
import { WORDS } from './words.ts';

export interface ShowList {
  readonly elements: readonly HTMLElement[];
  /** Fits the open list above the desk, which grows with the timeline; call it a few times a second. */
  update(): void;
  destroy(): void;
}

/** Distance from the desk, and the height below which the list rather covers the desk, CSS pixels. */
const [MARGIN, MIN_HEIGHT] = [8, 110];
/** Keys that move the focus in the list, and by how many entries. */
const WAYS: Readonly<Record<string, number>> = { ArrowUp: -1, ArrowDown: 1 };

/** @param desk controls below the list */
export function createShowList(
  context: ViewContext<Settings, FireworksGame>,
  controls: PlayerControls,
  desk: HTMLElement,
): ShowList {
  const open = element('button', 'fw-extra', { type: 'button', 'aria-expanded': 'false' }, WORDS.shows);
  open.title = WORDS.showsHint;
  const list = element('div', 'fw-gallery', { role: 'group', 'aria-label': WORDS.showsHint, hidden: '' });
  const update = () => {
    if (list.hidden) return;
    const height = desk.getBoundingClientRect().top - list.getBoundingClientRect().top - MARGIN;
    list.style.maxHeight = `${Math.max(MIN_HEIGHT, height)}px`;
  };
  const show = (isOpen: boolean) => {
    list.hidden = !isOpen;
    open.setAttribute('aria-expanded', String(isOpen));
    update();
  };
  const entries = GALLERY.map((entry) => createEntry(entry));
  for (const [i, entry] of entries.entries()) {
    entry.addEventListener('click', ({ detail }) => {
      controls.load(context.sim(), GALLERY[i].cues);
      show(false);
      // After a click by pointer, whose detail is not 0, the space bar is to pause.
      if (detail === 0) open.focus();
    });
  }
  list.append(...entries);
  open.addEventListener('click', () => {
    show(list.hidden !== false);
    if (!list.hidden) entries[0].focus();
  });
  listenToListKeys(open, list, entries);
  const pressEscape = ({ key, target }: KeyboardEvent) => {
    if (key !== 'Escape' || list.hidden || (target as Element).closest('dialog')) return;
    show(false);
    open.focus();
  };
  const pressOutside = ({ target }: PointerEvent) => {
    if (!list.contains(target as Node) && !open.contains(target as Node)) show(false);
  };
  document.addEventListener('keydown', pressEscape);
  document.addEventListener('pointerdown', pressOutside);
  return {
    elements: [open, list],
    update,
    destroy() {
      document.removeEventListener('keydown', pressEscape);
      document.removeEventListener('pointerdown', pressOutside);
    },
  };
}

/** Arrow keys and Enter aim and fire elsewhere; here they move the focus and choose. */
function listenToListKeys(open: HTMLElement, list: HTMLElement, entries: readonly HTMLElement[]): void {
  open.addEventListener('keydown', (event) => event.key === 'Enter' && event.stopPropagation());
  list.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') event.stopPropagation();
    if (!Object.hasOwn(WAYS, event.key)) return;
    event.stopPropagation();
    event.preventDefault();
    const at = entries.indexOf(document.activeElement as HTMLElement) + WAYS[event.key];
    entries[(at + entries.length) % entries.length].focus();
  });
}

function createEntry({ name, cues }: GalleryShow): HTMLButtonElement {
  const [title, character] = WORDS.gallery[name];
  const seconds = WORDS.seconds(Math.round(secondsOf(cues)));
  return element(
    'button',
    '',
    { type: 'button', 'data-show': name },
    element('b', '', {}, title),
    element('i', '', {}, seconds),
    element('span', '', {}, character),
  );
}

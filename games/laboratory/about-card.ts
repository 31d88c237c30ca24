import type { Example, ExampleRun } from '@principia/scenes/examples';
import { EXAMPLES } from '@principia/scenes/examples/list';
import { copyLink, element, type GameCard, withLanguage } from '@principia/shell';
import { keyName } from './key-name.ts';
import { isNameable, momentAddress } from './moment.ts';
import { actOn, presentRun } from './on-display.ts';
import { WORDS } from './words.ts';

/** Time that a sentence stays, ms. */
const SAID_MS = 5000;

/** What the example is about, what to try, and the ways to its neighbours; it stands above the settings. */
export function createAboutCard(parent: HTMLElement, example: Example): GameCard<ExampleRun> {
  const at = EXAMPLES.findIndex(({ id }) => id === example.id);
  const neighbours = element('nav', 'lab-neighbours', { 'aria-label': WORDS.otherExamples });
  for (const [entry, label] of [
    [EXAMPLES[at - 1], '‹'],
    [EXAMPLES[at + 1], '›'],
  ] as const) {
    if (entry !== undefined) {
      neighbours.append(
        element(
          'a',
          '',
          { href: withLanguage(`?example=${entry.id}`), title: entry.title, lang: 'en' },
          `${label} ${entry.title}`,
        ),
      );
    }
  }
  const tries = element('ul', '');
  tries.append(...example.tryThis.map((sentence) => element('li', '', { lang: 'en' }, sentence)));
  const about = element('p', '', { lang: 'en' }, example.about);
  const title = element('b', '', { lang: 'en' }, example.title);
  const heading = element('h2', '', {}, `${WORDS.chapter(example.chapter)} · `, title);
  const card = element('section', 'game-card lab-about', { 'aria-label': WORDS.about }, heading, about);
  card.append(
    element('h2', '', {}, WORDS.tryThis),
    tries,
    ...actionsOf(example),
    ...pointerOf(example),
    ...buttonsOf(example),
    neighbours,
  );
  parent.prepend(card);
  return { show() {} };
}

/** A button for each action, which its key does as well. */
function actionsOf({ actions }: Example): HTMLElement[] {
  const entries = Object.entries(actions);
  if (entries.length === 0) return [];
  const row = element('div', 'lab-presets', { role: 'group', 'aria-label': WORDS.actions });
  for (const [name, { about, key }] of entries) {
    const text = element('span', '', { lang: 'en' }, ` ${about}`);
    const button = element('button', '', { type: 'button' }, element('kbd', '', {}, keyName(key)), text);
    const act = (isDown: boolean) => actOn(presentRun(), name, isDown);
    button.addEventListener('pointerdown', (event) => {
      button.setPointerCapture(event.pointerId);
      act(true);
    });
    for (const type of ['pointerup', 'pointercancel'] as const) button.addEventListener(type, () => act(false));
    // A click without a pointer comes from the keyboard.
    button.addEventListener('click', (event) => {
      if (event.detail !== 0) return;
      act(true);
      act(false);
    });
    row.append(button);
  }
  return [row];
}

/** What a press on the picture does. */
function pointerOf({ pointer }: Example): HTMLElement[] {
  if (pointer === undefined) return [];
  return [element('p', 'lab-pointer', {}, `${WORDS.press}: `, element('span', '', { lang: 'en' }, pointer.about))];
}

/** Presets, and the address of the present moment. */
function buttonsOf({ id, presets, parameters }: Example): HTMLElement[] {
  const row = element('div', 'lab-presets');
  for (const { label, values } of presets) {
    const query = new URLSearchParams({ example: id });
    for (const [name, value] of Object.entries(values)) query.set(name, String(value));
    row.append(element('a', '', { href: withLanguage(`?${query}`), lang: 'en' }, label));
  }
  if (parameters.count?.integer) row.append(doubleButton(parameters.count.max));
  const copy = element('button', '', { type: 'button', title: WORDS.copyMoment }, WORDS.copyLink);
  const said = element('p', 'lab-said', { role: 'status' });
  copy.addEventListener('click', async () => {
    said.textContent = await copyLink(momentAddress(), isNameable() ? WORDS.thisMoment : WORDS.startOfThis);
    setTimeout(() => said.replaceChildren(), SAID_MS);
  });
  row.append(copy);
  return [row, said];
}

/** Doubles the number of bodies, until the machine or the example has enough. */
function doubleButton(max: number): HTMLElement {
  const button = element('button', '', { type: 'button', title: WORDS.doubleHint }, WORDS.double);
  button.addEventListener('click', () => {
    const now = Number(__game.state().values.count);
    __game.set('count', Math.min(max, 2 * now));
  });
  return button;
}

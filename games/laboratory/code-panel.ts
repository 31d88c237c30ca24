/** The source of an example beside its picture: to read, to change and to run. */

import { copyLink, element } from '@principia/shell';
import { announceCover } from './covers.ts';
import { NEW, NEW_SOURCE } from './new-example.ts';
import { forgetOwnCode, keepOwnCode, type LinkedCode, linkWith, ownCode } from './own-code.ts';
import { CodeError } from './run-code.ts';
import { SOURCES } from './sources.gen.ts';
import { tryCode } from './try-code.ts';
import { WORDS } from './words.ts';

const { code: words } = WORDS;

export interface CodePanel {
  show(isShown: boolean): void;
}

/**
 * @param linked a version that the address carries, which the reader has not agreed to run yet
 * @param close called when the reader is done
 */
export async function createCodePanel(
  parent: HTMLElement,
  id: string,
  linked: LinkedCode | undefined,
  close: () => void,
): Promise<CodePanel> {
  const original = id === NEW ? NEW_SOURCE : await SOURCES[id]();
  const text = element('textarea', '', {
    'aria-label': words.source,
    spellcheck: 'false',
    autocomplete: 'off',
    autocapitalize: 'off',
    wrap: 'off',
  });
  text.value = linked?.source ?? ownCode(id) ?? original;
  const note = element('p', 'lab-code-note', { role: 'status' });
  const file = id === NEW ? words.own : `packages/scenes/src/examples/${id.replace('-', '/')}.ts`;
  note.textContent = linked === undefined ? file : words.linked;
  const buttons = element('div', 'lab-code-buttons');
  const panel = element(
    'section',
    'lab-code',
    { 'aria-label': words.panel, 'data-covers': 'bottom' },
    text,
    note,
    buttons,
  );
  const add = (label: string, title: string, act: () => unknown) => {
    const button = element('button', '', { type: 'button', title }, label);
    button.addEventListener('click', () => void act());
    buttons.append(button);
  };
  const report = (message: string, line?: number) => {
    note.textContent = line === undefined ? message : words.line(line, message);
    if (line !== undefined) selectLine(text, line);
  };
  const runText = () => run(id, text.value, linked, report);
  add(words.run, words.runHint, runText);
  add(words.original, words.originalHint, () => {
    forgetOwnCode(id);
    history.replaceState(null, '', location.pathname + location.search);
    location.reload();
  });
  add(WORDS.copyLink, words.copyHint, async () => {
    report(await copyLink(await linkWith(text.value), words.thisVersion));
  });
  add(words.close, words.closeHint, close);
  text.addEventListener('keydown', (event) => {
    if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) void runText();
  });
  panel.hidden = true;
  parent.append(panel);
  return {
    show(isShown) {
      panel.hidden = !isShown;
      announceCover();
    },
  };
}

/** Tries the code where it can do no harm; the page is then opened anew with it, because its parameters may differ. */
async function run(
  id: string,
  source: string,
  linked: LinkedCode | undefined,
  report: (message: string, line?: number) => void,
): Promise<void> {
  report(words.trying);
  try {
    await tryCode(source);
    keepOwnCode(id, source);
    // The moment that a link names is one of the version that it brings.
    const moment = source === linked?.source && linked.moment !== '' ? `&${linked.moment}` : '';
    history.replaceState(null, '', location.pathname + location.search + moment);
    location.reload();
  } catch (error) {
    const { message } = error as Error;
    report(message, error instanceof CodeError ? error.line : undefined);
  }
}

function selectLine(text: HTMLTextAreaElement, line: number): void {
  const lines = text.value.split('\n');
  const start = lines.slice(0, line - 1).reduce((sum, { length }) => sum + length + 1, 0);
  text.focus();
  text.setSelectionRange(start, start + (lines[line - 1]?.length ?? 0));
  const lineHeight = Number.parseFloat(getComputedStyle(text).lineHeight);
  text.scrollTop = Math.max(0, (line - 4) * lineHeight);
}

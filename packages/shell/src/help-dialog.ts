import { element } from './element.ts';
import { words } from './words.ts';

/** The dialog that lists keys and gestures. */
export interface HelpDialog {
  toggle(): void;
}

/** @param lines pairs of keys or gestures and their descriptions */
export function createHelpDialog(
  parent: HTMLElement,
  title: string,
  lines: readonly (readonly [string, string])[],
): HelpDialog {
  const list = element('dl', '');
  for (const [keys, text] of lines) list.append(element('dt', '', {}, keys), element('dd', '', {}, text));
  const close = element('button', '', { type: 'button' }, words().close);
  // The title has the focus so that the dialog opens scrolled to its top; Tab moves on to the button.
  const heading = element('h2', '', { tabindex: '-1', autofocus: '' }, title);
  const dialog = element(
    'dialog',
    'game-help',
    { 'aria-label': words().help },
    heading,
    list,
    element('footer', '', {}, close),
  );
  parent.append(dialog);
  const toggle = () => (dialog.open ? dialog.close() : dialog.showModal());
  close.addEventListener('click', toggle);
  dialog.addEventListener('click', (event) => event.target === dialog && dialog.close());
  dialog.addEventListener('keydown', (event) => {
    if (event.key.toLowerCase() === 'h' || event.key === '?') dialog.close();
  });
  return { toggle };
}

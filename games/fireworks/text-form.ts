/** A field for a name or an emoji that stars write into the sky: the button launches it, and so does a press in the sky. */
import { element, type ViewContext } from '@principia/shell';
import type { PlayerControls } from './controls.ts';
import type { Settings } from './settings.ts';
import type { FireworksGame } from './sim.ts';
import { MAX_CHARACTERS } from './text-points.ts';
import { WORDS } from './words.ts';

/** Where the button launches to, m. */
const MIDDLE = { x: 0, y: 36, z: 0 };

/** @returns the button that opens the field, and the field */
export function createTextForm(context: ViewContext<Settings, FireworksGame>, controls: PlayerControls): HTMLElement[] {
  const open = element('button', 'fw-extra', { type: 'button', 'aria-expanded': 'false' }, WORDS.write);
  open.title = WORDS.writeHint;
  const input = element('input', '', {
    type: 'text',
    'aria-label': WORDS.nameOrEmoji,
    placeholder: WORDS.nameOrEmoji,
    enterkeyhint: 'go',
    autocomplete: 'off',
    // An emoji takes several units of text.
    maxlength: String(4 * MAX_CHARACTERS),
  });
  const launch = element('button', 'fw-extra', { type: 'submit' }, WORDS.launchText);
  const form = element('form', 'fw-text', { hidden: '' }, input, launch);
  const show = (isOpen: boolean) => {
    form.hidden = !isOpen;
    open.setAttribute('aria-expanded', String(isOpen));
    controls.text = isOpen ? input.value : '';
    if (isOpen) input.focus();
    else open.focus();
  };
  open.addEventListener('click', () => show(form.hidden !== false));
  input.addEventListener('input', () => {
    controls.text = input.value;
  });
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') show(false);
  });
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    controls.write(context.sim(), MIDDLE);
  });
  return [open, form];
}

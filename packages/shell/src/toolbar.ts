import type { Actions } from './commands.ts';
import { element } from './element.ts';
import { withLanguage } from './language.ts';
import { words } from './words.ts';

/** The state that the toolbar shows. */
export interface ToolbarState {
  readonly paused: boolean;
  readonly slow: boolean;
  readonly rewinding: boolean;
  readonly renderer: string;
}

/** The buttons beside the title. */
export interface Toolbar {
  show(state: ToolbarState): void;
}

const ICONS = {
  rewind: 'M11.5 4v16L2 12zM21.5 4v16L12 12z',
  pause: 'M6 4h4v16H6zM14 4h4v16h-4z',
  play: 'M7 4l13 8-13 8z',
  step: 'M5 4l10 8-10 8zM16 4h3v16h-3z',
  slow: 'M12 3a9 9 0 1 0 9 9h-2.6a6.4 6.4 0 1 1-6.4-6.4zM11 7h2.4v4.2l3.4 2.2-1.3 2L11 12.6z',
  reset: 'M12 5V1L6 6.5 12 12V8a5.5 5.5 0 1 1-5.5 5.5h-3A8.5 8.5 0 1 0 12 5z',
  fit: 'M11 2h2v4h-2zM11 18h2v4h-2zM2 11h4v2H2zM18 11h4v2h-4zM12 7.6a4.4 4.4 0 1 0 0 8.8 4.4 4.4 0 0 0 0-8.8zM12 10a2 2 0 1 1 0 4 2 2 0 0 1 0-4z',
  home: 'M12 3 2.5 11H5v9.5h5.5V14h3v6.5H19V11h2.5z',
  panel: 'M3 5h10v2.4H3zM17 5h4v2.4h-4zM13 3h4v6.4h-4zM3 16.6h4V19H3zM11 16.6h10V19H11zM7 14.6h4V21H7z',
} as const;

/**
 * @param renderers pairs of name and label; a single renderer has no switch
 * @param home address of the page with all games, if there is one
 */
export function createToolbar(
  bar: HTMLElement,
  actions: Actions,
  renderers: readonly (readonly [string, string])[],
  home?: string,
): Toolbar {
  if (home !== undefined) bar.prepend(homeLink(withLanguage(home)));
  const pause = iconButton('pause', words().pause, actions.pause);
  const rewind = holdButton(actions);
  const slow = iconButton('slow', words().slow, actions.slow);
  const fit = iconButton('fit', words().fit, actions.fit);
  const step = iconButton('step', words().step, actions.step);
  // Narrow windows hide the buttons whose function a key or the panel has too.
  for (const button of [fit, step, slow]) button.dataset.minor = '';
  bar.append(rewind, pause, step, slow, iconButton('reset', words().reset, actions.reset), fit);
  const switches = renderers.map(([name, label]) => {
    const button = element(
      'button',
      '',
      { type: 'button', title: words().drawIn(label), 'data-renderer': name },
      label,
    );
    button.addEventListener('click', () => actions.renderer(name));
    if (renderers.length > 1) bar.append(button);
    return { name, button };
  });
  const help = element('button', '', { type: 'button', title: `${words().help} (H)`, 'aria-label': words().help }, '?');
  help.addEventListener('click', actions.help);
  bar.append(iconButton('panel', words().settingsButton, actions.sidebar), help);
  return {
    show({ paused, slow: isSlow, rewinding, renderer }) {
      setIcon(pause, paused ? 'play' : 'pause', paused ? words().resume : words().pause);
      slow.setAttribute('aria-pressed', String(isSlow));
      rewind.setAttribute('aria-pressed', String(rewinding));
      for (const { name, button } of switches) button.setAttribute('aria-pressed', String(name === renderer));
    },
  };
}

function homeLink(address: string): HTMLAnchorElement {
  const link = element('a', '', { href: address, title: words().allGames, 'aria-label': words().allGames });
  link.innerHTML = svg('home');
  return link;
}

/** Rewinds while it is held down; activated by keyboard, it steps back once. */
function holdButton({ rewind, stepBack }: Actions): HTMLButtonElement {
  const button = iconButton('rewind', words().rewind, (event) => event.detail === 0 && stepBack());
  button.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    button.setPointerCapture(event.pointerId);
    rewind(true);
  });
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
    button.addEventListener(type, () => rewind(false));
  }
  button.addEventListener('contextmenu', (event) => event.preventDefault());
  return button;
}

function iconButton(
  icon: keyof typeof ICONS,
  title: string,
  action: (event: MouseEvent) => unknown,
): HTMLButtonElement {
  const button = element('button', '', { type: 'button' });
  setIcon(button, icon, title);
  button.addEventListener('click', action);
  return button;
}

function setIcon(button: HTMLButtonElement, icon: keyof typeof ICONS, title: string): void {
  if (button.title === title) return;
  button.title = title;
  button.setAttribute('aria-label', title);
  button.innerHTML = svg(icon);
}

function svg(icon: keyof typeof ICONS): string {
  return `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${ICONS[icon]}"/></svg>`;
}

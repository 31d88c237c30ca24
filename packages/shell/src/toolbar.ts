import { element } from './element.ts';

/** What the buttons of the bar do. */
export interface ToolbarActions {
  pause(): void;
  step(): void;
  reset(): void;
  fit(): void;
  help(): void;
  side(): void;
  renderer(name: string): void;
}

/** The buttons beside the title. */
export interface Toolbar {
  show(state: { paused: boolean; renderer: string }): void;
}

const ICONS = {
  pause: 'M6 4h4v16H6zM14 4h4v16h-4z',
  play: 'M7 4l13 8-13 8z',
  step: 'M5 4l10 8-10 8zM16 4h3v16h-3z',
  reset: 'M12 5V1L6 6.5 12 12V8a5.5 5.5 0 1 1-5.5 5.5h-3A8.5 8.5 0 1 0 12 5z',
  fit: 'M3 3h7v3H6v4H3zM14 3h7v7h-3V6h-4zM3 14h3v4h4v3H3zM18 14h3v7h-7v-3h4z',
  panel: 'M3 5h10v2.4H3zM17 5h4v2.4h-4zM13 3h4v6.4h-4zM3 16.6h4V19H3zM11 16.6h10V19H11zM7 14.6h4V21H7z',
} as const;

/** @param renderers names of the renderers and what the switch calls them; no switch for a single one */
export function createToolbar(
  bar: HTMLElement,
  actions: ToolbarActions,
  renderers: readonly (readonly [string, string])[],
): Toolbar {
  const pause = iconButton('pause', 'Pause (Space)', actions.pause);
  bar.append(
    pause,
    iconButton('step', 'One step (.)', actions.step),
    iconButton('reset', 'Start again (R)', actions.reset),
    iconButton('fit', 'See everything (F)', actions.fit),
  );
  const switches = renderers.map(([name, label]) => {
    const button = element('button', '', { type: 'button', title: `Draw in ${label} (${label[0]})` }, label);
    button.addEventListener('click', () => actions.renderer(name));
    if (renderers.length > 1) bar.append(button);
    return { name, button };
  });
  const help = element('button', '', { type: 'button', title: 'Help (H)', 'aria-label': 'Help' }, '?');
  help.addEventListener('click', actions.help);
  bar.append(iconButton('panel', 'Panel (P)', actions.side), help);
  return {
    show({ paused, renderer }) {
      setIcon(pause, paused ? 'play' : 'pause', paused ? 'Go on (Space)' : 'Pause (Space)');
      for (const { name, button } of switches) button.setAttribute('aria-pressed', String(name === renderer));
    },
  };
}

function iconButton(icon: keyof typeof ICONS, title: string, action: () => void): HTMLButtonElement {
  const button = element('button', '', { type: 'button' });
  setIcon(button, icon, title);
  button.addEventListener('click', action);
  return button;
}

function setIcon(button: HTMLButtonElement, icon: keyof typeof ICONS, title: string): void {
  if (button.title === title) return;
  button.title = title;
  button.setAttribute('aria-label', title);
  button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${ICONS[icon]}"/></svg>`;
}

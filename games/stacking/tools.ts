/** The palette: what a pointer does on the stage. */
import { WORDS } from './words.ts';

export type Tool = keyof typeof WORDS.tool;

const ICONS: Readonly<Record<Tool, string>> = { drag: '↔', hinge: '○', motor: '↻', weld: '✚', cut: '✂' };

export interface Palette {
  readonly tool: Tool;
  destroy(): void;
}

const STYLE = `.st-tools { position: absolute; left: 50%; bottom: max(12px, env(safe-area-inset-bottom)); translate: -50% 0; display: flex; gap: 4px;
  padding: 5px; border: 1px solid #ffffff1c; border-radius: 14px; background: #141b36d9; z-index: 2 }
.game:has(.game-side:not([hidden])) .st-tools { left: calc(50% - 144px) }
.st-tools button { min-width: 44px; height: 44px; padding: 0 10px; border: 0; border-radius: 10px; background: none; color: inherit; font: inherit;
  font-weight: 600; cursor: pointer; touch-action: manipulation }
.st-tools button:hover { background: #ffffff1c } .st-tools button:focus-visible { outline: 2px solid var(--accent) }
.st-tools button[aria-pressed=true] { background: var(--accent); color: #1c1503 }
/* Legible on blocks of any colour. */
.game-hint { bottom: 71px; width: fit-content; height: fit-content; margin: 0 auto; padding: 1px 14px; font-size: 14px; border-radius: 12px; background: #141b36d9 }
/* For a mouse the buttons stand at the left, above the tools, from the top in the order of the keyboard; the hint beside them. */
@media (pointer: fine) { .game .game-pad { left: 16px; bottom: 84px; grid: auto-flow 48px / 48px; justify-content: start } .game-hint { left: 76px }
  .game-pad :is([data-name=up], [data-name=down]) { grid-area: auto } .game-pad [data-name=action] { left: 16px; bottom: 188px; width: 48px; height: 48px } }
/* For fingers they stand in a row, below what is built. */
@media (pointer: coarse) { .game .game-pad { grid: 64px / auto-flow 64px; gap: 12px } .game-pad :is([data-name=up], [data-name=down]) { grid-area: auto } }
@media (max-width: 759px), (max-height: 479px) { .st-tools { top: 66px; bottom: auto } .st-tools button { min-width: 48px; padding: 0 3px }
  .st-tools span { display: block; font-size: 11px; line-height: 1.2 }
  .game:has(.game-side:not([hidden])) .st-tools { display: none } .game-hint { top: 130px }
  /* What a tool does is said below the tools: the next one may be wanted at once. */
  .game .game-banner:not([data-kind=error]) { top: 130px } }
/* On its side a phone has room for it on the ground, between the buttons. */
@media (pointer: coarse) and (max-width: 799px) and (max-height: 479px) { .game .game-hint { top: auto; bottom: 4px; left: 92px; right: 172px; font-size: 13px } }
/* A page that is enlarged: at the right, where no tower stands. */
@media (pointer: fine) and (max-width: 799px) and (max-height: 420px) { .st-tools { left: auto; right: 8px; translate: none; flex-direction: column; gap: 2px } .st-tools button { height: 38px }
  .game-hint { top: auto; bottom: 4px; font-size: 13px } .game .game-banner:not([data-kind=error]) { top: 66px } }
/* Beside the bar, so that the build has the height to itself. */
@media (min-width: 800px) and (max-height: 479px) { .st-tools { top: 8px; left: auto; right: 8px; translate: none } .game-hint { top: auto; bottom: 10px }
  .game .game-banner:not([data-kind=error]) { top: 72px } }`;

/** @param onShare saves the scene to a link @param onHint receives what the chosen tool does */
export function createPalette(parent: HTMLElement, onShare: () => void, onHint: (text: string) => void): Palette {
  let tool: Tool = 'drag';
  const root = document.createElement('div');
  root.className = 'st-tools';
  root.setAttribute('role', 'group');
  root.setAttribute('aria-label', WORDS.tools);
  const style = document.createElement('style');
  style.textContent = STYLE;
  root.append(style);
  const add = (icon: string, label: string, title: string, action: () => void) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.title = title;
    button.setAttribute('aria-label', label);
    const text = document.createElement('span');
    text.textContent = ` ${label}`;
    button.append(icon, text);
    button.addEventListener('click', action);
    root.append(button);
    return button;
  };
  const buttons = Object.entries(WORDS.tool).map(([name, [label, title]]) => {
    const choose = () => {
      tool = name as Tool;
      show();
      onHint(title);
    };
    return { name, button: add(ICONS[name as Tool], label, title, choose) };
  });
  add('⇗', WORDS.link, WORDS.linkHint, onShare);
  const show = () => {
    for (const { name, button } of buttons) button.setAttribute('aria-pressed', String(name === tool));
  };
  show();
  parent.append(root);
  return {
    get tool() {
      return tool;
    },
    destroy: () => root.remove(),
  };
}

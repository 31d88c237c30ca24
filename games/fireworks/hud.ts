/** The desk on the screen: shells and colours to choose, and the timeline of a show. */
import { SHELL_NAMES, STAR_COLORS } from '@principia/scenes';
import type { Stage } from '@principia/shell';
import type { Desk } from './desk.ts';
import { DESK_STYLE } from './desk-style.ts';
import { BARRAGE_ICON, icon, SHELL_ICONS, SURPRISE_ICON } from './icons.ts';
import { css, paletteOf } from './palette.ts';
import type { Settings } from './settings.ts';
import { type FireworksGame, SURPRISE, SWARM } from './sim.ts';
import { createTimeline } from './timeline.ts';

export interface Hud {
  /** Once a frame. @param screen where a place of the sky is on the canvas */
  update(seconds: number, screen: (x: number, y: number, z: number) => { x: number; y: number }): void;
  destroy(): void;
}

const sparks = new Intl.NumberFormat('en', { useGrouping: true });

/** Seconds between two looks at what covers the stage. */
const LOOK_INTERVAL = 0.25;

export function createHud(stage: Stage<Settings, FireworksGame>, desk: Desk): Hud {
  const root = document.createElement('div');
  root.className = 'fw-desk';
  root.innerHTML = `<style>${DESK_STYLE}</style><div class="fw-hint" role="status"></div>`;
  const hint = root.querySelector('.fw-hint') as HTMLElement;
  const timeline = createTimeline(stage, desk);
  const tray = createTray(desk, () => stage.toggle('barrage'));
  const sight = document.createElement('div');
  sight.className = 'fw-sight';
  root.append(timeline.element, tray.element);
  stage.element.append(root, sight);
  const unlock = () => desk.sound.unlock();
  const gestures = ['pointerdown', 'keydown', 'touchend'] as const;
  for (const gesture of gestures) globalThis.addEventListener(gesture, unlock, true);
  const stopKeys = listenToDeskKeys(stage, desk);
  desk.listen(stage.say);
  let shown = '';
  let covered = Number.NaN;
  let sinceLook = LOOK_INTERVAL;
  return {
    update(seconds, screen) {
      const sim = stage.sim();
      desk.sound.set(stage.values().sound);
      desk.sound.hear(sim.scene.news);
      timeline.update();
      sight.hidden = !sim.sight.isShown;
      if (sim.sight.isShown) {
        const { x, y } = screen(sim.sight.x, sim.sight.y, sim.sight.z);
        sight.style.translate = `${x}px ${y}px`;
      }
      sinceLook += seconds;
      if (sinceLook < LOOK_INTERVAL) return;
      sinceLook = 0;
      const { right } = stage.insets();
      if (right !== covered) root.style.right = `${right}px`;
      covered = right;
      const { barrage } = stage.values();
      tray.show(stage.safeColors, barrage);
      const text = barrage ? `${sparks.format(sim.scene.alive)} sparks alight` : hintOf(sim, desk);
      if (text !== shown) hint.textContent = text;
      shown = text;
    },
    destroy() {
      stopKeys();
      for (const gesture of gestures) globalThis.removeEventListener(gesture, unlock, true);
      root.remove();
      sight.remove();
    },
  };
}

function hintOf(sim: FireworksGame, desk: Desk): string {
  if (desk.kind === SWARM) return swarmHint(sim);
  if (desk.isEditing) return '';
  if (sim.isDemo) return 'Click or tap the sky to send up a shell; hold for a larger one';
  if (sim.isShowing) return desk.isDemo ? '' : 'A show: yours, or one that was shared with you';
  return sim.fired > 0 && sim.fired < 4 ? 'T opens the timeline: compose a show and share it' : '';
}

function swarmHint({ held, swarmStars }: FireworksGame): string {
  if (held.size > 0 && swarmStars > 0) return `${swarmStars} stars, each of which bursts into ${swarmStars}`;
  return 'Hold for seconds and let go: two stars for each whole second, and each bursts into as many';
}

function button(label: string, content: string, action: () => void, className = ''): HTMLButtonElement {
  const made = document.createElement('button');
  made.type = 'button';
  made.title = label;
  made.className = className;
  made.setAttribute('aria-label', label);
  made.innerHTML = content;
  made.addEventListener('click', action);
  return made;
}

function createTray(desk: Desk, toggleBarrage: () => void) {
  const element = document.createElement('div');
  element.className = 'fw-tray';
  element.setAttribute('role', 'group');
  element.setAttribute('aria-label', 'Shells and colours');
  const edit = button('Compose a show (T)', 'Show', () => desk.edit());
  const barrage = button('Barrage: a hundred thousand sparks at once (G)', icon(BARRAGE_ICON), toggleBarrage);
  const kinds = [SURPRISE, ...SHELL_NAMES.keys()].map((kind) => {
    const name = kind === SWARM ? 'swarm: hold for seconds' : SHELL_NAMES[kind];
    const label = kind === SURPRISE ? 'any shell (K)' : `${name} (K)`;
    const path = kind === SURPRISE ? SURPRISE_ICON : SHELL_ICONS[kind];
    return { kind, made: button(label, icon(path), () => desk.choose(kind, desk.color)) };
  });
  const colors = [SURPRISE, ...STAR_COLORS.keys()].map((color) => {
    const className = color === SURPRISE ? 'fw-color fw-any' : 'fw-color';
    return { color, made: button('', '<i></i>', () => desk.choose(desk.kind, color), className) };
  });
  // Where there is too little room for all, the colours go to a line of their own.
  const group = (...parts: HTMLElement[]) => {
    const made = document.createElement('div');
    made.append(...parts);
    return made;
  };
  const line = (className = '') => Object.assign(document.createElement('span'), { className });
  element.append(
    group(edit, line(), ...kinds.map(({ made }) => made)),
    line('fw-break'),
    group(...colors.map(({ made }) => made), line(), barrage),
  );
  let shown = -1;
  let isSafe = false;
  let isStorm = false;
  return {
    element,
    show(safe: boolean, isBarrage: boolean) {
      if (desk.version === shown && safe === isSafe && isBarrage === isStorm) return;
      shown = desk.version;
      isSafe = safe;
      isStorm = isBarrage;
      edit.setAttribute('aria-pressed', String(desk.isEditing));
      barrage.setAttribute('aria-pressed', String(isBarrage));
      for (const { kind, made } of kinds) made.setAttribute('aria-pressed', String(kind === desk.kind));
      for (const { color, made } of colors) {
        const chosen = paletteOf(safe)[color] ?? { name: 'any colour', rgb: 0 };
        made.setAttribute('aria-pressed', String(color === desk.color));
        made.title = `${chosen.name} (C)`;
        made.setAttribute('aria-label', chosen.name);
        made.style.setProperty('--c', css(chosen));
      }
    },
  };
}

/** Keys of the desk, wherever the focus is but in a field. Returns how to stop. */
function listenToDeskKeys(stage: Stage<Settings, FireworksGame>, desk: Desk): () => void {
  const keys: Record<string, () => void> = {
    k: () => desk.next('kind'),
    c: () => desk.next('color'),
    t: () => desk.edit(),
    l: () => desk.play(stage.sim()),
    backspace: () => desk.isEditing && desk.editor.undo(),
    delete: () => desk.isEditing && desk.editor.remove(desk.editor.chosen),
  };
  const press = (event: KeyboardEvent) => {
    const target = event.target as Element | null;
    if (event.ctrlKey || event.metaKey || event.altKey || target?.closest?.('input, select, textarea, dialog')) return;
    const action = keys[event.key.toLowerCase()];
    if (action === undefined) return;
    event.preventDefault();
    action();
  };
  document.addEventListener('keydown', press, true);
  return () => document.removeEventListener('keydown', press, true);
}

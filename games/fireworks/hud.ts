/** The controls on the page: shells and colours to choose from, and the timeline of a show. */
import { SHELL_NAMES, STAR_COLORS } from '@principia/scenes';
import { createClipButton, element, grouped, hasCoarsePointer, type ViewContext } from '@principia/shell';
import type { PlayerControls } from './controls.ts';
import { CONTROLS_STYLE } from './controls-style.ts';
import { BARRAGE_ICON, icon, SHELL_ICONS, SURPRISE_ICON } from './icons.ts';
import { createMusicButton } from './music-button.ts';
import { css, paletteOf } from './palette.ts';
import type { Settings } from './settings.ts';
import { createShowList } from './show-list.ts';
import { type FireworksGame, RANDOM, SWARM } from './sim.ts';
import { createTextForm } from './text-form.ts';
import { createTimeline } from './timeline.ts';
import { WORDS } from './words.ts';

export interface Hud {
  /** Call it once a frame. @param screen maps a point of the sky to the canvas */
  update(seconds: number, screen: (x: number, y: number, z: number) => { x: number; y: number }): void;
  destroy(): void;
}

/** Seconds between two updates of the layout and the hint. */
const UPDATE_INTERVAL = 0.25;

export function createHud(context: ViewContext<Settings, FireworksGame>, controls: PlayerControls): Hud {
  const root = document.createElement('div');
  root.className = 'fw-desk';
  root.innerHTML = `<style>${CONTROLS_STYLE}</style><div class="fw-hint" role="status"></div>`;
  const hint = root.querySelector('.fw-hint') as HTMLElement;
  const timeline = createTimeline(context, controls);
  const edit = () => controls.toggleEditing(context.sim());
  const tray = createTray(controls, edit, () => context.toggle('barrage'));
  const crosshair = document.createElement('div');
  crosshair.className = 'fw-sight';
  root.append(timeline.element, tray.element);
  const music = createMusicButton(context, controls);
  const clip = createClipButton(context.clip, 'fw-extra', WORDS.clip);
  const shows = createShowList(context, controls, root);
  const extras = element('div', 'fw-extras', {}, ...createTextForm(context, controls), ...music.elements, clip.button);
  extras.append(...shows.elements);
  context.element.append(root, crosshair, extras);
  const unlock = () => controls.sound.unlock();
  const gestures = ['pointerdown', 'keydown', 'touchend'] as const;
  for (const gesture of gestures) globalThis.addEventListener(gesture, unlock, true);
  const stopKeys = listenToControlKeys(context, controls);
  controls.setMessageHandler(context.showMessage);
  let shown = '';
  let covered = Number.NaN;
  let sinceUpdate = UPDATE_INTERVAL;
  return {
    update(seconds, screen) {
      const sim = context.sim();
      controls.sound.set(context.values().sound);
      controls.sound.playNew(sim.scene.events);
      timeline.update();
      music.update();
      crosshair.hidden = !sim.crosshair.isShown;
      if (sim.crosshair.isShown) {
        const { x, y } = screen(sim.crosshair.x, sim.crosshair.y, sim.crosshair.z);
        crosshair.style.translate = `${x}px ${y}px`;
      }
      sinceUpdate += seconds;
      if (sinceUpdate < UPDATE_INTERVAL) return;
      sinceUpdate = 0;
      clip.update();
      shows.update();
      const { right } = context.insets();
      if (right !== covered) root.style.right = `${right}px`;
      covered = right;
      const { barrage } = context.values();
      tray.show(context.safeColors, barrage);
      const text = barrage ? WORDS.alight(grouped(sim.scene.alive)) : hintOf(sim, controls);
      if (text !== shown) hint.textContent = text;
      shown = text;
    },
    destroy() {
      stopKeys();
      for (const gesture of gestures) globalThis.removeEventListener(gesture, unlock, true);
      music.destroy();
      shows.destroy();
      controls.text = '';
      extras.remove();
      root.remove();
      crosshair.remove();
    },
  };
}

function hintOf(sim: FireworksGame, controls: PlayerControls): string {
  if (controls.kind === SWARM) return swarmHint(sim);
  // For fingers the timeline has no room to say so.
  if (controls.isEditing) return hasCoarsePointer() && controls.editor.cues.length === 0 ? WORDS.noShells : '';
  if (sim.isDemo) return WORDS.launch;
  if (sim.isShowing) return controls.isDemo ? '' : WORDS.playing;
  return sim.fired > 0 && sim.fired < 4 ? WORDS.compose : '';
}

function swarmHint({ held, swarmStars }: FireworksGame): string {
  if (held.size > 0 && swarmStars > 0) return WORDS.swarmNow(swarmStars);
  return WORDS.swarmHint;
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

function createTray(controls: PlayerControls, toggleEditing: () => void, toggleBarrage: () => void) {
  const element = document.createElement('div');
  element.className = 'fw-tray';
  element.setAttribute('role', 'group');
  element.setAttribute('aria-label', WORDS.tray);
  const edit = button(WORDS.showHint, WORDS.show, toggleEditing);
  const barrage = button(WORDS.barrageHint, icon(BARRAGE_ICON), toggleBarrage);
  const kinds = [RANDOM, ...SHELL_NAMES.keys()].map((kind) => {
    const name = kind === SWARM ? WORDS.swarmButton : WORDS.shells[kind];
    const label = `${kind === RANDOM ? WORDS.randomShell : name} (K)`;
    const path = kind === RANDOM ? SURPRISE_ICON : SHELL_ICONS[kind];
    return { kind, made: button(label, icon(path), () => controls.choose(kind, controls.color)) };
  });
  const colors = [RANDOM, ...STAR_COLORS.keys()].map((color) => {
    const className = color === RANDOM ? 'fw-color fw-any' : 'fw-color';
    return { color, made: button('', '<i></i>', () => controls.choose(controls.kind, color), className) };
  });
  // Narrow windows put the colours on a second line.
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
  let hasBarrage = false;
  return {
    element,
    show(safe: boolean, isBarrage: boolean) {
      if (controls.version === shown && safe === isSafe && isBarrage === hasBarrage) return;
      shown = controls.version;
      isSafe = safe;
      hasBarrage = isBarrage;
      edit.setAttribute('aria-pressed', String(controls.isEditing));
      barrage.setAttribute('aria-pressed', String(isBarrage));
      for (const { kind, made } of kinds) made.setAttribute('aria-pressed', String(kind === controls.kind));
      for (const { color, made } of colors) {
        const chosen = paletteOf(safe)[color] ?? { name: WORDS.randomColor, rgb: 0 };
        made.setAttribute('aria-pressed', String(color === controls.color));
        made.title = `${chosen.name} (C)`;
        made.setAttribute('aria-label', chosen.name);
        made.style.setProperty('--c', css(chosen));
      }
    },
  };
}

/** Listens to the game's keys, except in input fields. Returns a function that stops listening. */
function listenToControlKeys(context: ViewContext<Settings, FireworksGame>, controls: PlayerControls): () => void {
  const keys: Record<string, () => void> = {
    k: () => controls.next('kind'),
    c: () => controls.next('color'),
    t: () => controls.toggleEditing(context.sim()),
    l: () => controls.play(context.sim()),
    backspace: () => controls.isEditing && controls.editor.undo(),
    delete: () => controls.isEditing && controls.editor.remove(controls.editor.chosen),
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

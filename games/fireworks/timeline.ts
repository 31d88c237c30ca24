/** The timeline of the edited show. */
import { SHELL_NAMES } from '@principia/scenes';
import type { ViewContext } from '@principia/shell';
import type { PlayerControls } from './controls.ts';
import { css, paletteOf } from './palette.ts';
import type { Settings } from './settings.ts';
import type { FireworksGame } from './sim.ts';

const STEPS_PER_SECOND = 60;
/** Shortest length of the timeline, s, and margin after the last shell, s. */
const MIN_SECONDS = 15;
const MARGIN_SECONDS = 3;
/** Distance that distinguishes a drag from a click, CSS pixels. */
const DRAG_THRESHOLD = 4;

export interface Timeline {
  readonly element: HTMLElement;
  /** Call it once a frame. */
  update(): void;
}

export function createTimeline(stage: ViewContext<Settings, FireworksGame>, controls: PlayerControls): Timeline {
  const { editor } = controls;
  const element = document.createElement('section');
  element.className = 'fw-show';
  element.setAttribute('aria-label', 'Show editor');
  element.innerHTML = `<div><button type="button" data-do="play">Play</button><p role="status"></p>
<button type="button" data-do="undo" title="Undo (Backspace)">Undo</button>
<button type="button" data-do="remove" title="Remove the selected shell (Delete)">Remove</button>
<button type="button" data-do="clear">Clear</button><button type="button" data-do="share">Share</button></div>
<div class="fw-line"><div class="fw-cursor"></div></div>`;
  const find = (selector: string) => element.querySelector(selector) as HTMLElement;
  const buttonOf = (name: string) => find(`[data-do=${name}]`) as HTMLButtonElement;
  const [line, cursor, text] = [find('.fw-line'), find('.fw-cursor'), find('p')];
  const actions: Record<string, () => void> = {
    play: () => controls.play(stage.sim()),
    undo: () => editor.undo(),
    remove: () => editor.remove(editor.chosen),
    clear: () => editor.clear(),
    share: () => void controls.share(),
  };
  for (const [name, action] of Object.entries(actions)) buttonOf(name).addEventListener('click', action);
  let length = MIN_SECONDS * STEPS_PER_SECOND;
  const tickAt = (event: PointerEvent) => {
    const { left, width } = line.getBoundingClientRect();
    return ((event.clientX - left) / Math.max(1, width)) * length;
  };
  line.addEventListener('pointerdown', (event) => {
    if (event.target !== line) return;
    editor.chosen = -1;
    editor.seek(tickAt(event));
  });
  const marks: HTMLElement[] = [];
  const showMarks = () => {
    length = Math.max(
      MIN_SECONDS * STEPS_PER_SECOND,
      (editor.cues.at(-1)?.tick ?? 0) + MARGIN_SECONDS * STEPS_PER_SECOND,
    );
    for (const mark of marks.splice(0)) mark.remove();
    const palette = paletteOf(stage.safeColors);
    for (const [i, { tick, kind, color }] of editor.cues.entries()) {
      const mark = document.createElement('button');
      mark.type = 'button';
      mark.className = 'fw-mark';
      mark.title = `${SHELL_NAMES[kind]}, ${palette[color].name}, at ${(tick / STEPS_PER_SECOND).toFixed(1)} s`;
      mark.setAttribute('aria-label', mark.title);
      mark.setAttribute('aria-pressed', String(i === editor.chosen));
      mark.style.cssText = `left:${(100 * tick) / length}%;--c:${css(palette[color])}`;
      mark.addEventListener('pointerdown', (event) => drag(event, i));
      mark.addEventListener('click', () => choose(i));
      marks.push(mark);
    }
    line.append(...marks);
  };
  const choose = (index: number) => {
    editor.chosen = index;
    editor.version++;
  };
  // Marks are recreated during a drag, so the line captures the pointer.
  let dragged: { pointer: number; x: number; isMoved: boolean } | undefined;
  const drag = (event: PointerEvent, index: number) => {
    event.preventDefault();
    choose(index);
    dragged = { pointer: event.pointerId, x: event.clientX, isMoved: false };
    line.setPointerCapture(event.pointerId);
  };
  line.addEventListener('pointermove', (event) => {
    if (dragged?.pointer !== event.pointerId) return;
    dragged.isMoved ||= Math.abs(event.clientX - dragged.x) > DRAG_THRESHOLD;
    if (dragged.isMoved) editor.move(editor.chosen, tickAt(event));
  });
  const drop = () => {
    dragged = undefined;
  };
  line.addEventListener('pointerup', drop);
  line.addEventListener('pointercancel', drop);
  let [shown, place, isPlaying] = [-1, -1, false];
  return {
    element,
    update() {
      element.hidden = !controls.isEditing;
      if (!controls.isEditing) return;
      const sim = stage.sim();
      if (editor.version !== shown || isPlaying !== (sim.isShowing && !sim.isDemo)) {
        shown = editor.version;
        isPlaying = sim.isShowing && !sim.isDemo;
        showMarks();
        const count = editor.cues.length;
        for (const name of ['play', 'clear', 'share']) buttonOf(name).disabled = count === 0;
        buttonOf('remove').disabled = editor.chosen < 0;
        buttonOf('play').textContent = isPlaying ? 'Stop' : 'Play';
        text.textContent =
          count === 0
            ? 'Click the sky to add shells to the show'
            : `${count} ${count === 1 ? 'shell' : 'shells'}; the next is added at ${(editor.cursor / STEPS_PER_SECOND).toFixed(1)} s`;
        place = -1;
      }
      const at = isPlaying ? sim.world.tick - sim.showStart : editor.cursor;
      if (at === place) return;
      place = at;
      cursor.style.left = `${Math.min(100, (100 * at) / length)}%`;
    },
  };
}

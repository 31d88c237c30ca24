/** The timeline of the edited show. */
import type { StarColor } from '@principia/scenes';
import type { ViewContext } from '@principia/shell';
import type { PlayerControls } from './controls.ts';
import { css, paletteOf } from './palette.ts';
import type { Settings } from './settings.ts';
import type { ShowEditor } from './show-editor.ts';
import type { Cue, FireworksGame } from './sim.ts';
import { WORDS } from './words.ts';

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

export function createTimeline(context: ViewContext<Settings, FireworksGame>, controls: PlayerControls): Timeline {
  const { editor } = controls;
  const { element, buttonOf, line, cursor, text } = createElements();
  listenToButtons(context, controls, buttonOf);
  let length = MIN_SECONDS * STEPS_PER_SECOND;
  const onPress = listenToLine(line, editor, () => length);
  const marks: HTMLElement[] = [];
  const showMarks = () => {
    const last = editor.cues.at(-1)?.tick ?? 0;
    length = Math.max(MIN_SECONDS * STEPS_PER_SECOND, last + MARGIN_SECONDS * STEPS_PER_SECOND);
    for (const mark of marks.splice(0)) mark.remove();
    const palette = paletteOf(context.safeColors);
    for (const [i, cue] of editor.cues.entries()) {
      const mark = createMark(cue, palette, length, i === editor.chosen);
      mark.addEventListener('pointerdown', (event) => onPress(event, i));
      mark.addEventListener('click', () => choose(editor, i));
      marks.push(mark);
    }
    line.append(...marks);
  };
  const showState = (isPlaying: boolean) => {
    const count = editor.cues.length;
    for (const name of ['play', 'clear', 'share']) buttonOf(name).disabled = count === 0;
    buttonOf('undo').disabled = !editor.canUndo;
    buttonOf('remove').disabled = editor.chosen < 0;
    buttonOf('play').textContent = isPlaying ? WORDS.stop : WORDS.play;
    text.textContent = statusOf(count, editor.cursor);
  };
  let [shownVersion, shownTick, isPlaying] = [-1, -1, false];
  return {
    element,
    update() {
      element.hidden = !controls.isEditing;
      if (!controls.isEditing) return;
      const sim = context.sim();
      if (editor.version !== shownVersion || isPlaying !== (sim.isShowing && !sim.isDemo)) {
        shownVersion = editor.version;
        isPlaying = sim.isShowing && !sim.isDemo;
        showMarks();
        showState(isPlaying);
        shownTick = -1;
      }
      const tick = isPlaying ? sim.world.tick - sim.showStart : editor.cursor;
      if (tick === shownTick) return;
      shownTick = tick;
      cursor.style.left = `${Math.min(100, (100 * tick) / length)}%`;
    },
  };
}

function createElements() {
  const element = document.createElement('section');
  element.className = 'fw-show';
  element.setAttribute('aria-label', WORDS.editor);
  element.innerHTML = `<div><button type="button" data-do="play">${WORDS.play}</button><p role="status"></p>
<button type="button" data-do="undo" title="${WORDS.undoHint}">${WORDS.undo}</button>
<button type="button" data-do="remove" title="${WORDS.removeHint}">${WORDS.remove}</button>
<button type="button" data-do="clear">${WORDS.clear}</button><button type="button" data-do="share">${WORDS.share}</button></div>
<div class="fw-line"><div class="fw-cursor"></div></div>`;
  const find = (selector: string) => element.querySelector(selector) as HTMLElement;
  const buttonOf = (name: string) => find(`[data-do=${name}]`) as HTMLButtonElement;
  return { element, buttonOf, line: find('.fw-line'), cursor: find('.fw-cursor'), text: find('p') };
}

function listenToButtons(
  context: ViewContext<Settings, FireworksGame>,
  controls: PlayerControls,
  buttonOf: (name: string) => HTMLButtonElement,
): void {
  const { editor } = controls;
  const actions: Record<string, () => void> = {
    play: () => controls.play(context.sim()),
    undo: () => editor.undo(),
    remove: () => editor.remove(editor.chosen),
    clear: () => editor.clear(),
    share: () => void controls.share(),
  };
  for (const [name, action] of Object.entries(actions)) buttonOf(name).addEventListener('click', action);
}

function choose(editor: ShowEditor, index: number): void {
  editor.chosen = index;
  editor.version++;
}

/**
 * Handles clicks and drags on the line. Marks are recreated during a drag, so the line captures the pointer.
 * @param length steps that the line shows
 * @returns the handler of a press on the mark of a cue
 */
function listenToLine(line: HTMLElement, editor: ShowEditor, length: () => number) {
  const tickAt = (event: PointerEvent) => {
    const { left, width } = line.getBoundingClientRect();
    return ((event.clientX - left) / Math.max(1, width)) * length();
  };
  let drag: { pointer: number; x: number; isMoved: boolean } | undefined;
  line.addEventListener('pointerdown', (event) => {
    if (event.target !== line) return;
    editor.chosen = -1;
    editor.seek(tickAt(event));
  });
  line.addEventListener('pointermove', (event) => {
    if (drag?.pointer !== event.pointerId) return;
    drag.isMoved ||= Math.abs(event.clientX - drag.x) > DRAG_THRESHOLD;
    if (drag.isMoved) editor.move(editor.chosen, tickAt(event));
  });
  const endDrag = () => {
    drag = undefined;
  };
  line.addEventListener('pointerup', endDrag);
  line.addEventListener('pointercancel', endDrag);
  return (event: PointerEvent, index: number) => {
    event.preventDefault();
    choose(editor, index);
    drag = { pointer: event.pointerId, x: event.clientX, isMoved: false };
    line.setPointerCapture(event.pointerId);
  };
}

function createMark({ tick, kind, color }: Cue, palette: readonly StarColor[], length: number, isChosen: boolean) {
  const mark = document.createElement('button');
  mark.type = 'button';
  mark.className = 'fw-mark';
  mark.title = WORDS.mark(WORDS.shells[kind], palette[color].name, tick / STEPS_PER_SECOND);
  mark.setAttribute('aria-label', mark.title);
  mark.setAttribute('aria-pressed', String(isChosen));
  mark.style.cssText = `left:${(100 * tick) / length}%;--c:${css(palette[color])}`;
  return mark;
}

function statusOf(count: number, cursor: number): string {
  return count === 0 ? WORDS.noShells : WORDS.next(count, cursor / STEPS_PER_SECOND);
}

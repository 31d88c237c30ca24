/** The button that makes a press blow air at the cloth instead of dragging or cutting it. A ring shows where it blows. */
import { element } from '@principia/shell';
import { WORDS } from './words.ts';

export interface BlowOptions {
  /** Whether the pointer belongs to the view, which the space bar moves. */
  isSpaceHeld(): boolean;
  /** The pointer is at this place on the canvas, CSS pixels. */
  blow(x: number, y: number): void;
  stop(): void;
}

export interface BlowButton {
  readonly isBlowing: boolean;
  /** Ends a press, as if the pointer had been released. */
  release(): void;
  destroy(): void;
}

/** @param row of buttons that gets this one */
export function createBlowButton(
  parent: HTMLElement,
  row: HTMLElement,
  canvas: HTMLCanvasElement,
  { isSpaceHeld, blow, stop }: BlowOptions,
): BlowButton {
  const attributes = { type: 'button', 'aria-pressed': 'false', title: WORDS.blowHint };
  const button = element('button', 'cloth-button', attributes, WORDS.blow);
  const ring = element('i', 'cloth-ring', { 'aria-hidden': 'true', hidden: '' });
  row.append(button);
  parent.append(ring);
  let isOn = false;
  let pointer: number | undefined;
  button.addEventListener('click', () => {
    isOn = !isOn;
    button.setAttribute('aria-pressed', String(isOn));
    release();
  });
  const follow = ({ clientX, clientY }: PointerEvent) => {
    const { left, top } = canvas.getBoundingClientRect();
    const [x, y] = [clientX - left, clientY - top];
    ring.style.translate = `${x}px ${y}px`;
    ring.hidden = false;
    blow(x, y);
  };
  const release = () => {
    if (pointer === undefined) return;
    pointer = undefined;
    ring.hidden = true;
    stop();
  };
  const down = (event: PointerEvent) => {
    if (!isOn || event.target !== canvas || event.button !== 0 || isSpaceHeld()) return;
    // The canvas would take it for a drag or a cut. A second finger does nothing.
    event.stopPropagation();
    if (pointer !== undefined) return;
    pointer = event.pointerId;
    canvas.setPointerCapture(pointer);
    follow(event);
  };
  const move = (event: PointerEvent) => event.pointerId === pointer && follow(event);
  const up = ({ pointerId }: PointerEvent) => pointerId === pointer && release();
  const listening = new AbortController();
  const options = { capture: true, signal: listening.signal };
  parent.addEventListener('pointerdown', down, options);
  parent.addEventListener('pointermove', move, options);
  parent.addEventListener('pointerup', up, options);
  parent.addEventListener('pointercancel', up, options);
  return {
    get isBlowing() {
      return pointer !== undefined;
    },
    release,
    destroy() {
      release();
      listening.abort();
      button.remove();
      ring.remove();
    },
  };
}

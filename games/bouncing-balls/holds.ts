/**
 * Press and hold: time stands still while one holds, or a magnet appears under the pointer and follows it, until it is let go.
 * A ring shows where.
 */
import { placeOnCanvas } from '@principia/render-core';
import { element } from '@principia/shell';

/** How long a press rests before it counts, ms, and how far it may move meanwhile, CSS pixels. */
const HOLD = { milliseconds: 350, pixels: 10 } as const;

export interface HoldOptions {
  /** Whether the pointer drags a ball. */
  isTaken(pointer: number): boolean;
  /** Whether a hold is a magnet; else it stops time. */
  isMagnet(): boolean;
  freeze(isFrozen: boolean): void;
  /** The magnet is at this place on the canvas, CSS pixels. */
  attract(x: number, y: number): void;
  release(): void;
}

/** @returns a function that stops listening */
export function listenToHolds(
  parent: HTMLElement,
  canvas: HTMLCanvasElement,
  { isTaken, isMagnet, freeze, attract, release }: HoldOptions,
): () => void {
  const ring = element('i', 'magnet-ring', { 'aria-hidden': 'true', hidden: '' });
  parent.append(element('style', '', {}, STYLE), ring);
  const stop = new AbortController();
  let press: PointerEvent | undefined;
  let timer = 0;
  let held: 'nothing' | 'magnet' | 'time' = 'nothing';
  const put = (event: PointerEvent) => {
    const { x, y } = placeOnCanvas(canvas, event);
    ring.style.translate = `${x}px ${y}px`;
    ring.hidden = false;
    if (held === 'magnet') attract(x, y);
  };
  const begin = () => {
    if (press === undefined || isTaken(press.pointerId)) return;
    held = isMagnet() ? 'magnet' : 'time';
    ring.dataset.held = held;
    if (held === 'time') freeze(true);
    put(press);
  };
  const end = () => {
    clearTimeout(timer);
    press = undefined;
    ring.hidden = true;
    if (held === 'magnet') release();
    if (held === 'time') freeze(false);
    held = 'nothing';
  };
  const down = (event: PointerEvent) => {
    // Two fingers move the view.
    const isFirst = press === undefined;
    end();
    if (event.target !== canvas || event.button !== 0 || !isFirst) return;
    press = event;
    timer = window.setTimeout(begin, HOLD.milliseconds);
  };
  const move = (event: PointerEvent) => {
    if (press === undefined || event.pointerId !== press.pointerId) return;
    if (held !== 'nothing') {
      // The view stays where it is while the magnet moves; about what stands still it turns.
      if (held === 'magnet') event.stopPropagation();
      put(event);
    } else if (Math.hypot(event.clientX - press.clientX, event.clientY - press.clientY) > HOLD.pixels) end();
  };
  const up = ({ pointerId }: PointerEvent) => pointerId === press?.pointerId && end();
  // Before the canvas and what turns the view hear of it.
  const { signal } = stop;
  parent.addEventListener('pointerdown', down, { capture: true, signal });
  parent.addEventListener('pointermove', move, { capture: true, signal });
  parent.addEventListener('pointerup', up, { capture: true, signal });
  parent.addEventListener('pointercancel', up, { capture: true, signal });
  return () => {
    end();
    stop.abort();
  };
}

const STYLE = `
.magnet-ring { position: absolute; left: -28px; top: -28px; width: 56px; height: 56px; box-sizing: border-box; border-radius: 50%;
  border: 3px solid #ffc15e; box-shadow: 0 0 24px #ffc15e99, inset 0 0 18px #ffc15e66; pointer-events: none;
  animation: magnet-pulse .8s ease-in-out infinite alternate }
.magnet-ring[data-held=time] { border-color: #cfe0ff; box-shadow: 0 0 24px #7fa8ff80; animation: none; display: grid; place-items: center }
.magnet-ring[data-held=time][hidden] { display: none }
.magnet-ring[data-held=time]::after { content: ''; width: 14px; height: 18px; box-sizing: border-box; border: solid #fff; border-width: 0 5px }
@keyframes magnet-pulse { to { scale: .8; opacity: .7 } }
`;

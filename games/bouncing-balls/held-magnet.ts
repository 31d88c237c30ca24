/** Press and hold: a magnet appears under the pointer and follows it until it is let go. A ring shows where it is. */
import { element } from '@principia/shell';

/** How long a press rests before the magnet appears, ms, and how far it may move meanwhile, CSS pixels. */
const HOLD = { milliseconds: 350, pixels: 10 } as const;

export interface HeldMagnetOptions {
  /** Whether the pointer drags a ball. */
  isTaken(pointer: number): boolean;
  /** The magnet is at this place on the canvas, CSS pixels. */
  attract(x: number, y: number): void;
  release(): void;
}

/** @returns a function that stops listening */
export function listenToHolds(
  parent: HTMLElement,
  canvas: HTMLCanvasElement,
  { isTaken, attract, release }: HeldMagnetOptions,
): () => void {
  const ring = element('i', 'magnet-ring', { 'aria-hidden': 'true', hidden: '' });
  parent.append(element('style', '', {}, STYLE), ring);
  const stop = new AbortController();
  let press: PointerEvent | undefined;
  let timer = 0;
  let isOn = false;
  const put = ({ clientX, clientY }: PointerEvent) => {
    const { left, top } = canvas.getBoundingClientRect();
    const [x, y] = [clientX - left, clientY - top];
    ring.style.translate = `${x}px ${y}px`;
    ring.hidden = false;
    attract(x, y);
  };
  const begin = () => {
    if (press === undefined || isTaken(press.pointerId)) return;
    isOn = true;
    put(press);
  };
  const end = () => {
    clearTimeout(timer);
    press = undefined;
    ring.hidden = true;
    if (isOn) release();
    isOn = false;
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
    if (isOn) {
      // The view stays where it is while the magnet moves.
      event.stopPropagation();
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
@keyframes magnet-pulse { to { scale: .8; opacity: .7 } }
`;

import { placeOnCanvas } from '@principia/render-core';

/** A press that ends soon and where it began. */
const TAP = { milliseconds: 350, pixels: 10 } as const;

/**
 * Listens to taps and clicks on a canvas, also on bodies, which they grab for a moment.
 * @param onTap receives the place on the canvas, CSS pixels
 * @returns a function that stops listening
 */
export function listenToTaps(canvas: HTMLCanvasElement, onTap: (x: number, y: number) => void): () => void {
  const presses = new Map<number, PointerEvent>();
  const stop = new AbortController();
  const { signal } = stop;
  const down = (event: PointerEvent) => {
    // Two fingers move the view.
    if (presses.size > 0) presses.clear();
    else if (event.button === 0) presses.set(event.pointerId, event);
  };
  const up = (event: PointerEvent) => {
    const press = presses.get(event.pointerId);
    presses.delete(event.pointerId);
    if (press === undefined || event.timeStamp - press.timeStamp > TAP.milliseconds) return;
    if (Math.hypot(event.clientX - press.clientX, event.clientY - press.clientY) > TAP.pixels) return;
    const { x, y } = placeOnCanvas(canvas, event);
    onTap(x, y);
  };
  canvas.addEventListener('pointerdown', down, { signal });
  canvas.addEventListener('pointerup', up, { signal });
  canvas.addEventListener('pointercancel', ({ pointerId }) => presses.delete(pointerId), { signal });
  return () => stop.abort();
}

/** Swipes that begin beside the cloth cut it; a fading line shows the blade. */
import { placeOnCanvas } from '@principia/render-core';
import type { ViewContext } from '@principia/shell';
import type { Settings } from './settings.ts';
import { type ClothRun, cutAlong } from './sim.ts';

type Point = { readonly x: number; readonly y: number };

/** Time that the line stays, ms. */
const FADE_MS = 160;
const SVG = 'http://www.w3.org/2000/svg';

/**
 * @param place position of a node on the canvas, CSS pixels
 * @returns a function that stops listening
 */
export function listenToSwipes(
  context: ViewContext<Settings, ClothRun>,
  canvas: HTMLCanvasElement,
  place: (node: number) => Point,
): () => void {
  const blade = createBlade(context.element);
  let pointer: number | undefined;
  let last: Point = { x: 0, y: 0 };
  const locate = (event: PointerEvent): Point => placeOnCanvas(canvas, event);
  const stop = new AbortController();
  const listen = (
    type: 'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel',
    use: (e: PointerEvent) => void,
  ) => canvas.addEventListener(type, use, { signal: stop.signal });
  listen('pointerdown', (event) => {
    // Two fingers move the view.
    if (pointer !== undefined) pointer = undefined;
    else if (event.button === 0 && !context.isSpaceHeld() && !context.dragging().holds(event.pointerId)) {
      pointer = event.pointerId;
      last = locate(event);
      canvas.setPointerCapture(pointer);
    }
  });
  listen('pointermove', (event) => {
    if (event.pointerId !== pointer) return;
    const now = locate(event);
    cutAlong(context.sim(), place, last, now);
    blade.draw(last, now);
    last = now;
  });
  const end = ({ pointerId }: PointerEvent) => {
    if (pointerId === pointer) pointer = undefined;
  };
  listen('pointerup', end);
  listen('pointercancel', end);
  return () => {
    stop.abort();
    blade.remove();
  };
}

function createBlade(parent: HTMLElement) {
  const svg = document.createElementNS(SVG, 'svg');
  svg.style.cssText = 'position:absolute;inset:0;width:100%;height:100%;pointer-events:none';
  parent.append(svg);
  return {
    draw(from: Point, to: Point) {
      const line = document.createElementNS(SVG, 'line');
      const ends = { x1: from.x, y1: from.y, x2: to.x, y2: to.y };
      for (const [name, value] of Object.entries(ends)) line.setAttribute(name, String(value));
      line.style.cssText = 'stroke:#fff;stroke-width:2.5;stroke-linecap:round;opacity:.85';
      svg.append(line);
      setTimeout(() => line.remove(), FADE_MS);
    },
    remove: () => svg.remove(),
  };
}

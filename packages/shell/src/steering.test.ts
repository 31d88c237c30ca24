import { expect, test } from 'vitest';
import { listenToSteering } from './steering.ts';

/** A canvas of the page as far as steering asks for it. */
function makeCanvas(shownScale = 1) {
  const listeners = new Map<string, (event: PointerEvent) => void>();
  const canvas = {
    style: { touchAction: 'pan-y' },
    addEventListener: (type: string, listener: (event: PointerEvent) => void) => listeners.set(type, listener),
    removeEventListener: (type: string) => listeners.delete(type),
    setPointerCapture() {},
    clientWidth: 400,
    clientHeight: 300,
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 400 * shownScale, height: 300 * shownScale }),
  };
  const send = (type: string, x: number, y: number) =>
    listeners.get(type)?.({ clientX: x, clientY: y, pointerId: 1, button: 0 } as PointerEvent);
  return { canvas: canvas as unknown as HTMLCanvasElement, listeners, send };
}

test('a craft goes towards the pointer, and lets go when steering ends with the pointer down', () => {
  const { canvas, listeners, send } = makeCanvas();
  const sent: number[][] = [];
  const steering = listenToSteering(canvas, {
    craft: () => ({ x: 100, y: 100 }),
    steer: (x, y) => sent.push([x, y]),
  });
  expect(canvas.style.touchAction).toBe('none');
  send('pointerdown', 200, 100);
  expect(sent).toEqual([[1, 0]]);
  steering.destroy();
  expect(sent.at(-1)).toEqual([0, 0]);
  expect(listeners.size).toBe(0);
  expect(canvas.style.touchAction).toBe('pan-y');
  steering.update();
  expect(sent).toHaveLength(2);
});

test('finds the pointer on a canvas that the page scales', () => {
  const { canvas, send } = makeCanvas(0.5);
  const sent: number[][] = [];
  listenToSteering(canvas, { craft: () => ({ x: 100, y: 100 }), steer: (x, y) => sent.push([x, y]) });
  // 134 pixels of the picture: half of the way from the least to the full thrust.
  send('pointerdown', 67, 50);
  expect(sent).toEqual([[0.5, 0]]);
});

import { expect, test } from 'vitest';
import { listenToSteering } from './steering.ts';

/** A canvas of the page as far as steering asks for it. */
function makeCanvas() {
  const listeners = new Map<string, (event: PointerEvent) => void>();
  const canvas = {
    style: { touchAction: 'pan-y' },
    addEventListener: (type: string, listener: (event: PointerEvent) => void) => listeners.set(type, listener),
    removeEventListener: (type: string) => listeners.delete(type),
    setPointerCapture() {},
    getBoundingClientRect: () => ({ left: 0, top: 0 }),
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

import { afterEach, expect, it, vi } from 'vitest';
import { watchViewport } from './viewport.ts';

afterEach(() => vi.unstubAllGlobals());

it('reports real sizes once, caps the resolution and survives a hidden parent', () => {
  let measure = (): void => {};
  let watching = false;
  const listeners = new EventTarget();
  vi.stubGlobal('addEventListener', listeners.addEventListener.bind(listeners));
  vi.stubGlobal('removeEventListener', listeners.removeEventListener.bind(listeners));
  vi.stubGlobal('devicePixelRatio', 3);
  class FakeObserver {
    constructor(callback: () => void) {
      measure = callback;
    }
    observe() {
      watching = true;
    }
    disconnect() {
      watching = false;
    }
  }
  vi.stubGlobal('ResizeObserver', FakeObserver);
  const parent = { clientWidth: 0, clientHeight: 0 };
  const canvas = { parentElement: parent } as unknown as HTMLCanvasElement;
  const calls: number[][] = [];
  const viewport = watchViewport(canvas, (...size) => calls.push(size));
  expect(calls).toEqual([]);
  Object.assign(parent, { clientWidth: 300, clientHeight: 200 });
  measure();
  measure();
  Object.assign(parent, { clientWidth: 0, clientHeight: 0 });
  measure();
  expect(calls).toEqual([[300, 200, 2]]);
  expect([viewport.width, viewport.height, viewport.resolution]).toEqual([300, 200, 2]);
  viewport.destroy();
  expect(watching).toBe(false);
});

it('refuses a canvas that is not in the page', () => {
  const canvas = { parentElement: null } as unknown as HTMLCanvasElement;
  expect(() => watchViewport(canvas, () => {})).toThrow(/append it to the page/);
});

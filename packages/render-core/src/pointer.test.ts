import { describe, expect, it } from 'vitest';
import type { Camera2D } from './camera-2d.ts';
import { listenToPointers, type PointerOptions } from './pointer.ts';

/** An event target with the few members of a canvas that the listener uses: 200 by 100 pixels at (10, 20). */
function fakeCanvas(shownScale = 1) {
  const captured: number[] = [];
  const canvas = Object.assign(new EventTarget(), {
    style: { touchAction: 'auto' },
    clientWidth: 200,
    clientHeight: 100,
    setPointerCapture: (id: number) => captured.push(id),
    getBoundingClientRect: () => ({ left: 10, top: 20, width: 200 * shownScale, height: 100 * shownScale }),
  });
  const fire = (type: string, x: number, y: number, more: object = {}) => {
    const event = new Event(type, { cancelable: true });
    const fields = { clientX: x + 10, clientY: y + 20, pointerId: 1, button: 0, pointerType: 'mouse', ...more };
    for (const [name, value] of Object.entries(fields)) Object.defineProperty(event, name, { value });
    canvas.dispatchEvent(event);
    return event;
  };
  return { canvas: canvas as unknown as HTMLCanvasElement, captured, fire };
}

function setUp(options: Partial<PointerOptions> = {}, shownScale = 1) {
  const camera: Camera2D = { x: 0, y: 0, pixelsPerMetre: 10 };
  const log: unknown[][] = [];
  const fake = fakeCanvas(shownScale);
  const control = listenToPointers(fake.canvas, {
    camera,
    pick: (x, y) => (Math.hypot(x, y) < 1 ? 7 : 0),
    onGrab: (...args) => log.push(['grab', ...args]),
    onDrag: (...args) => log.push(['drag', ...args]),
    onRelease: (...args) => log.push(['release', ...args]),
    ...options,
  });
  return { ...fake, camera, log, control };
}

describe('listenToPointers', () => {
  it('grabs, drags and throws a body in world coordinates', () => {
    const { fire, log, camera, captured } = setUp();
    fire('pointerdown', 100, 50, { timeStamp: 0 });
    fire('pointermove', 110, 40, { timeStamp: 20 });
    fire('pointermove', 120, 30, { timeStamp: 40 });
    fire('pointerup', 120, 30, { timeStamp: 45 });
    expect(captured).toEqual([1]);
    expect(log.slice(0, 3)).toEqual([
      ['grab', 7, 0, 0, 1],
      ['drag', 7, 1, 1, 1],
      ['drag', 7, 2, 2, 1],
    ]);
    const [name, id, x, y, vx, vy] = log[3] as [string, number, number, number, number, number];
    expect([name, id, x, y]).toEqual(['release', 7, 2, 2]);
    expect(vx).toBeCloseTo(50, 6);
    expect(vy).toBeCloseTo(50, 6);
    expect(camera).toEqual({ x: 0, y: 0, pixelsPerMetre: 10 });
  });

  it.each([0.5, 1.5])('finds the points of a canvas that a transform scales by %d', (shownScale) => {
    const { fire, log, camera } = setUp({}, shownScale);
    fire('pointerdown', 100 * shownScale, 50 * shownScale);
    fire('pointermove', 120 * shownScale, 40 * shownScale);
    expect(log).toEqual([
      ['grab', 7, 0, 0, 1],
      ['drag', 7, 2, 1, 1],
    ]);
    fire('wheel', 20 * shownScale, 50 * shownScale, { deltaMode: 0, deltaY: 100 });
    // The wheel leaves the point below it in its place, which is 8 m to the left of the middle.
    expect(camera.x - 80 / camera.pixelsPerMetre).toBeCloseTo(-8, 9);
  });

  it('finds the points of a picture that style sheets show in another size', () => {
    const viewport = { width: 800, height: 600 };
    const { fire, log } = setUp({ viewport, pick: (x, y) => (Math.hypot(x - 20, y - 12) < 1e-9 ? 7 : 0) });
    // 800 by 600 pixels on 200 by 100: the point is 200 pixels right of the middle and 120 above it.
    fire('pointerdown', 150, 30);
    viewport.width = 400;
    fire('pointermove', 150, 30);
    expect(log).toEqual([
      ['grab', 7, 20, 12, 1],
      ['drag', 7, 10, 12, 1],
    ]);
  });

  it('pans with the right and the middle button, and while the space bar is held', () => {
    for (const button of [1, 2]) {
      const panned = setUp();
      panned.fire('pointerdown', 20, 20, { button });
      panned.fire('pointermove', 30, 20);
      expect(panned.camera.x).toBeCloseTo(-1, 9);
      expect(panned.fire('contextmenu', 30, 20).defaultPrevented).toBe(true);
    }
    // The space bar lets the primary button pan, even on a body.
    const held = setUp({ primaryPans: () => true });
    held.fire('pointerdown', 100, 50);
    held.fire('pointermove', 110, 50);
    expect(held.camera.x).toBeCloseTo(-1, 9);
    expect(held.log).toEqual([]);
  });

  it('keeps the view when a drag misses a body, by mouse and by finger', () => {
    for (const pointerType of ['mouse', 'touch']) {
      let navigated = 0;
      const still = setUp({ onNavigate: () => navigated++ });
      still.fire('pointerdown', 20, 20, { pointerType });
      still.fire('pointermove', 90, 70, { pointerType });
      still.fire('pointerup', 90, 70, { pointerType });
      expect(still.camera).toEqual({ x: 0, y: 0, pixelsPerMetre: 10 });
      expect(navigated).toBe(0);
    }
  });

  it('does not move the view where navigation is off', () => {
    const still = setUp({ navigate: false });
    still.fire('pointerdown', 20, 20, { button: 2 });
    still.fire('pointermove', 30, 20);
    still.fire('wheel', 20, 20, { deltaY: 100, deltaMode: 0 });
    expect(still.camera).toEqual({ x: 0, y: 0, pixelsPerMetre: 10 });
  });

  it('pinches with two fingers about their middle', () => {
    const { fire, camera } = setUp();
    fire('pointerdown', 60, 80, { pointerId: 1, pointerType: 'touch' });
    fire('pointerdown', 140, 80, { pointerId: 2, pointerType: 'touch' });
    fire('pointermove', 40, 80, { pointerId: 1 });
    fire('pointermove', 160, 80, { pointerId: 2 });
    expect(camera.pixelsPerMetre).toBeCloseTo(15, 9);
    expect(camera.x).toBeCloseTo(0, 9);
    expect(camera.y - 30 / 15).toBeCloseTo(-3, 9);
  });

  it('drags with one finger while two others pan', () => {
    const { fire, log, camera } = setUp();
    fire('pointerdown', 100, 50, { pointerId: 1 });
    for (const pointerId of [2, 3]) fire('pointerdown', 20, 20, { pointerId });
    for (const pointerId of [2, 3]) fire('pointermove', 30, 20, { pointerId });
    fire('pointerup', 100, 50, { pointerId: 1, timeStamp: 1e6 });
    expect(camera.x).toBeCloseTo(-1, 9);
    expect(log.map(([name]) => name)).toEqual(['grab', 'release']);
  });

  it('zooms with the wheel and stops the page from scrolling', () => {
    const { fire, camera } = setUp({ zoomLimits: { min: 5, max: 12 } });
    expect(fire('wheel', 100, 50, { deltaY: -100, deltaMode: 0 }).defaultPrevented).toBe(true);
    expect(camera.pixelsPerMetre).toBeCloseTo(10 * Math.exp(0.15), 9);
    fire('wheel', 100, 50, { deltaY: -100, deltaMode: 1 });
    expect(camera.pixelsPerMetre).toBe(12);
  });

  it('lets go of everything and listens no more after destroy', () => {
    const { canvas, fire, log, control } = setUp();
    expect(canvas.style.touchAction).toBe('none');
    fire('pointerdown', 100, 50);
    control.destroy();
    expect(canvas.style.touchAction).toBe('auto');
    expect(log[1]).toEqual(['release', 7, 0, 0, 0, 0, 1]);
    fire('pointerdown', 100, 50);
    expect(log.length).toBe(2);
  });
});

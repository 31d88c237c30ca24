import { describe, expect, it } from 'vitest';
import { type Camera2D, fit, follow, panBy, toScreen, toWorld, zoomAt } from './camera-2d.ts';

const viewport = { width: 800, height: 600 };
const camera = (): Camera2D => ({ x: 3, y: -2, pixelsPerMetre: 40 });

describe('camera', () => {
  it('puts its own point in the middle and y up', () => {
    const out = { x: 0, y: 0 };
    expect(toScreen(camera(), viewport, 3, -2, out)).toEqual({ x: 400, y: 300 });
    expect(toScreen(camera(), viewport, 4, -1, out)).toEqual({ x: 440, y: 260 });
  });

  it('inverts toScreen with toWorld', () => {
    const screen = toScreen(camera(), viewport, -7.25, 11.5, { x: 0, y: 0 });
    const world = toWorld(camera(), viewport, screen.x, screen.y, { x: 0, y: 0 });
    expect(world.x).toBeCloseTo(-7.25, 12);
    expect(world.y).toBeCloseTo(11.5, 12);
  });

  it('pans with the pointer', () => {
    const view = camera();
    const before = toWorld(view, viewport, 100, 100, { x: 0, y: 0 });
    panBy(view, 30, -20);
    const after = toScreen(view, viewport, before.x, before.y, { x: 0, y: 0 });
    expect(after.x).toBeCloseTo(130, 9);
    expect(after.y).toBeCloseTo(80, 9);
  });

  it('keeps the point under the pointer while zooming, also at the limits', () => {
    const view = camera();
    const before = toWorld(view, viewport, 700, 50, { x: 0, y: 0 });
    zoomAt(view, viewport, 700, 50, 1.7);
    zoomAt(view, viewport, 700, 50, 1e6, { min: 1, max: 500 });
    expect(view.pixelsPerMetre).toBe(500);
    const after = toWorld(view, viewport, 700, 50, { x: 0, y: 0 });
    expect(after.x).toBeCloseTo(before.x, 9);
    expect(after.y).toBeCloseTo(before.y, 9);
  });

  it('refuses a zoom factor that is not positive', () => {
    expect(() => zoomAt(camera(), viewport, 0, 0, 0)).toThrow(/positive number/);
    expect(() => zoomAt(camera(), viewport, 0, 0, Number.NaN)).toThrow(/positive number/);
  });

  it('fits bounds with a margin on the tighter side', () => {
    const view = camera();
    fit(view, { minX: -10, minY: 0, maxX: 10, maxY: 5 }, viewport, 50);
    expect(view).toEqual({ x: 0, y: 2.5, pixelsPerMetre: 35 });
  });

  it('keeps its scale when there is nothing to fit or no area to fit it in', () => {
    const view = camera();
    fit(view, { minX: 1, minY: 1, maxX: 1, maxY: 1 }, viewport);
    expect(view).toEqual({ x: 1, y: 1, pixelsPerMetre: 40 });
    fit(view, { minX: 0, minY: 0, maxX: 1, maxY: 1 }, { width: 0, height: 0 });
    expect(view.pixelsPerMetre).toBe(40);
  });
});

describe('follow', () => {
  const run = (frames: number, seconds: number): { view: Camera2D; highest: number } => {
    const view = { x: 0, y: 0, pixelsPerMetre: 1 };
    const velocity = { x: 0, y: 0 };
    let highest = 0;
    for (let i = 0; i < frames; i++) {
      follow(view, velocity, 10, -4, 0.2, seconds / frames);
      highest = Math.max(highest, view.x);
    }
    return { view, highest };
  };

  it('does not depend on the frame rate', () => {
    const slow = run(10, 0.5).view;
    const fast = run(500, 0.5).view;
    expect(slow.x).toBeCloseTo(fast.x, 9);
    expect(slow.y).toBeCloseTo(fast.y, 9);
  });

  it('matches the closed form of a critically damped spring and does not overshoot', () => {
    const { view, highest } = run(60, 0.6);
    expect(view.x).toBeCloseTo(10 * (1 - (1 + 3) * Math.exp(-3)), 9);
    expect(highest).toBeLessThanOrEqual(10);
    expect(run(400, 6).view.y).toBeCloseTo(-4, 6);
  });

  it('jumps when there is no smoothing', () => {
    const view = { x: 0, y: 0, pixelsPerMetre: 1 };
    follow(view, { x: 5, y: 5 }, 2, 3, 0, 0.01);
    expect(view).toEqual({ x: 2, y: 3, pixelsPerMetre: 1 });
  });
});

import { toScreen } from '@principia/render-core';
import { expect, it } from 'vitest';
import { applyCamera } from './camera.ts';

function target() {
  const position = { x: 0, y: 0 };
  const scale = { x: 1, y: 1 };
  const setter = (point: { x: number; y: number }) => ({
    set(x: number, y: number) {
      point.x = x;
      point.y = y;
    },
  });
  return { position, scale, container: { position: setter(position), scale: setter(scale) } };
}

it('sends a world point where toScreen says, for layers with y up', () => {
  const camera = { x: 12, y: -7, pixelsPerMetre: 33 };
  const viewport = { width: 640, height: 360 };
  const { position, scale, container } = target();
  applyCamera(container, camera, viewport);
  const expected = toScreen(camera, viewport, 9, 2, { x: 0, y: 0 });
  expect(position.x + scale.x * 9).toBeCloseTo(expected.x, 9);
  expect(position.y + scale.y * -2).toBeCloseTo(expected.y, 9);
});

it('refuses a camera that shows nothing', () => {
  const { position, container } = target();
  for (const wrong of [{ pixelsPerMetre: 0 }, { pixelsPerMetre: -1 }, { x: Number.NaN }, { y: Infinity }]) {
    const camera = { x: 1, y: 2, pixelsPerMetre: 3, ...wrong };
    expect(() => applyCamera(container, camera, { width: 640, height: 360 })).toThrow(
      `got x ${camera.x}, y ${camera.y}, pixelsPerMetre ${camera.pixelsPerMetre}`,
    );
  }
  expect(position).toEqual({ x: 0, y: 0 });
});

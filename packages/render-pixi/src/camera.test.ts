import { toScreen } from '@principia/render-core';
import { expect, it } from 'vitest';
import { applyCamera } from './camera.ts';

it('sends a world point where toScreen says, for layers with y up', () => {
  const camera = { x: 12, y: -7, pixelsPerMetre: 33 };
  const viewport = { width: 640, height: 360 };
  const position = { x: 0, y: 0 };
  const scale = { x: 1, y: 1 };
  const setter = (point: { x: number; y: number }) => ({
    set(x: number, y: number) {
      point.x = x;
      point.y = y;
    },
  });
  applyCamera({ position: setter(position), scale: setter(scale) }, camera, viewport);
  const expected = toScreen(camera, viewport, 9, 2, { x: 0, y: 0 });
  expect(position.x + scale.x * 9).toBeCloseTo(expected.x, 9);
  expect(position.y + scale.y * -2).toBeCloseTo(expected.y, 9);
});

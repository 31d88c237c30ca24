import { OrthographicCamera, PerspectiveCamera } from 'three';
import { expect, test } from 'vitest';
import { createTestBodySource } from '../../../test/support/body-source.ts';
import { listenToBodyDragging } from './body-dragging.ts';

/** A square of 200 CSS pixels at the corner of the window. */
const element = {
  clientHeight: 200,
  style: { touchAction: '' },
  addEventListener() {},
  removeEventListener() {},
  getBoundingClientRect: () => ({ left: 0, top: 0, width: 200, height: 200 }),
} as unknown as HTMLElement;

/** A ball of 1 m at the origin. */
function oneBall() {
  const source = createTestBodySource(1024, 3);
  source.radius[1] = 1;
  source.show([1]);
  return source;
}

test.each([10, 1000])('a pointer may miss a body by some pixels, under a parallel camera %d m away', (distance) => {
  // 20 m in 200 pixels: the rim of the ball is 10 pixels from the centre of the picture.
  const camera = new OrthographicCamera(-10, 10, 10, -10, 0.1, 2000);
  camera.position.z = distance;
  const { pick } = listenToBodyDragging(element, { source: oneBall(), camera, tolerance: 6 });
  expect([100 + 15.9, 100 + 16.1].map((x) => pick(x, 100))).toEqual([1, 0]);
});

test.each([10, 1000])('and under a perspective camera %d m away', (distance) => {
  // The picture is as high as the camera is far, so 200 pixels are its distance in metres: a pixel is distance/200.
  const camera = new PerspectiveCamera((360 / Math.PI) * Math.atan(0.5), 1, 0.1, 2000);
  camera.position.z = distance;
  camera.updateProjectionMatrix();
  const { pick } = listenToBodyDragging(element, { source: oneBall(), camera, tolerance: 6 });
  // The ball is met by rays that pass it at its rim and 6 pixels beside it, up to the slant of the rays: 0.1 at 10 m.
  const rim = 200 / distance;
  expect([0.9, 1.25].map((part) => pick(100 + part * (rim + 6), 100))).toEqual([1, 0]);
});

test('a pointer finds a fast body where the picture shows it between two steps', () => {
  const camera = new OrthographicCamera(-10, 10, 10, -10, 0.1, 2000);
  camera.position.z = 10;
  const source = oneBall();
  source.position.x[1] = 5;
  const drawn = { alpha: 0.1 };
  const { pick } = listenToBodyDragging(element, { source, camera, alpha: () => drawn.alpha });
  // 10 pixels a metre: the ball is seen at 0.5 m, and is at 5 m now.
  expect([105, 150].map((x) => pick(x, 100))).toEqual([1, 0]);
  drawn.alpha = 1;
  expect([105, 150].map((x) => pick(x, 100))).toEqual([0, 1]);
});

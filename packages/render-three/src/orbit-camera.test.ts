import { Box3, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { createOrbitCamera } from './orbit-camera.ts';

/** As much of an element as the controls need outside a browser. */
function fakeElement(): HTMLElement {
  const target = new EventTarget();
  const document = new EventTarget();
  return Object.assign(target, {
    style: {},
    clientHeight: 100,
    clientWidth: 200,
    ownerDocument: document,
    getRootNode: () => document,
  }) as unknown as HTMLElement;
}

/** Largest |x| and |y| of the corners of `box` in clip coordinates; 1 is the rim of the picture. */
function rim(camera: PerspectiveCamera | OrthographicCamera, box: Box3): [number, number] {
  camera.updateMatrixWorld();
  const reach: [number, number] = [0, 0];
  for (let i = 0; i < 8; i++) {
    const { min, max } = box;
    const corner = new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).project(camera);
    reach[0] = Math.max(reach[0], Math.abs(corner.x));
    reach[1] = Math.max(reach[1], Math.abs(corner.y));
  }
  return reach;
}

const boxes = [
  new Box3(new Vector3(-5, -1, -2), new Vector3(5, 1, 2)),
  new Box3(new Vector3(100, 0, 0), new Vector3(101, 30, 1)),
  new Box3(new Vector3(-4, -3, 0), new Vector3(4, 3, 0)),
];

test.each([new PerspectiveCamera(50, 2, 0.1, 10), new OrthographicCamera(-4, 4, 2, -2)])(
  'fit sees all of the bounds and wastes little',
  (camera) => {
    camera.position.set(3, 2, 6);
    const orbit = createOrbitCamera({ element: fakeElement(), camera });
    for (const box of boxes) {
      orbit.fit(box);
      const reach = Math.max(...rim(camera, box));
      expect(reach).toBeLessThanOrEqual(1 + 1e-9);
      expect(reach).toBeGreaterThan(0.85);
      expect(orbit.controls.target.distanceTo(box.getCenter(new Vector3()))).toBeLessThan(1e-9);
    }
  },
);

test('fit refuses empty bounds and takes a single point', () => {
  const orbit = createOrbitCamera({ element: fakeElement() });
  expect(() => orbit.fit(new Box3())).toThrow(/empty/);
  orbit.fit(new Box3(new Vector3(1, 2, 3), new Vector3(1, 2, 3)));
  expect(orbit.camera.position.toArray().every(Number.isFinite)).toBe(true);
});

test('follow brings the point to the middle and keeps the direction of sight', () => {
  const orbit = createOrbitCamera({ element: fakeElement() });
  orbit.fit(boxes[0]);
  const sight = orbit.camera.position.clone().sub(orbit.controls.target);
  orbit.follow({ x: 10, y: -4, z: 2 });
  for (let i = 0; i < 120; i++) orbit.update(1 / 60);
  expect(orbit.controls.target.distanceTo(new Vector3(10, -4, 2))).toBeLessThan(1e-4);
  expect(orbit.camera.position.clone().sub(orbit.controls.target).distanceTo(sight)).toBeLessThan(1e-6);
  orbit.follow(undefined);
  orbit.update(1);
  expect(orbit.controls.target.x).toBeCloseTo(10, 3);
});

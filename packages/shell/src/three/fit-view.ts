/** Fits a box into the part of the window that nothing covers. */
import { Box3, type PerspectiveCamera, Vector3 } from 'three';
import type { Insets } from '../game.ts';

/** Fraction of the free part of the window that the box fills. */
const FILL_SHARE = 0.95;

/** @param lookAt aims the camera at the box, for a picture of the size of the free part */
export function fitView(
  camera: PerspectiveCamera,
  box: Box3,
  { width, height }: { readonly width: number; readonly height: number },
  { top, right, bottom, left }: Insets,
  lookAt: () => void,
): void {
  camera.clearViewOffset();
  const freeWidth = Math.max(width - left - right, 1);
  const freeHeight = Math.max(height - top - bottom, 1);
  camera.zoom = 1;
  camera.aspect = freeWidth / freeHeight;
  camera.updateProjectionMatrix();
  lookAt();
  const { x, y, zoom } = tightFit(camera, box);
  camera.zoom = zoom;
  // The camera was fitted to the free part; the view offset extends the picture to the rest of the window.
  const [offsetX, offsetY] = [x * zoom * freeWidth * 0.5 - left, -y * zoom * freeHeight * 0.5 - top];
  camera.setViewOffset(freeWidth, freeHeight, offsetX, offsetY, width, height);
}

/** Puts what the camera looks at into the middle of the part of the window that nothing covers. */
export function centreView(
  camera: PerspectiveCamera,
  { width, height }: { readonly width: number; readonly height: number },
  { top, right, bottom, left }: Insets,
): void {
  const freeWidth = Math.max(width - left - right, 1);
  const freeHeight = Math.max(height - top - bottom, 1);
  camera.zoom = 1;
  camera.aspect = freeWidth / freeHeight;
  camera.setViewOffset(freeWidth, freeHeight, -left, -top, width, height);
}

/** Centre of the box in the picture, from -1 to 1, and the zoom that fits it; perspective makes it asymmetric. */
function tightFit(camera: PerspectiveCamera, { min, max }: Box3): { x: number; y: number; zoom: number } {
  camera.updateMatrixWorld();
  const seen = new Box3();
  const corner = new Vector3();
  for (const x of [min.x, max.x]) {
    for (const y of [min.y, max.y]) {
      for (const z of [min.z, max.z]) seen.expandByPoint(corner.set(x, y, z).project(camera));
    }
  }
  const size = seen.getSize(new Vector3());
  const centre = seen.getCenter(new Vector3());
  return { x: centre.x, y: centre.y, zoom: (2 * FILL_SHARE) / Math.max(size.x, size.y) };
}

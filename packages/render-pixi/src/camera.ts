import type { Camera2D, ViewportSize } from '@principia/render-core';

/** The part of a pixi `Container` that a camera moves. */
export interface CameraTarget {
  readonly position: { set(x: number, y: number): unknown };
  readonly scale: { set(x: number, y: number): unknown };
}

/**
 * Sets a container's transform to the camera's view. Layers in it must have the default `pixelsPerMetre: 1`; sprites
 * and text in it are placed at (x, −y) in metres and stay upright, or at (x, y) in a `createWorldContainer`.
 *
 * Call it each frame: it sets one transform, and nothing if the camera did not move.
 *
 * In a world too large for f32, apply it to a container of your own in the stage, and move the origin of the layers with the
 * camera: `layer.setOrigin(camera.x, camera.y)`. Pixi then adds both offsets in f64. Do not apply it to the stage there, nor
 * to another render group: pixi sends the transform of a render group to the GPU by itself, rounded to f32.
 *
 * @param viewport size of the renderer's screen, CSS pixels
 * @throws Error when the camera is at no finite place, or its scale not above zero; the container then stays as it is
 */
export function applyCamera(container: CameraTarget, camera: Camera2D, viewport: ViewportSize): void {
  const { x, y, pixelsPerMetre: scale } = camera;
  if (!(Number.isFinite(x + y + scale) && scale > 0)) {
    const given = `x ${x}, y ${y}, pixelsPerMetre ${scale}`;
    throw new Error(`applyCamera needs a camera with finite x and y and pixelsPerMetre above 0, got ${given}`);
  }
  container.scale.set(scale, scale);
  container.position.set(viewport.width / 2 - x * scale, viewport.height / 2 + y * scale);
}

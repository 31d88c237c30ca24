import { Container, VERSION } from 'pixi.js';
import { requirePixi } from './pixi-version.ts';

/** Options of `createWorldContainer`. */
export interface WorldContainerOptions {
  /** Pixels of the container's own coordinates per metre; default 1, which is what `applyCamera` expects. */
  pixelsPerMetre?: number;
}

/**
 * Creates a container in which y points up and angles turn anticlockwise, as in the world and in the layers: sprites,
 * graphics and text of your own in it are placed at (x, y), in metres, and turned by the angle of their body. What is
 * drawn with y down, as images and text are, stands on its head there: see `keepUpright`.
 *
 * @throws Error when `pixelsPerMetre` is not a positive number, or pixi.js is too old
 */
export function createWorldContainer(options: WorldContainerOptions = {}): Container {
  const { pixelsPerMetre = 1 } = options;
  requirePixi(VERSION);
  if (!(pixelsPerMetre > 0 && Number.isFinite(pixelsPerMetre))) {
    throw new Error(`pixelsPerMetre must be a positive number, got ${pixelsPerMetre}`);
  }
  const container = new Container({ label: 'world' });
  container.scale.set(pixelsPerMetre, -pixelsPerMetre);
  return container;
}

/**
 * Mirrors a sprite or text vertically, by the sign of its `scale.y`, so that it stands upright in a container with y up.
 * Call it after its scale was set; `width` and `height` keep the sign.
 *
 * @returns the same object
 */
export function keepUpright<Child extends { readonly scale: { y: number } }>(child: Child): Child {
  child.scale.y = -Math.abs(child.scale.y);
  return child;
}

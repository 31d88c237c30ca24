import type { ViewportSize } from './camera-2d.ts';

/** A canvas that follows the size of its parent element. */
export interface Viewport extends ViewportSize {
  /** Device pixels per CSS pixel used for drawing: the display's own, at most `maxResolution`. */
  readonly resolution: number;
  /** Stops watching. */
  destroy(): void;
}

/** Options of `watchViewport`. */
export interface ViewportOptions {
  /** Upper bound of `resolution`; default 2, because higher resolutions cost more than they show. */
  maxResolution?: number;
}

/**
 * Size in CSS pixels and resolution that fill `parent`; zero if it is hidden.
 *
 * @param maxResolution as in `ViewportOptions`
 */
export function sizeToFill(parent: HTMLElement, maxResolution = 2) {
  const resolution = Math.min(globalThis.devicePixelRatio || 1, maxResolution);
  return { width: parent.clientWidth, height: parent.clientHeight, resolution };
}

/**
 * Watches the parent element of a canvas and reports its size, so that the application can resize its renderer.
 * `onResize` is called once at the start, and then only when the size or the resolution changed; it is not called for
 * a hidden (zero-sized) parent, since a renderer cannot draw to nothing, but `width` and `height` then keep the last
 * real size, or are 1 before there was any.
 *
 * @param onResize receives width and height in CSS pixels and the resolution
 * @throws Error when there is no canvas, or it is not attached to a parent element
 */
export function watchViewport(
  canvas: HTMLCanvasElement,
  onResize: (width: number, height: number, resolution: number) => void,
  options: ViewportOptions = {},
): Viewport {
  const parent = canvas?.parentElement;
  if (parent === undefined) throw new Error('watchViewport needs a canvas, and a function to be told of its size');
  if (parent === null) {
    throw new Error('the canvas has no parent element: append it to the page before watching its size');
  }
  const size = { width: 1, height: 1, resolution: 1 };
  let known = false;

  const measure = (): void => {
    const { width, height, resolution } = sizeToFill(parent, options.maxResolution);
    if (width === 0 || height === 0) return;
    if (known && width === size.width && height === size.height && resolution === size.resolution) return;
    known = true;
    size.width = width;
    size.height = height;
    size.resolution = resolution;
    onResize(width, height, resolution);
  };

  const observer = new ResizeObserver(measure);
  observer.observe(parent);
  // Moving the window to another display changes the pixel ratio without changing the parent's size.
  globalThis.addEventListener('resize', measure);
  measure();
  return {
    get width() {
      return size.width;
    },
    get height() {
      return size.height;
    },
    get resolution() {
      return size.resolution;
    },
    destroy() {
      observer.disconnect();
      globalThis.removeEventListener('resize', measure);
    },
  };
}

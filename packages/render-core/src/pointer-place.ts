import type { Vector2, ViewportSize } from './camera-2d.ts';

/**
 * Where a point of the window lies in the picture that an element shows, whatever size style sheets, `transform` and zoom
 * give the element on the page. Written into `out`, which is also returned: from the top left corner, in pixels of the picture.
 *
 * @param element the canvas, or another element of its size
 * @param clientX as in a pointer event, CSS pixels
 * @param picture size of the picture; { width: 1, height: 1 } gives parts of its width and height
 */
export function placeInPicture(
  element: Element,
  clientX: number,
  clientY: number,
  { width, height }: ViewportSize,
  out: Vector2,
): Vector2 {
  const box = element.getBoundingClientRect();
  // The quotient first: it is exactly 1 where nothing is scaled. A hidden element has no size.
  out.x = (clientX - box.left) * (box.width > 0 ? width / box.width : 1);
  out.y = (clientY - box.top) * (box.height > 0 ? height / box.height : 1);
  return out;
}

/**
 * Where a pointer is on a canvas that is drawn for its size on the page: CSS pixels from its top left corner, before any
 * `transform` or zoom of the page around it.
 */
export function placeOnCanvas(canvas: Element, { clientX, clientY }: MouseEvent): Vector2 {
  const { clientWidth: width, clientHeight: height } = canvas;
  return placeInPicture(canvas, clientX, clientY, { width, height }, { x: 0, y: 0 });
}

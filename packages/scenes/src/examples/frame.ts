/** How the coordinates of a picture become metres of the view. */
import type { Picture, Point, ViewBox } from './picture.ts';

/** Size of a graph, m. */
const GRAPH = { width: 16, height: 10 };
/** Room for the numbers and names at the axes of a graph, m. */
const MARGIN = { left: 1.5, bottom: 1.3, top: 0.4, right: 0.5 };

/** The region of a view, and where the points of a picture are in it. */
export interface Frame {
  /** Region to be shown, m. */
  readonly bounds: ViewBox;
  /** Metres of a point of the picture. */
  place(point: Point): { readonly x: number; readonly y: number };
}

/** A graph has scales of its own for x and y, so it is drawn into a rectangle of a fixed size. */
export function frameOf({ view, graph }: Picture): Frame {
  if (graph === undefined) return { bounds: view, place: ({ x, y }) => ({ x, y }) };
  const { left, bottom, top, right } = MARGIN;
  return {
    bounds: { minX: -left, minY: -bottom, maxX: GRAPH.width + right, maxY: GRAPH.height + top },
    place: ({ x, y }) => ({
      x: (GRAPH.width * (x - view.minX)) / (view.maxX - view.minX),
      y: (GRAPH.height * (y - view.minY)) / (view.maxY - view.minY),
    }),
  };
}

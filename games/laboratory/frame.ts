/** How the coordinates of a picture become metres of the view. */
import type { Picture, Point, ViewBox } from '@principia/scenes/examples';

/** Size of a graph, m. */
const GRAPH = { width: 16, height: 10 };
/** Room for the numbers and names at the axes of a graph, m. */
const MARGIN = { left: 1.5, bottom: 1.3, top: 0.4, right: 0.5 };

export interface Frame {
  /** Region to be shown, m. */
  readonly bounds: ViewBox;
  /** Metres of a point of the picture. */
  place(point: Point): { x: number; y: number };
}

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

/** Round positions of grid lines from `min` to `max`, about `count` of them. */
export function gridLines(min: number, max: number, step?: number, count = 8): number[] {
  const raw = (max - min) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const round = ([1, 2, 5].find((factor) => factor * power >= raw) ?? 10) * power;
  const spacing = step ?? round;
  const lines: number[] = [];
  for (let i = Math.ceil(min / spacing - 1e-9); i * spacing <= max + 1e-9 * spacing; i++) {
    lines.push(Number((i * spacing).toPrecision(12)));
  }
  return lines;
}

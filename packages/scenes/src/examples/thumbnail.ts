/** A small picture of an example as SVG, drawn from its own state without a display. */
import { bodies, cos, shapeAt, sin, step } from '@principia/physics';
import type { Example, ExampleRun } from './define-example.ts';
import { type Frame, frameOf } from './frame.ts';
import { COLORS, type Color, type Fill, type Line, now, type Picture, type Point, type ViewBox } from './picture.ts';

const WIDTH = 240;
const HEIGHT = 150;
const MARGIN = 6;
/** Share of the duration that is shown. */
const SHARE = 0.4;
const MAX_STEPS = 1500;
/** Points of a drawn path at most. */
const MAX_POINTS = 120;
const MAX_BODIES = 400;
/** Colour of bodies that have none. */
const BODY_COLOR = 0x4f9dde;

type Spot = { readonly x: number; readonly y: number };

/** Runs an example for two fifths of its duration, and draws what its page would show. */
export function thumbnail(example: Example): string {
  const run = example.start();
  const steps = Math.min(MAX_STEPS, Math.round((SHARE * example.duration) / run.dt));
  const paths = (run.picture.trails ?? []).map(({ body, color }) => ({ body, color, points: [] as Point[] }));
  const stride = Math.max(1, Math.ceil(steps / MAX_POINTS));
  const record = () => {
    for (const { body, points } of paths) points.push(positionIn(run, body));
  };
  record();
  for (let i = 1; i <= steps; i++) {
    step(run.world, run.dt);
    if (i % stride === 0 || i === steps) record();
  }
  const sketch = new Sketch(run.picture);
  drawBack(sketch, run.picture);
  for (const { color, points } of paths) {
    for (const part of withoutJumps(points, run.picture)) sketch.path(part, color ?? BODY_COLOR, 1.2, 0.7);
  }
  drawBodies(sketch, run);
  drawFront(sketch, run.picture);
  return sketch.svg();
}

/** A body that leaves the view on one side and enters it on the other has a path of two parts. */
function withoutJumps(points: readonly Point[], { view }: Picture): Point[][] {
  const reach = Math.min(view.maxX - view.minX, view.maxY - view.minY) / 2;
  const parts: Point[][] = [[]];
  for (const [i, point] of points.entries()) {
    const last = points[i - 1] ?? point;
    if (Math.abs(point.x - last.x) > reach || Math.abs(point.y - last.y) > reach) parts.push([]);
    parts[parts.length - 1].push(point);
  }
  return parts;
}

function positionIn({ world: { components } }: ExampleRun, id: number): Point {
  const { x, y, z } = components.Position;
  return { x: x[id], y: y[id], z: z[id] };
}

function drawBack(sketch: Sketch, { fills = [], curves = [], lines = [], graph, view }: Picture): void {
  for (const fill of fills) if (!fill.inFront) sketch.fill(fill);
  if (graph !== undefined) {
    const { minX, maxX, minY, maxY } = view;
    const x = Math.min(maxX, Math.max(minX, 0));
    const y = Math.min(maxY, Math.max(minY, 0));
    sketch.line({ from: { x, y: minY }, to: { x, y: maxY }, color: COLORS.grey, width: 1 });
    sketch.line({ from: { x: minX, y }, to: { x: maxX, y }, color: COLORS.grey, width: 1 });
  }
  for (const { points, color = COLORS.grey } of curves) sketch.path(points, color, 1.5);
  for (const line of lines) sketch.line(line);
}

function drawBodies(sketch: Sketch, run: ExampleRun): void {
  const { world, picture } = run;
  const { Spring, Collider, Appearance, Rotation } = world.components;
  if (picture.springs !== undefined) {
    for (let id = 1; id <= world.lastId; id++) {
      if (Spring.a[id] === 0) continue;
      sketch.line({
        from: positionIn(run, Spring.a[id]),
        to: positionIn(run, Spring.b[id]),
        color: 0xc8d0d8,
        width: 1,
      });
    }
  }
  const { ids, count } = bodies(world);
  const isSeen = (id: number) => Collider.shape[id] > 0 || Appearance.size[id] > 0 || Collider.radius[id] > 0;
  const seen = Array.from({ length: count }, (_, i) => ids[i]).filter(isSeen);
  // Of many bodies some are drawn, in place of all, with the area of all.
  const share = Math.max(1, seen.length / MAX_BODIES);
  for (let i = 0; i < seen.length / share; i++) {
    const id = seen[Math.floor(i * share)];
    const at = positionIn(run, id);
    const { color, opacity } = colorOf(Appearance.color[id]);
    const shape = Collider.shape[id] > 0 ? shapeAt(world, Collider.shape[id]) : undefined;
    if (shape === undefined || shape.vertices.length < 4) {
      const radius = Appearance.size[id] || Collider.radius[id];
      if (radius > 0) sketch.disc(at, radius * Math.sqrt(share), color, opacity);
      continue;
    }
    const [c, s] = [cos(Rotation.angle[id]), sin(Rotation.angle[id])];
    const corners: Point[] = [];
    for (let k = 0; k + 1 < shape.vertices.length; k += 2) {
      const [x, y] = [shape.vertices[k], shape.vertices[k + 1]];
      corners.push({ x: at.x + c * x - s * y, y: at.y + s * x + c * y });
    }
    sketch.polygon(corners, color, opacity, shape.radius);
  }
}

function drawFront(sketch: Sketch, { fills = [], arrows = [], dots = [] }: Picture): void {
  for (const { from, vector, scale = 1, color = COLORS.green } of arrows) {
    const [a, v] = [now(from), vector()];
    const to = { x: a.x + scale * v.x, y: a.y + scale * v.y, z: (a.z ?? 0) + scale * (v.z ?? 0) };
    sketch.line({ from: a, to, color, width: 1.5 });
  }
  for (const { at, color = COLORS.orange } of dots) sketch.spot(now(at), 3, color);
  for (const fill of fills) if (fill.inFront) sketch.fill(fill);
}

/** Red, green and blue of a packed colour, and its opacity. */
function colorOf(packed: number): { color: Color; opacity: number } {
  if (packed === 0) return { color: BODY_COLOR, opacity: 1 };
  const [red, green, blue] = [packed & 255, (packed >>> 8) & 255, (packed >>> 16) & 255];
  return { color: (red << 16) | (green << 8) | blue, opacity: (packed >>> 24) / 255 };
}

/** Collects shapes as SVG elements. */
class Sketch {
  readonly #frame: Frame;
  readonly #parts: string[] = [];
  readonly #scale: number;
  readonly #centre: Spot;
  readonly #up: 1 | -1;

  constructor(picture: Picture) {
    this.#frame = frameOf(picture);
    const { minX, maxX, minY, maxY } = this.#frame.bounds;
    this.#scale = Math.min((WIDTH - 2 * MARGIN) / (maxX - minX), (HEIGHT - 2 * MARGIN) / (maxY - minY));
    this.#centre = { x: (minX + maxX) / 2, y: (minY + maxY) / 2 };
    this.#up = picture.yDown ? -1 : 1;
  }

  svg(): string {
    const size = `viewBox="0 0 ${WIDTH} ${HEIGHT}"`;
    return `<svg xmlns="http://www.w3.org/2000/svg" ${size}>${this.#parts.join('')}</svg>`;
  }

  fill({ shape, color, opacity = 1 }: Fill): void {
    if ('radius' in shape) this.disc(now(shape.centre), shape.radius, color, opacity);
    else if ('minX' in shape) {
      this.polygon(cornersOf(shape), color, opacity, 0);
    } else this.polygon(now(shape), color, opacity, 0);
  }

  line({ from, to, color = COLORS.white, width = 2 }: Line): void {
    this.path([now(from), now(to)], color, 0.7 * width);
  }

  path(points: readonly Point[], color: Color, width: number, opacity = 1): void {
    if (points.length < 2) return;
    const stride = Math.max(1, Math.ceil(points.length / MAX_POINTS));
    const kept = points.filter((_, i) => i % stride === 0 || i === points.length - 1);
    const style = `fill="none" stroke="${hex(color)}" stroke-width="${width}"${opacityOf('stroke', opacity)}`;
    this.#parts.push(`<path d="M${this.#list(kept)}" ${style}/>`);
  }

  /** @param rounding radius by which the corners are rounded, m */
  polygon(corners: readonly Point[], color: Color, opacity: number, rounding: number): void {
    const width = round(2 * rounding * this.#scale);
    const rim = width > 0 ? ` stroke="${hex(color)}" stroke-width="${width}" stroke-linejoin="round"` : '';
    this.#parts.push(`<path d="M${this.#list(corners)}Z" fill="${hex(color)}"${opacityOf('fill', opacity)}${rim}/>`);
  }

  disc(at: Point, radius: number, color: Color, opacity: number): void {
    this.spot(at, Math.max(0.8, radius * this.#scale), color, opacity);
  }

  /** A disc with a radius in pixels. */
  spot(at: Point, radius: number, color: Color, opacity = 1): void {
    const [x, y] = this.#pixel(at);
    this.#parts.push(
      `<circle cx="${x}" cy="${y}" r="${round(radius)}" fill="${hex(color)}"${opacityOf('fill', opacity)}/>`,
    );
  }

  #list(points: readonly Point[]): string {
    return points.map((point) => this.#pixel(point).join(' ')).join('L');
  }

  /** Depth is shown by moving a point aside and up, as in a drawing by hand. */
  #pixel(point: Point): [number, number] {
    const { x, y } = this.#frame.place(point);
    const depth = point.z ?? 0;
    const [dx, dy] = [x - this.#centre.x - 0.35 * depth, y - this.#centre.y - 0.2 * depth];
    return [round(WIDTH / 2 + this.#scale * dx), round(HEIGHT / 2 - this.#up * this.#scale * dy)];
  }
}

/** A box without width, height or depth is a wall that faces x, y or z. */
function cornersOf({ minX, maxX, minY, maxY, minZ = 0, maxZ = minZ }: ViewBox): Point[] {
  const depths =
    minX === maxX ? [minZ, minZ, maxZ, maxZ] : [minZ, minZ, minY === maxY ? maxZ : minZ, minY === maxY ? maxZ : minZ];
  const heights = minX === maxX ? [minY, maxY, maxY, minY] : [minY, minY, maxY, maxY];
  return [minX, maxX, maxX, minX].map((x, i) => ({ x, y: heights[i], z: depths[i] }));
}

const round = (value: number) => Math.round(10 * value) / 10;
const hex = (color: Color) => `#${color.toString(16).padStart(6, '0')}`;
const opacityOf = (what: 'fill' | 'stroke', opacity: number) =>
  opacity < 1 ? ` ${what}-opacity="${Math.round(100 * opacity) / 100}"` : '';

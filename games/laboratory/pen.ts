/** Draws the parts of a picture into a pixi graphics object, with widths in CSS pixels. */
import {
  type Arrow,
  COLORS,
  type Curve,
  type Dot,
  type Fill,
  type Frame,
  type Line,
  now,
  type Picture,
  type Point,
} from '@principia/scenes/examples';
import type { Graphics } from 'pixi.js';
import { gridLines } from './grid-lines.ts';

/** Length and half width of the head of an arrow, CSS pixels. */
const HEAD = { length: 10, width: 4.5 };
/** Shortest arrow that is drawn, CSS pixels. */
const MIN_ARROW = 3;
/** Half the width of a coil spring, CSS pixels. */
const COIL = 7;

export class Pen {
  readonly #graphics: Graphics;
  readonly #frame: Frame;
  /** CSS pixels per metre. */
  #scale = 1;

  constructor(graphics: Graphics, frame: Frame) {
    this.#graphics = graphics;
    this.#frame = frame;
  }

  /** Metres of a point of the picture. */
  place(point: Point): { x: number; y: number } {
    return this.#frame.place(point);
  }

  begin(scale: number): void {
    this.#graphics.clear();
    this.#scale = scale;
  }

  fill({ shape, color, opacity = 1 }: Fill): void {
    const style = { color, alpha: opacity };
    if ('radius' in shape) {
      const { x, y } = this.place(now(shape.centre));
      this.#graphics.poly(roundOutline(x, y, shape.radius)).fill(style);
    } else if ('minX' in shape) {
      const [a, b] = [this.place({ x: shape.minX, y: shape.minY }), this.place({ x: shape.maxX, y: shape.maxY })];
      this.#graphics.rect(a.x, a.y, b.x - a.x, b.y - a.y).fill(style);
    } else {
      this.#graphics.poly(now(shape).map((point) => this.place(point))).fill(style);
    }
  }

  line({ from, to, color = COLORS.white, width = 2, coils = 0 }: Line): void {
    const [a, b] = [this.place(now(from)), this.place(now(to))];
    const points = coils > 0 ? coilPoints(a, b, coils, COIL / this.#scale) : [a, b];
    this.#polyline(points, color, width);
  }

  curve({ points, color = COLORS.grey, dashed = false }: Curve): void {
    const placed = points.map((point) => this.place(point));
    if (!dashed) this.#polyline(placed, color, 1.5);
    else for (let i = 0; i + 1 < placed.length; i += 2) this.#polyline(placed.slice(i, i + 2), color, 1.5);
  }

  ring(at: Point, color: number = COLORS.grey, radius = 5 / this.#scale): void {
    const { x, y } = this.place(at);
    this.#graphics.poly(roundOutline(x, y, radius)).stroke({ color, width: 2 / this.#scale });
  }

  dot({ at, radius = 6, color = COLORS.orange }: Dot): void {
    const { x, y } = this.place(now(at));
    this.#graphics.poly(roundOutline(x, y, radius / this.#scale)).fill({ color });
  }

  /** @returns the tip, m; undefined if the arrow is too short to be seen */
  arrow({ from, vector, scale = 1, color = COLORS.green }: Arrow): { x: number; y: number } | undefined {
    const a = now(from);
    const v = vector();
    const [start, tip] = [this.place(a), this.place({ x: a.x + scale * v.x, y: a.y + scale * v.y })];
    const [dx, dy] = [tip.x - start.x, tip.y - start.y];
    const length = Math.hypot(dx, dy);
    if (!(length * this.#scale > MIN_ARROW)) return undefined;
    const [ux, uy] = [dx / length, dy / length];
    const head = Math.min(HEAD.length / this.#scale, length);
    const half = (HEAD.width / this.#scale) * (head / (HEAD.length / this.#scale));
    const neck = { x: tip.x - head * ux, y: tip.y - head * uy };
    this.#polyline([start, neck], color, 2.5);
    const wing = (side: number) => ({ x: neck.x - side * half * uy, y: neck.y + side * half * ux });
    this.#graphics.poly([tip, wing(1), wing(-1)]).fill({ color });
    return tip;
  }

  /** Grid lines and axes of a graph. */
  grid({ view, graph }: Picture): void {
    const { minX, maxX, minY, maxY } = view;
    const line = (a: Point, b: Point, isAxis: boolean) =>
      this.#polyline([this.place(a), this.place(b)], isAxis ? 0x97a3c7 : 0x3a4470, isAxis ? 1.5 : 1);
    for (const x of gridLines(minX, maxX, graph?.x.step)) line({ x, y: minY }, { x, y: maxY }, x === 0);
    for (const y of gridLines(minY, maxY, graph?.y.step)) line({ x: minX, y }, { x: maxX, y }, y === 0);
  }

  #polyline(points: readonly { x: number; y: number }[], color: number, width: number): void {
    if (points.length < 2) return;
    this.#graphics.moveTo(points[0].x, points[0].y);
    for (let i = 1; i < points.length; i++) this.#graphics.lineTo(points[i].x, points[i].y);
    this.#graphics.stroke({ color, width: width / this.#scale, join: 'round' });
  }
}

/** A zigzag between two points with straight ends, which looks like a coil spring from the side. */
function coilPoints(a: { x: number; y: number }, b: { x: number; y: number }, coils: number, half: number) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const length = Math.hypot(dx, dy) || 1;
  const [nx, ny] = [(-dy / length) * half, (dx / length) * half];
  const at = (share: number, side: number) => ({ x: a.x + share * dx + side * nx, y: a.y + share * dy + side * ny });
  const points = [a, at(0.08, 0)];
  for (let i = 0; i < 2 * coils; i++) points.push(at(0.08 + (0.84 * (i + 0.5)) / (2 * coils), i % 2 === 0 ? 1 : -1));
  return [...points, at(0.92, 0), b];
}

/** Corners of a disc. pixi.js would take fewer of them for a disc that is small in metres, however large in pixels. */
function roundOutline(x: number, y: number, radius: number): { x: number; y: number }[] {
  return Array.from({ length: 48 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 48;
    return { x: x + radius * Math.cos(angle), y: y + radius * Math.sin(angle) };
  });
}

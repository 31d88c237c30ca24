/** Draws the picture of an example with pixi.js: layers for bodies and trails, graphics for everything else. */

import type { BodySource } from '@principia/render-core';
import { createBodyLayer, createTrailLayer } from '@principia/render-pixi';
import { COLORS, type ExampleRun, type Fill, frameOf, now, type Point } from '@principia/scenes/examples';
import type { Picture as PixiPicture } from '@principia/shell/pixi';
import { Container, Graphics } from 'pixi.js';
import type { LabRun, Trailing } from './lab-run.ts';
import { Pen } from './pen.ts';
import type { Shown } from './shown.ts';
import { TextLayer } from './text-layer.ts';

/** @param shown the values of the switches of what is shown @param aim the line along which a pointer aims, if it does */
export function drawPicture(
  run: LabRun,
  source: BodySource,
  shown: () => Shown,
  aim: () => { readonly from: Point; readonly to: Point } | undefined,
): PixiPicture & Trailing {
  const { picture } = run;
  const frame = frameOf(picture);
  const container = new Container();
  const body = createBodyLayer({ source, minimumPixels: 2, rimWidth: 1 });
  const { minX, maxX, minY, maxY } = picture.view;
  // A body that went further between two frames was moved by many steps at once.
  const maxSegment = Math.hypot(maxX - minX, maxY - minY) / 6;
  const trails = (picture.trails ?? []).map(({ body: id, length = 600, interval = 1, color }) => {
    const options = { source, bodies: [id], length, interval, maxSegment };
    return createTrailLayer(color === undefined ? options : { ...options, color });
  });
  const [back, springs, front, marks] = [0, 1, 2, 3].map(() => upright());
  const texts = new TextLayer(picture.yDown ?? false);
  container.addChild(back, ...trails.map((trail) => trail.container), springs, body.container, front, marks);
  container.addChild(texts.container);
  texts.container.scale.y = -1;
  const still = [new Pen(back, frame), new Pen(front, frame)] as const;
  const [coils, live] = [new Pen(springs, frame), new Pen(marks, frame)];
  let scale = 0;
  return {
    container,
    update(alpha, pixelsPerMetre) {
      // Widths are in pixels, so what stands still is drawn again when the scale changes noticeably.
      if (Math.abs(scale / pixelsPerMetre - 1) > 0.02) {
        scale = pixelsPerMetre;
        drawStill(run, still, scale);
      }
      for (const trail of trails) {
        trail.update(alpha);
        trail.container.visible = shown().trails !== false;
      }
      body.update(alpha);
      drawSprings(run, coils, pixelsPerMetre);
      drawLive(run, live, texts, pixelsPerMetre, shown());
      const line = aim();
      if (line !== undefined) live.line({ ...line, color: COLORS.yellow });
    },
    recordTrails() {
      for (const trail of trails) trail.update(1);
    },
    destroy() {
      for (const layer of [...trails, body]) layer.destroy();
      texts.destroy();
      container.destroy({ children: true });
    },
  };
}

/** Graphics in the coordinates of the world: layers of bodies turn the y axis themselves. */
function upright(): Graphics {
  const graphics = new Graphics();
  graphics.scale.y = -1;
  return graphics;
}

const isLive = (...values: unknown[]) => values.some((value) => typeof value === 'function');

const moves = ({ shape }: Fill) => isLive('radius' in shape ? shape.centre : shape);

/** Regions, lines, curves and axes that do not move. */
function drawStill({ picture }: ExampleRun, [back, front]: readonly [Pen, Pen], scale: number): void {
  for (const pen of [back, front]) pen.begin(scale);
  for (const fill of picture.fills ?? []) {
    if (!moves(fill)) (fill.inFront ? front : back).fill(fill);
  }
  if (picture.graph !== undefined) back.grid(picture);
  for (const curve of picture.curves ?? []) back.curve(curve);
  for (const line of picture.lines ?? []) if (!isLive(line.from, line.to)) back.line(line);
}

function drawSprings({ picture, world }: ExampleRun, pen: Pen, scale: number): void {
  pen.begin(scale);
  for (const line of picture.lines ?? []) if (isLive(line.from, line.to)) pen.line(line);
  if (picture.springs === undefined) return;
  const { Spring, Position } = world.components;
  const coils = picture.springs === 'lines' ? {} : picture.springs;
  const at = (id: number): Point => ({ x: Position.x[id], y: Position.y[id] });
  for (let id = 1; id <= world.lastId; id++) {
    if (Spring.a[id] !== 0) pen.line({ from: at(Spring.a[id]), to: at(Spring.b[id]), ...coils });
  }
}

/** Arrows, dots, exact positions and texts, as they are now. */
function drawLive(run: LabRun, pen: Pen, texts: TextLayer, scale: number, shown: Shown): void {
  const { picture, world } = run;
  pen.begin(scale);
  texts.begin(scale);
  for (const fill of picture.fills ?? []) {
    if (moves(fill)) pen.fill(fill);
  }
  drawGhosts(run, pen, texts, scale);
  for (const curve of picture.curves ?? []) {
    const at = curve.now?.(world.time);
    if (at === undefined) continue;
    pen.ring(at, curve.color, curve.markRadius);
    if (curve.label !== undefined)
      texts.write(pen.place(at), curve.label, curve.color, (curve.markRadius ?? 5 / scale) + 3 / scale);
  }
  for (const arrow of shown.arrows === false ? [] : (picture.arrows ?? [])) {
    const tip = pen.arrow(arrow);
    if (tip !== undefined) texts.write(tip, arrow.label, arrow.color, 4 / scale);
  }
  for (const dot of picture.dots ?? []) pen.dot(dot);
  for (const { at, text, color } of picture.labels ?? []) texts.write(pen.place(now(at)), now(text), color, 0);
  if (picture.graph !== undefined) texts.axes(picture, pen);
  texts.end();
}

/** The bodies of ghosts as rings, with their paths, in a colour of their own. */
function drawGhosts({ ghosts, picture }: LabRun, pen: Pen, texts: TextLayer, scale: number): void {
  // The exact position has its name in the first row.
  const first = picture.curves?.some(({ now, label }) => now !== undefined && label !== undefined) ? 1 : 0;
  for (const [i, { run, color, label, bodies, path }] of ghosts.members.entries()) {
    const row = first + i;
    const { Position, Collider, Appearance } = run.world.components;
    pen.curve({ points: path, color });
    for (const [index, id] of bodies.entries()) {
      const radius = Math.max(Appearance.size[id] || Collider.radius[id], 3 / scale);
      const at = { x: Position.x[id], y: Position.y[id] };
      pen.ring(at, color, radius);
      if (index === 0) texts.write(pen.place(at), label, color, radius + 2 / scale, row);
    }
  }
}

/** Draws the picture of an example with three.js: bodies, trails, lines, curves, arrows and flat regions. */
import type { BodySource } from '@principia/render-core';
import { createBodyMesh, createSegmentLines, createTrailLines, type SegmentLines } from '@principia/render-three';
import { type Arrow, COLORS, type Color, type Fill, now, type Picture, type Point } from '@principia/scenes/examples';
import type { ThreePicture } from '@principia/shell/three';
import {
  type BufferGeometry,
  DirectionalLight,
  DoubleSide,
  Group,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  type Object3D,
  PlaneGeometry,
  SphereGeometry,
  Vector3,
} from 'three';
import type { LabRun, Trailing } from './lab-run.ts';
import { LabelSprites } from './label-sprites.ts';
import type { Shown } from './shown.ts';

const MAX_TRAIL = 2000;

/** @param shown the values of the switches of what is shown */
export function drawPicture3D(run: LabRun, source: BodySource, shown: () => Shown): ThreePicture & Trailing {
  const { picture } = run;
  const bodies = createBodyMesh({ source, material: new MeshStandardMaterial({ roughness: 0.45 }) });
  const trails = (picture.trails ?? []).map(({ body, length = 600, interval = 1, color }) =>
    createTrailLines({
      source,
      bodies: [body],
      length: Math.min(length, MAX_TRAIL),
      interval,
      ...(color === undefined ? {} : { color }),
    }),
  );
  const still = createSegmentLines({ width: 2 });
  const live = createSegmentLines({ width: 2.5 });
  const labels = new LabelSprites();
  const solids = (picture.fills ?? []).flatMap((fill) => solidOf(fill).map((mesh) => ({ mesh, fill })));
  drawStill(picture, still);
  const object = new Group().add(
    bodies.object,
    still.object,
    live.object,
    labels.object,
    ...solids.map(({ mesh }) => mesh),
    ...lamps(picture),
  );
  for (const trail of trails) object.add(trail.object);
  return {
    object,
    update(alpha) {
      for (const trail of trails) {
        trail.update(alpha);
        trail.object.visible = shown().trails !== false;
      }
      bodies.update(alpha);
      for (const { mesh, fill } of solids) if ('centre' in fill.shape) placeAt(mesh, now(fill.shape.centre));
      drawLive(run, live, shown());
      writeLabels(picture, labels, shown());
    },
    recordTrails() {
      for (const trail of trails) trail.update(1);
    },
    destroy() {
      for (const part of [...trails, still, live, bodies, labels]) part.destroy();
      for (const { mesh } of solids) {
        mesh.geometry.dispose();
        mesh.material.dispose();
      }
    },
  };
}

/** Daylight from above, and a lamp at the upper left in front. */
function lamps({ view }: Picture): Object3D[] {
  const lamp = new DirectionalLight(0xfff4e0, 2.4);
  lamp.target.position.set((view.minX + view.maxX) / 2, (view.minY + view.maxY) / 2, 0);
  lamp.position.set(-0.5, 1, 0.8).add(lamp.target.position);
  return [new HemisphereLight(0xdfe6ff, 0x4a4270, 1.6), lamp, lamp.target];
}

/** A box among the fills is a plane, upright or level, and a disc a ball; polygons are for pictures of two dimensions. */
function solidOf({ shape, color, opacity = 1 }: Fill): Mesh<BufferGeometry, MeshBasicMaterial>[] {
  if ('centre' in shape) return [new Mesh(new SphereGeometry(shape.radius, 48, 24), new MeshBasicMaterial({ color }))];
  if (!('minX' in shape)) return [];
  const { minX, maxX, minY, maxY, minZ = 0, maxZ = 0 } = shape;
  const material = new MeshBasicMaterial({ color, side: DoubleSide, transparent: opacity < 1, opacity });
  const [width, height, depth] = [maxX - minX, maxY - minY, maxZ - minZ];
  const geometry = new PlaneGeometry(width || depth, height || depth);
  const plane = new Mesh(geometry, material);
  if (height === 0) plane.rotation.x = -Math.PI / 2;
  else if (width === 0) plane.rotation.y = Math.PI / 2;
  plane.position.set((minX + maxX) / 2, (minY + maxY) / 2, (minZ + maxZ) / 2);
  return [plane];
}

function placeAt({ position }: Object3D, { x, y, z = 0 }: Point): void {
  position.set(x, y, z);
}

/** RGBA bytes in memory order. */
const bytesOf = (color: Color) => (0xff000000 | ((color & 255) << 16) | (color & 0xff00) | ((color >> 16) & 255)) >>> 0;

function add(lines: SegmentLines, a: Point, b: Point, color: Color): void {
  lines.add(a.x, a.y, a.z ?? 0, b.x, b.y, b.z ?? 0, bytesOf(color));
}

function drawStill({ lines = [], curves = [] }: Picture, out: SegmentLines): void {
  for (const { from, to, color = COLORS.white } of lines) {
    if (typeof from !== 'function' && typeof to !== 'function') add(out, from, to, color);
  }
  for (const { points, color = COLORS.grey, dashed = false } of curves) {
    for (let i = 0; i + 1 < points.length; i += dashed ? 2 : 1) add(out, points[i], points[i + 1], color);
  }
}

function drawLive({ picture, world, ghosts }: LabRun, out: SegmentLines, shown: Shown): void {
  const { lines = [], curves = [], arrows = [], dots = [], view } = picture;
  const size = 0.012 * (view.maxX - view.minX);
  out.clear();
  for (const { from, to, color = COLORS.white } of lines) {
    if (typeof from === 'function' || typeof to === 'function') add(out, now(from), now(to), color);
  }
  for (const { from, vector, scale = 1, color = COLORS.green } of shown.arrows === false ? [] : arrows) {
    arrow(out, now(from), tipOf({ from, vector, scale }), 2 * size, color);
  }
  for (const curve of curves) if (curve.now) cross(out, curve.now(world.time), 2 * size, curve.color ?? COLORS.grey);
  for (const { at, color = COLORS.orange } of dots) cross(out, now(at), size, color);
  for (const { run, color, bodies, path } of ghosts.members) {
    for (let i = 0; i + 1 < path.length; i++) add(out, path[i], path[i + 1], color);
    for (const id of bodies) cross(out, placeOf(run, id), 2 * size, color);
  }
  if (picture.springs === undefined) return;
  const { Spring } = world.components;
  const place = (id: number) => placeOf({ world }, id);
  for (let id = 1; id <= world.lastId; id++) {
    if (Spring.a[id] !== 0) add(out, place(Spring.a[id]), place(Spring.b[id]), COLORS.white);
  }
}

type ArrowEnds = Pick<Arrow, 'from' | 'vector' | 'scale'>;

function tipOf({ from, vector, scale = 1 }: ArrowEnds): Required<Point> {
  const [a, v] = [now(from), vector()];
  return { x: a.x + scale * v.x, y: a.y + scale * v.y, z: (a.z ?? 0) + scale * (v.z ?? 0) };
}

/** An arrow whose head is four short lines. @param head their length, m, if the arrow is at least three times as long */
function arrow(out: SegmentLines, from: Point, tip: Required<Point>, head: number, color: Color): void {
  add(out, from, tip, color);
  const way = new Vector3(tip.x - from.x, tip.y - from.y, tip.z - (from.z ?? 0));
  const length = Math.min(head, way.length() / 3);
  if (length === 0) return;
  way.normalize();
  const side = new Vector3(...(Math.abs(way.z) < 0.9 ? [0, 0, 1] : [1, 0, 0])).cross(way).normalize();
  const other = side.clone().cross(way);
  for (const axis of [side, side.clone().negate(), other, other.clone().negate()]) {
    add(
      out,
      tip,
      axis
        .multiplyScalar(0.4)
        .sub(way)
        .multiplyScalar(length)
        .add(new Vector3(tip.x, tip.y, tip.z)),
      color,
    );
  }
}

/** The names of arrows and exact places, and the texts of the picture. */
function writeLabels({ arrows = [], labels = [] }: Picture, out: LabelSprites, shown: Shown): void {
  out.begin();
  for (const each of shown.arrows === false ? [] : arrows)
    out.write(tipOf(each), each.label, each.color ?? COLORS.green);
  for (const { at, text, color } of labels) out.write(now(at), now(text), color);
  out.end();
}

function placeOf({ world }: Pick<LabRun, 'world'>, id: number): Point {
  const { x, y, z } = world.components.Position;
  return { x: x[id], y: y[id], z: z[id] };
}

/** Marks a point by three short lines. */
function cross(out: SegmentLines, { x, y, z = 0 }: Point, size: number, color: Color): void {
  add(out, { x: x - size, y, z }, { x: x + size, y, z }, color);
  add(out, { x, y: y - size, z }, { x, y: y + size, z }, color);
  add(out, { x, y, z: z - size }, { x, y, z: z + size }, color);
}

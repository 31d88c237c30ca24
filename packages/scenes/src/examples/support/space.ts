/** Rotations in three dimensions, and wire figures that show them. */
import { cos, type PhysicsWorld, sin } from '@principia/physics';
import type { Color, Line, Point } from '../picture.ts';
import { lengthOf, positionOf } from './read.ts';

export type Point3 = Required<Point>;
export interface Quaternion extends Point3 {
  readonly w: number;
}

export const point = (x: number, y: number, z: number): Point3 => ({ x, y, z });

export const plus = (a: Point3, b: Point3): Point3 => point(a.x + b.x, a.y + b.y, a.z + b.z);
export const times = (a: Point3, factor: number): Point3 => point(a.x * factor, a.y * factor, a.z * factor);
export const dot = (a: Point3, b: Point3): number => a.x * b.x + a.y * b.y + a.z * b.z;

export function cross(a: Point3, b: Point3): Point3 {
  return point(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/** The rotation by an angle, rad, about an axis of any length: (u sin θ/2, cos θ/2). */
export function rotationAbout(axis: Point3, angle: number): Quaternion {
  return { ...times(axis, sin(angle / 2) / lengthOf(axis)), w: cos(angle / 2) };
}

/** The product p q, which is the rotation q followed by p. */
export function product(p: Quaternion, q: Quaternion): Quaternion {
  return {
    x: p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
    y: p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x,
    z: p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w,
    w: p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z,
  };
}

/** The rotation back. */
export const inverse = ({ x, y, z, w }: Quaternion): Quaternion => ({ x: -x, y: -y, z: -z, w });

/** The norm, which is 1 for a rotation. */
export const normOf = ({ x, y, z, w }: Quaternion): number => Math.sqrt(x * x + y * y + z * z + w * w);

/** The point turned by the rotation, q v q*. */
export function rotate(q: Quaternion, v: Point3): Point3 {
  const { x, y, z } = product(product(q, { ...v, w: 0 }), inverse(q));
  return { x, y, z };
}

/** The orientation of a body. */
export function orientationOf({ components: { Orientation } }: PhysicsWorld, id: number): Quaternion {
  return { x: Orientation.x[id], y: Orientation.y[id], z: Orientation.z[id], w: Orientation.w[id] };
}

/** Where a point of the body's own frame is in the world. */
export function pointOn(world: PhysicsWorld, id: number, local: Point3): Point3 {
  return plus(positionOf(world, id), rotate(orientationOf(world, id), local));
}

/** The twelve edges of a cube; `place` says where its points are now. */
export function cubeEdges(halfWidth: number, place: (local: Point3) => Point3, color: Color): Line[] {
  return boxEdges(point(halfWidth, halfWidth, halfWidth), place, color);
}

/** The twelve edges of a box, from half its width, height and depth. */
export function boxEdges({ x, y, z }: Point3, place: (local: Point3) => Point3, color: Color): Line[] {
  const corner = (i: number) => point(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z);
  return Array.from({ length: 8 }, (_, i) => i).flatMap((i) =>
    [1, 2, 4]
      .filter((bit) => (i & bit) === 0)
      .map((bit) => ({ from: () => place(corner(i)), to: () => place(corner(i | bit)), color })),
  );
}

/** Meridians and the equator of a globe about its y axis. */
export function globeLines(radius: number, place: (local: Point3) => Point3, color: Color): Line[] {
  const on = (latitude: number, longitude: number) =>
    point(radius * cos(latitude) * cos(longitude), radius * sin(latitude), radius * cos(latitude) * sin(longitude));
  const piece = (a: Point3, b: Point3) => ({ from: () => place(a), to: () => place(b), color });
  const [parts, step] = [24, Math.PI / 12];
  const equator = Array.from({ length: parts }, (_, i) => piece(on(0, i * step), on(0, (i + 1) * step)));
  const meridians = [0, 1, 2, 3, 4, 5].flatMap((m) =>
    Array.from({ length: parts / 2 }, (_, i) =>
      piece(on(-Math.PI / 2 + i * step, (m * Math.PI) / 3), on(-Math.PI / 2 + (i + 1) * step, (m * Math.PI) / 3)),
    ),
  );
  return [...equator, ...meridians];
}

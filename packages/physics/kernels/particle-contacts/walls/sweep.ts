// A disc on its way through a step, and the first wall it meets.
//
// The path is looked at from its end, where the body is: a time s earlier it was at p - u s + a s^2 / 2. Against the
// flat of a wall the formula of impact.ts gives the instant; against an end, that of touch.ts. Whatever was met longest
// ago was met first. The side a body is on is the one its path began on, so no speed takes it through.
import { touch, touchTime } from '../time-of-impact';
import { word } from '../table';
import { impactSpeed, timeSince } from './impact';
import { Segment, WallGrid, columnX, columnY, segment } from './wall-grid';

// The path: end, velocity and acceleration there, beginning, duration; and the radius.
@unmanaged
class Path {
  x: real;
  y: real;
  ux: real;
  uy: real;
  ax: real;
  ay: real;
  fromX: real;
  fromY: real;
  duration: real;
  radius: real;
}

// What was met first: index of the wall, -1 for none; whether it was an end of the wall; time since; normal out of it;
// speed into it then; and how far the end of the path lies beyond the surface, along that normal.
@unmanaged
class Hit {
  wall: i32;
  isEnd: bool;
  since: real;
  x: real;
  y: real;
  speed: real;
  depth: real;
}

// The path that is followed, and the result of the last `findHit`.
export const path = changetype<Path>(memory.data(offsetof<Path>(), 8));
export const hit = changetype<Hit>(memory.data(offsetof<Hit>(), 8));

export function setPath(x: real, y: real, ux: real, uy: real, ax: real, ay: real): void {
  path.x = x;
  path.y = y;
  path.ux = ux;
  path.uy = uy;
  path.ax = ax;
  path.ay = ay;
}

export function setStart(x: real, y: real, time: real, size: real): void {
  path.fromX = x;
  path.fromY = y;
  path.duration = time;
  path.radius = size;
}

// Finds the first hit among the walls near the path, but for the wall `last` it comes from: rounding may leave the body
// a hair inside that one.
export function findHit(g: WallGrid, last: i32): void {
  hit.wall = -1;
  hit.since = -1;
  const left = min<real>(path.x, path.fromX) - path.radius;
  const right = max<real>(path.x, path.fromX) + path.radius;
  const bottom = min<real>(path.y, path.fromY) - path.radius;
  const top = max<real>(path.y, path.fromY) + path.radius;
  const lastX = columnX(g, right);
  const lastY = columnY(g, top);
  for (let y = columnY(g, bottom); y <= lastY; y++) {
    for (let x = columnX(g, left); x <= lastX; x++) {
      const cell = y * g.side + x;
      const end = word(g.starts, cell + 1);
      for (let k = word(g.starts, cell); k < end; k++) {
        const i = word(g.items, k);
        const s = segment(g, i);
        if (i != last && s.minX <= right && s.maxX >= left && s.minY <= top && s.maxY >= bottom) meet(s, i);
      }
    }
  }
}

function meet(s: Segment, i: i32): void {
  meetFlat(s, i);
  meetEnd(s.ax, s.ay, i);
  meetEnd(s.ax + s.tx * s.length, s.ay + s.ty * s.length, i);
}

// An earlier hit replaces a later one; of two at once, the wall with the smaller id stays.
// @ts-ignore: decorator
@inline function keep(i: i32, since: real, x: real, y: real, speed: real, depth: real, end: bool): void {
  if (since < hit.since || (since == hit.since && i >= hit.wall)) return;
  hit.wall = i;
  hit.since = since;
  hit.x = x;
  hit.y = y;
  hit.speed = speed;
  hit.depth = depth;
  hit.isEnd = end;
}

function meetFlat(s: Segment, i: i32): void {
  if (!(s.length > 0)) return;
  let nx = -s.ty;
  let ny = s.tx;
  const before = (path.fromX - s.ax) * nx + (path.fromY - s.ay) * ny;
  if (before < 0 || (before == 0 && path.ux * nx + path.uy * ny < 0)) {
    nx = -nx;
    ny = -ny;
  }
  const depth = path.radius - ((path.x - s.ax) * nx + (path.y - s.ay) * ny);
  const speed = -(path.ux * nx + path.uy * ny);
  if (!(depth > 0 && speed > 0)) return;
  const pull = -(path.ax * nx + path.ay * ny);
  const since = timeSince<real>(depth, speed, pull, path.duration);
  const half = <real>0.5 * since;
  const x = path.x - since * (path.ux - half * path.ax) - s.ax;
  const y = path.y - since * (path.uy - half * path.ay) - s.ay;
  const along = x * s.tx + y * s.ty;
  if (along >= 0 && along <= s.length) keep(i, since, nx, ny, impactSpeed<real>(speed, pull, since), depth, false);
}

function meetEnd(x: real, y: real, i: i32): void {
  const dx = path.x - x;
  const dy = path.y - y;
  const since = touchTime(dx, dy, 0, path.ux, path.uy, 0, path.ax, path.ay, 0, path.radius, path.duration);
  if (since >= 0 && touch.speed > 0) {
    keep(i, since, touch.x, touch.y, touch.speed, path.radius - (dx * touch.x + dy * touch.y), true);
  }
}

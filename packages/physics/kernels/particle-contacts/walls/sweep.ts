// A disc on its way through a step, and the first wall it meets.
//
// The path is looked at from its end, where the body is: a time s earlier it was at p - u s + a s^2 / 2. Against the
// flat of a wall the formula of impact.ts gives the instant; against an end, that of touch.ts. Whatever was met longest
// ago was met first. The side a body is on is the one its path began on, so no speed takes it through.
import { touchSpeed, touchTime, touchX, touchY } from '../time-of-impact';
import { word } from '../table';
import { impactSpeed, timeSince } from './impact';
import { Segment, WallGrid, columnX, columnY, segment } from './wall-grid';

// The path: end, velocity and acceleration there, beginning, duration; and the radius.
export let pX: real = 0;
export let pY: real = 0;
export let uX: real = 0;
export let uY: real = 0;
export let aX: real = 0;
export let aY: real = 0;
export let fromX: real = 0;
export let fromY: real = 0;
export let duration: real = 0;
export let radius: real = 0;

// What was met first: index of the wall, -1 for none; time since; normal out of it; speed into it then; and how far the
// end of the path lies beyond the surface, along that normal.
export let hitWall: i32 = -1;
export let hitSince: real = 0;
export let hitX: real = 0;
export let hitY: real = 0;
export let hitSpeed: real = 0;
export let hitDepth: real = 0;
// Whether it was an end of the wall.
export let hitEnd: bool = false;

export function setPath(x: real, y: real, ux: real, uy: real, ax: real, ay: real): void {
  pX = x;
  pY = y;
  uX = ux;
  uY = uy;
  aX = ax;
  aY = ay;
}

export function setStart(x: real, y: real, time: real, size: real): void {
  fromX = x;
  fromY = y;
  duration = time;
  radius = size;
}

// Finds the first hit among the walls near the path, but for the wall `last` it comes from: rounding may leave the body
// a hair inside that one.
export function findHit(g: WallGrid, last: i32): void {
  hitWall = -1;
  hitSince = -1;
  const left = min<real>(pX, fromX) - radius;
  const right = max<real>(pX, fromX) + radius;
  const bottom = min<real>(pY, fromY) - radius;
  const top = max<real>(pY, fromY) + radius;
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
  if (since < hitSince || (since == hitSince && i >= hitWall)) return;
  hitWall = i;
  hitSince = since;
  hitX = x;
  hitY = y;
  hitSpeed = speed;
  hitDepth = depth;
  hitEnd = end;
}

function meetFlat(s: Segment, i: i32): void {
  if (!(s.length > 0)) return;
  let nx = -s.ty;
  let ny = s.tx;
  const before = (fromX - s.ax) * nx + (fromY - s.ay) * ny;
  if (before < 0 || (before == 0 && uX * nx + uY * ny < 0)) {
    nx = -nx;
    ny = -ny;
  }
  const depth = radius - ((pX - s.ax) * nx + (pY - s.ay) * ny);
  const speed = -(uX * nx + uY * ny);
  if (!(depth > 0 && speed > 0)) return;
  const pull = -(aX * nx + aY * ny);
  const since = timeSince<real>(depth, speed, pull, duration);
  const half = <real>0.5 * since;
  const x = pX - since * (uX - half * aX) - s.ax;
  const y = pY - since * (uY - half * aY) - s.ay;
  const along = x * s.tx + y * s.ty;
  if (along >= 0 && along <= s.length) keep(i, since, nx, ny, impactSpeed<real>(speed, pull, since), depth, false);
}

function meetEnd(x: real, y: real, i: i32): void {
  const dx = pX - x;
  const dy = pY - y;
  const since = touchTime(dx, dy, 0, uX, uY, 0, aX, aY, 0, radius, duration);
  if (since >= 0 && touchSpeed > 0) {
    keep(i, since, touchX, touchY, touchSpeed, radius - (dx * touchX + dy * touchY), true);
  }
}

// The path of a disc through a step, and the first wall it hits.
//
// Times are measured back from the end of the path: a time s earlier the body was at p - u s + a s^2 / 2. The hit on
// the face of a wall follows impact.ts, the hit on an end point time-of-impact.ts. The hit with the largest time back
// happened first. A body stays on the side where its path began, so no speed lets it tunnel.
import { roundImpact, timeSinceRoundImpact } from '../time-of-impact';
import { word } from '../table';
import { computeImpactSpeed, computeTimeSinceImpact } from './impact';
import { Segment, WallGrid, columnX, columnY, segment } from './wall-grid';

// The path: end position, velocity and acceleration there, start position, duration; and the radius of the disc.
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

// The first hit: index of the wall (-1 if none), whether it is on an end point of the wall, time since the hit, normal
// out of the wall, speed into the wall, and the depth of the path's end beyond the surface along that normal.
@unmanaged
class Hit {
  wall: i32;
  isEnd: bool;
  timeSinceImpact: real;
  nx: real;
  ny: real;
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

// Finds the first hit among the walls near the path. The wall `last` that the path comes from is skipped, because
// rounding may leave the body slightly inside it.
export function findHit(g: WallGrid, last: i32): void {
  hit.wall = -1;
  hit.timeSinceImpact = -1;
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
        if (i != last && s.minX <= right && s.maxX >= left && s.minY <= top && s.maxY >= bottom) testSegment(s, i);
      }
    }
  }
}

function testSegment(s: Segment, i: i32): void {
  testFace(s, i);
  testEnd(s.ax, s.ay, i);
  testEnd(s.ax + s.tx * s.length, s.ay + s.ty * s.length, i);
}

// An earlier hit replaces a later one; of simultaneous hits, the wall with the smaller id is kept.
// @ts-ignore: decorator
@inline function keepEarliest(
  i: i32,
  timeSinceImpact: real,
  x: real,
  y: real,
  speed: real,
  depth: real,
  end: bool,
): void {
  if (timeSinceImpact < hit.timeSinceImpact || (timeSinceImpact == hit.timeSinceImpact && i >= hit.wall)) return;
  hit.wall = i;
  hit.timeSinceImpact = timeSinceImpact;
  hit.nx = x;
  hit.ny = y;
  hit.speed = speed;
  hit.depth = depth;
  hit.isEnd = end;
}

function testFace(s: Segment, i: i32): void {
  if (!(s.length > 0)) return;
  let nx = -s.ty;
  let ny = s.tx;
  const startDistance = (path.fromX - s.ax) * nx + (path.fromY - s.ay) * ny;
  if (startDistance < 0 || (startDistance == 0 && path.ux * nx + path.uy * ny < 0)) {
    nx = -nx;
    ny = -ny;
  }
  const depth = path.radius - ((path.x - s.ax) * nx + (path.y - s.ay) * ny);
  const speed = -(path.ux * nx + path.uy * ny);
  if (!(depth > 0 && speed > 0)) return;
  const acceleration = -(path.ax * nx + path.ay * ny);
  const timeSinceImpact = computeTimeSinceImpact<real>(depth, speed, acceleration, path.duration);
  const half = <real>0.5 * timeSinceImpact;
  const x = path.x - timeSinceImpact * (path.ux - half * path.ax) - s.ax;
  const y = path.y - timeSinceImpact * (path.uy - half * path.ay) - s.ay;
  const along = x * s.tx + y * s.ty;
  if (along >= 0 && along <= s.length)
    keepEarliest(
      i,
      timeSinceImpact,
      nx,
      ny,
      computeImpactSpeed<real>(speed, acceleration, timeSinceImpact),
      depth,
      false,
    );
}

function testEnd(x: real, y: real, i: i32): void {
  const dx = path.x - x;
  const dy = path.y - y;
  const timeSinceImpact = timeSinceRoundImpact(
    dx,
    dy,
    0,
    path.ux,
    path.uy,
    0,
    path.ax,
    path.ay,
    0,
    path.radius,
    path.duration,
  );
  if (timeSinceImpact >= 0 && roundImpact.speed > 0) {
    keepEarliest(
      i,
      timeSinceImpact,
      roundImpact.nx,
      roundImpact.ny,
      roundImpact.speed,
      path.radius - (dx * roundImpact.nx + dy * roundImpact.ny),
      true,
    );
  }
}

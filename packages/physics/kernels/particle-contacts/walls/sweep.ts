// The path of a disc through a step, and the first wall it hits.
//
// Times are measured back from the end of the path: a time s earlier the body was at p - u s + a s^2 / 2. The hit on
// the face of a wall follows impact.ts, the hit on an end point time-of-impact.ts. The hit with the largest time back
// happened first. A body stays on the side where its path began, so no speed lets it tunnel.
import { impactNormalSpeed, roundTimeSinceImpact, impactNormalX, impactNormalY } from '../time-of-impact';
import { word } from '../table';
import { computeImpactSpeed, computeTimeSinceImpact } from './impact';
import { Segment, WallGrid, columnX, columnY, segment } from './wall-grid';

// The path: end position, velocity and acceleration there, start position, duration; and the radius of the disc.
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

// The first hit: index of the wall (-1 if none), time since the hit, normal out of the wall, speed into the wall, and
// the depth of the path's end beyond the surface along that normal.
export let hitWall: i32 = -1;
export let hitSince: real = 0;
export let hitX: real = 0;
export let hitY: real = 0;
export let hitSpeed: real = 0;
export let hitDepth: real = 0;
// True if the hit was on an end point of the wall.
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

// Finds the first hit among the walls near the path. The wall `last` that the path comes from is skipped, because
// rounding may leave the body slightly inside it.
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
@inline function keepEarliest(i: i32, timeSinceImpact: real, x: real, y: real, speed: real, depth: real, end: bool): void {
  if (timeSinceImpact < hitSince || (timeSinceImpact == hitSince && i >= hitWall)) return;
  hitWall = i;
  hitSince = timeSinceImpact;
  hitX = x;
  hitY = y;
  hitSpeed = speed;
  hitDepth = depth;
  hitEnd = end;
}

function testFace(s: Segment, i: i32): void {
  if (!(s.length > 0)) return;
  let nx = -s.ty;
  let ny = s.tx;
  const startDistance = (fromX - s.ax) * nx + (fromY - s.ay) * ny;
  if (startDistance < 0 || (startDistance == 0 && uX * nx + uY * ny < 0)) {
    nx = -nx;
    ny = -ny;
  }
  const depth = radius - ((pX - s.ax) * nx + (pY - s.ay) * ny);
  const speed = -(uX * nx + uY * ny);
  if (!(depth > 0 && speed > 0)) return;
  const acceleration = -(aX * nx + aY * ny);
  const timeSinceImpact = computeTimeSinceImpact<real>(depth, speed, acceleration, duration);
  const half = <real>0.5 * timeSinceImpact;
  const x = pX - timeSinceImpact * (uX - half * aX) - s.ax;
  const y = pY - timeSinceImpact * (uY - half * aY) - s.ay;
  const along = x * s.tx + y * s.ty;
  if (along >= 0 && along <= s.length) keepEarliest(i, timeSinceImpact, nx, ny, computeImpactSpeed<real>(speed, acceleration, timeSinceImpact), depth, false);
}

function testEnd(x: real, y: real, i: i32): void {
  const dx = pX - x;
  const dy = pY - y;
  const timeSinceImpact = roundTimeSinceImpact(dx, dy, 0, uX, uY, 0, aX, aY, 0, radius, duration);
  if (timeSinceImpact >= 0 && impactNormalSpeed > 0) {
    keepEarliest(i, timeSinceImpact, impactNormalX, impactNormalY, impactNormalSpeed, radius - (dx * impactNormalX + dy * impactNormalY), true);
  }
}

// Discs against walls that are line segments; both sides and both ends are solid (2D).
//
// The path of each body through the step is followed from wall to wall, earliest first; every bounce starts a new path
// that lasts until the end of the step. A body that hits walls MAX_BOUNCES times, as in a narrow groove, returns to its
// position at the start of the step, where it did not overlap a wall.
import { Columns, columns, get, put } from '../../memory/columns';
import { RESTS, noteImpact, noteVector } from '../impact-list';
import { ContactTable, WALL_MARGIN, contactTable, word } from '../table';
import { applyWallFriction, timeOfImpulse } from '../friction';
import { LANES, add, at, larger, mul, smaller, splat, sub } from '../../memory/lanes';
import { computeReboundDistance } from './impact';
import { recordNearWall, recordWallContact } from './record';
import { findHit, hit, path, setPath, setStart } from './sweep';
import { Segment, WallGrid, columnX, columnY, segment } from './wall-grid';

const MAX_BOUNCES: i32 = 8;

// Bounces rows [first, last). `lag` is the time by which the integrator's velocities lag its positions.
export function segmentWalls(grid: usize, dt: real, lag: real, first: i32, last: i32): void {
  const g = changetype<WallGrid>(grid);
  const lowX = splat(<real>g.minX);
  const lowY = splat(<real>g.minY);
  const highX = splat(<real>g.maxX);
  const highY = splat(<real>g.maxY);
  const c = columns();
  const zero = splat(0);
  const reach = splat(c.contacts == 0 ? <real>1 : WALL_MARGIN);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const r = mul(v128.load(c.radius + o), reach);
    const x = v128.load(c.positionX + o);
    const y = v128.load(c.positionY + o);
    const fx = v128.load(g.previousX + o);
    const fy = v128.load(g.previousY + o);
    const near = v128.and(overlaps(x, fx, r, lowX, highX), overlaps(y, fy, r, lowY, highY));
    const solid = v128.and(v128.gt<real>(r, zero), v128.gt<real>(v128.load(c.mass + o), zero));
    if (!v128.any_true(v128.and(near, solid)) || (g.side == 1 && !overlapsAny(g, x, y, fx, fy, r))) continue;
    for (let body = row; body < row + LANES; body++) {
      if (!(get(c.radius, body) > 0 && get(c.mass, body) > 0)) continue;
      followPath(g, c, body, dt, lag);
    }
  }
}

// Returns the lanes whose path along one axis, widened by the radius, overlaps the interval [low, high].
// @ts-ignore: decorator
@inline function overlaps(x: v128, from: v128, radius: v128, low: v128, high: v128): v128 {
  return v128.and(v128.ge<real>(add(larger(x, from), radius), low), v128.le<real>(sub(smaller(x, from), radius), high));
}

// Returns whether any lane comes near any of a few walls.
function overlapsAny(g: WallGrid, x: v128, y: v128, fx: v128, fy: v128, r: v128): bool {
  for (let i = 0; i < g.count; i++) {
    const s = segment(g, i);
    const near = v128.and(
      overlaps(x, fx, r, splat(s.minX), splat(s.maxX)),
      overlaps(y, fy, r, splat(s.minY), splat(s.maxY)),
    );
    if (v128.any_true(near)) return true;
  }
  return false;
}

// Follows the path of one body from wall to wall.
function followPath(g: WallGrid, c: Columns, row: i32, dt: real, lag: real): void {
  const x = get(g.previousX, row);
  const y = get(g.previousY, row);
  const ax = (get(c.velocityX, row) - get(g.startX, row)) / dt;
  const ay = (get(c.velocityY, row) - get(g.startY, row)) / dt;
  freeAccelerationX = ax;
  freeAccelerationY = ay;
  stepLength = dt;
  setStart(x, y, dt, get(c.radius, row));
  setPath(
    get(c.positionX, row),
    get(c.positionY, row),
    get(c.velocityX, row) + ax * lag,
    get(c.velocityY, row) + ay * lag,
    ax,
    ay,
  );
  let wall = -1;
  for (let bounce = 1; ; bounce++) {
    findHit(g, wall);
    if (hit.wall < 0) break;
    wall = hit.wall;
    const timeSinceImpact = hit.timeSinceImpact;
    const half = <real>0.5 * timeSinceImpact;
    const impactX = path.x - timeSinceImpact * (path.ux - half * path.ax);
    const impactY = path.y - timeSinceImpact * (path.uy - half * path.ay);
    bounceOff(g, segment(g, hit.wall), c, row);
    if (bounce == MAX_BOUNCES) setPath(x, y, 0, 0, 0, 0);
    put(c.positionX, row, path.x);
    put(c.positionY, row, path.y);
    if (bounce == MAX_BOUNCES || isLate) break;
    setStart(impactX, impactY, timeSinceImpact, get(c.radius, row));
  }
  if (c.contacts != 0) recordNearWalls(g, c, row);
}

// Records the walls near the body's final position.
function recordNearWalls(g: WallGrid, c: Columns, row: i32): void {
  const radius = get(c.radius, row);
  const x = get(c.positionX, row);
  const y = get(c.positionY, row);
  const left = columnX(g, x - radius);
  const right = columnX(g, x + radius);
  const bottom = columnY(g, y - radius);
  const top = columnY(g, y + radius);
  for (let line = bottom; line <= top; line++) {
    for (let column = left; column <= right; column++) {
      const cell = line * g.side + column;
      const end = word(g.starts, cell + 1);
      for (let k = word(g.starts, cell); k < end; k++) {
        const s = segment(g, word(g.items, k));
        // A wall that several cells list is recorded only for the first.
        if (column != max<i32>(left, columnX(g, s.minX)) || line != max<i32>(bottom, columnY(g, s.minY))) continue;
        recordIfNear(c, row, s, x, y, radius);
      }
    }
  }
}

function recordIfNear(c: Columns, row: i32, s: Segment, x: real, y: real, radius: real): void {
  const along = min<real>(s.length, max<real>(0, (x - s.ax) * s.tx + (y - s.ay) * s.ty));
  const dx = x - (s.ax + along * s.tx);
  const dy = y - (s.ay + along * s.ty);
  const distance = sqrt<real>(dx * dx + dy * dy);
  const gap = distance - radius;
  if (!(distance > 0 && gap < (WALL_MARGIN - <real>1) * radius)) return;
  const friction = sqrt<real>(get(c.friction, row) * s.friction);
  recordNearWall(row, s.id, dx / distance, dy / distance, 0, friction, gap);
}

// The acceleration before wall reactions, and the length of the step.
let freeAccelerationX: real = 0;
let freeAccelerationY: real = 0;
let stepLength: real = 0;

// Whether the last hit acted at the end of the step, where the path ends then; and the longest way of such a body, in
// radii.
let isLate: bool = false;
const MAX_WAY: real = 0.5;

// Applies the hit that was found: a rebound if the step can resolve it, otherwise the body rests on the wall.
function bounceOff(g: WallGrid, s: Segment, c: Columns, row: i32): void {
  const nx = hit.nx;
  const ny = hit.ny;
  const timeSinceImpact = hit.timeSinceImpact;
  const restitution = max<real>(get(c.restitution, row), s.restitution);
  const reboundSpeed = restitution * hit.speed;
  const acceleration = -(path.ax * nx + path.ay * ny);
  const reboundDistance = computeReboundDistance<real>(reboundSpeed, acceleration, timeSinceImpact, 0.5);
  const rebounds = reboundDistance > 0 && hit.speed > 0;
  const vx = get(c.velocityX, row);
  const vy = get(c.velocityY, row);
  const last = -(path.ux * nx + path.uy * ny);
  isLate = rebounds && last > 0 && canBeLate(c, row, restitution);
  const speeds = isLate ? (<real>1 + restitution) * last : reboundSpeed + hit.speed;
  const change = rebounds ? speeds : max<real>(0, -(vx * nx + vy * ny));
  let shift = !rebounds ? hit.depth : hit.isEnd ? change * timeSinceImpact : hit.depth + reboundDistance;
  if (isLate) shift = 0;
  const impulse = change * get(c.mass, row);
  put(c.velocityX, row, vx + change * nx);
  put(c.velocityY, row, vy + change * ny);
  const friction = sqrt<real>(get(c.friction, row) * s.friction);
  const moved = applyWallFriction(c, row, nx, ny, 0, friction, impulse, timeOfImpulse(shift, change, stepLength));
  const dx = get(c.velocityX, row) - vx;
  const dy = get(c.velocityY, row) - vy;
  noteRebound(g, s, c, row, rebounds ? restitution : RESTS, dx - change * nx, dy - change * ny);
  const x = path.x + shift * nx + moved.x;
  const y = path.y + shift * ny + moved.y;
  if (rebounds) continueAfterRebound(c, row, x, y, dx, dy, timeSinceImpact);
  else continueAlongWall(x, y, nx, ny, dx, dy);
  // Impact and friction are not accelerations of this step, but the reaction of a wall cancels acceleration.
  put(g.startX, row, get(c.velocityX, row) - path.ax * stepLength);
  put(g.startY, row, get(c.velocityY, row) - path.ay * stepLength);
  recordWallContact(row, s.id, nx, ny, 0, friction, hit.speed, impulse, rebounds ? <real>0 : impulse);
}

// Whether an elastic impact acts at the end of the step, as in impacts.ts: under forces that depend on position or
// velocity, and on a way so short that it meets no other wall unnoticed.
function canBeLate(c: Columns, row: i32, restitution: real): bool {
  if (restitution < 1 || c.contacts == 0 || contactTable().isUneven == 0) return false;
  const x = path.x - path.fromX;
  const y = path.y - path.fromY;
  const radius = get(c.radius, row);
  return x * x + y * y <= MAX_WAY * MAX_WAY * radius * radius;
}

// Notes the hit that was found, with the restitution `e` and the change of velocity by friction.
function noteRebound(g: WallGrid, s: Segment, c: Columns, row: i32, e: real, frictionX: real, frictionY: real): void {
  const time = hit.timeSinceImpact;
  const note = c.contacts == 0 ? <usize>0 : noteImpact(contactTable(), row, s.id, e, time);
  if (note == 0) return;
  const half = <real>0.5 * time;
  const x = path.x - time * (path.ux - half * path.ax);
  const y = path.y - time * (path.uy - half * path.ay);
  const next = noteVector(noteVector(note, frictionX, frictionY, 0), hit.nx, hit.ny, 0);
  store<real>(noteVector(next, get(g.startX, row), get(g.startY, row), 0), x * hit.nx + y * hit.ny);
}

// Starts the path after a rebound. The wall no longer supports the body, so the acceleration that it cancelled acts
// again.
function continueAfterRebound(c: Columns, row: i32, x: real, y: real, dx: real, dy: real, timeSinceImpact: real): void {
  const rx = freeAccelerationX - path.ax;
  const ry = freeAccelerationY - path.ay;
  const half = <real>0.5 * timeSinceImpact * timeSinceImpact;
  put(c.velocityX, row, get(c.velocityX, row) + rx * timeSinceImpact);
  put(c.velocityY, row, get(c.velocityY, row) + ry * timeSinceImpact);
  setPath(
    x + rx * half,
    y + ry * half,
    path.ux + dx + rx * timeSinceImpact,
    path.uy + dy + ry * timeSinceImpact,
    freeAccelerationX,
    freeAccelerationY,
  );
}

// Starts the path of a resting body, along the wall.
function continueAlongWall(x: real, y: real, nx: real, ny: real, dx: real, dy: real): void {
  const normalAcceleration = path.ax * nx + path.ay * ny;
  const ux = path.ux + dx;
  const uy = path.uy + dy;
  const normalSpeed = ux * nx + uy * ny;
  setPath(
    x,
    y,
    ux - normalSpeed * nx,
    uy - normalSpeed * ny,
    path.ax - normalAcceleration * nx,
    path.ay - normalAcceleration * ny,
  );
}

// Keeps the bodies that contacts moved since `fromX`, `fromY` of the table on their side of the walls. Only positions
// change: the next step finds the body at the wall with its velocity into it.
export function clampToSegments(grid: usize): void {
  const g = changetype<WallGrid>(grid);
  const c = columns();
  const t = contactTable();
  for (let slot = 0; slot < t.bodyCount; slot++) clampToWalls(g, c, t, word(t.bodyRows, slot));
}

function clampToWalls(g: WallGrid, c: Columns, t: ContactTable, row: i32): void {
  let x = get(t.fromX, row);
  let y = get(t.fromY, row);
  const radius = get(c.radius, row);
  const targetX = get(c.positionX, row);
  const targetY = get(c.positionY, row);
  if (!(radius > 0 && get(c.mass, row) > 0) || (targetX == x && targetY == y)) return;
  setPath(targetX, targetY, targetX - x, targetY - y, 0, 0);
  setStart(x, y, 1, radius);
  let wall = -1;
  for (let k = 0; k < MAX_BOUNCES; k++) {
    findHit(g, wall);
    if (hit.wall < 0) break;
    wall = hit.wall;
    x = path.x - hit.timeSinceImpact * path.ux;
    y = path.y - hit.timeSinceImpact * path.uy;
    const intoWall = path.ux * hit.nx + path.uy * hit.ny;
    const ux = k == MAX_BOUNCES - 1 ? <real>0 : path.ux - intoWall * hit.nx;
    const uy = k == MAX_BOUNCES - 1 ? <real>0 : path.uy - intoWall * hit.ny;
    setPath(x + ux * hit.timeSinceImpact, y + uy * hit.timeSinceImpact, ux, uy, 0, 0);
    setStart(x, y, hit.timeSinceImpact, radius);
  }
  put(c.positionX, row, path.x);
  put(c.positionY, row, path.y);
}

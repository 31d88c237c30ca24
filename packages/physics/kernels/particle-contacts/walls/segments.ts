// Discs against walls that are straight segments: both sides and both ends are solid (2D).
//
// Each body's path through the step is followed from one wall to the next, the earliest first; every bounce starts a new
// path that lasts from that instant to the end of the step. A body that meets walls more than MOST_BOUNCES times, as in a
// narrow groove, stays where the step began: there it was free.
import { Columns, columns, get, put } from '../../memory/columns';
import { ContactTable, WALL_REACH, contactTable, word } from '../table';
import { rubWall } from '../friction';
import { LANES, add, at, mul, splat, sub } from '../../memory/lanes';
import { distanceOut } from './impact';
import { recordNearWall, recordWallContact } from './record';
import { findHit, hit, path, setPath, setStart } from './sweep';
import { Segment, WallGrid, columnX, columnY, segment } from './wall-grid';

const MOST_BOUNCES: i32 = 8;

// Bounces rows [first, last). `lag` is the time by which the integrator's velocities lag its positions.
export function segmentWalls(grid: usize, dt: real, lag: real, first: i32, last: i32): void {
  const g = changetype<WallGrid>(grid);
  const lowX = splat(<real>g.minX);
  const lowY = splat(<real>g.minY);
  const highX = splat(<real>g.maxX);
  const highY = splat(<real>g.maxY);
  const c = columns();
  const zero = splat(0);
  const reach = splat(c.contacts == 0 ? <real>1 : WALL_REACH);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const r = mul(v128.load(c.radius + o), reach);
    const x = v128.load(c.positionX + o);
    const y = v128.load(c.positionY + o);
    const fx = v128.load(g.previousX + o);
    const fy = v128.load(g.previousY + o);
    const near = v128.and(meets(x, fx, r, lowX, highX), meets(y, fy, r, lowY, highY));
    const solid = v128.and(v128.gt<real>(r, zero), v128.gt<real>(v128.load(c.mass + o), zero));
    if (!v128.any_true(v128.and(near, solid)) || (g.side == 1 && !meetsAny(g, x, y, fx, fy, r))) continue;
    for (let body = row; body < row + LANES; body++) {
      if (!(get(c.radius, body) > 0 && get(c.mass, body) > 0)) continue;
      follow(g, c, body, dt, lag);
    }
  }
}

// Lanes whose path along one axis, widened by the radius, meets the interval [low, high].
// @ts-ignore: decorator
@inline function meets(x: v128, from: v128, radius: v128, low: v128, high: v128): v128 {
  return v128.and(
    v128.ge<real>(add(v128.max<real>(x, from), radius), low),
    v128.le<real>(sub(v128.min<real>(x, from), radius), high),
  );
}

// Whether any lane comes near any of a few walls.
function meetsAny(g: WallGrid, x: v128, y: v128, fx: v128, fy: v128, r: v128): bool {
  for (let i = 0; i < g.count; i++) {
    const s = segment(g, i);
    const near = v128.and(meets(x, fx, r, splat(s.minX), splat(s.maxX)), meets(y, fy, r, splat(s.minY), splat(s.maxY)));
    if (v128.any_true(near)) return true;
  }
  return false;
}

// Follows one body from wall to wall.
function follow(g: WallGrid, c: Columns, row: i32, dt: real, lag: real): void {
  const x = get(g.previousX, row);
  const y = get(g.previousY, row);
  const ax = (get(c.velocityX, row) - get(g.startX, row)) / dt;
  const ay = (get(c.velocityY, row) - get(g.startY, row)) / dt;
  freeX = ax;
  freeY = ay;
  whole = dt;
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
    const since = hit.since;
    const half = <real>0.5 * since;
    const metX = path.x - since * (path.ux - half * path.ax);
    const metY = path.y - since * (path.uy - half * path.ay);
    bounceOff(g, segment(g, hit.wall), c, row);
    if (bounce == MOST_BOUNCES) setPath(x, y, 0, 0, 0, 0);
    put(c.positionX, row, path.x);
    put(c.positionY, row, path.y);
    if (bounce == MOST_BOUNCES) break;
    setStart(metX, metY, since, get(c.radius, row));
  }
  if (c.contacts != 0) noteNear(g, c, row);
}

// Records the walls near the body where the step took it.
function noteNear(g: WallGrid, c: Columns, row: i32): void {
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
        // A wall that several of the cells list counts in the first.
        if (column != max<i32>(left, columnX(g, s.minX)) || line != max<i32>(bottom, columnY(g, s.minY))) continue;
        noteWall(c, row, s, x, y, radius);
      }
    }
  }
}

function noteWall(c: Columns, row: i32, s: Segment, x: real, y: real, radius: real): void {
  const along = min<real>(s.length, max<real>(0, (x - s.ax) * s.tx + (y - s.ay) * s.ty));
  const dx = x - (s.ax + along * s.tx);
  const dy = y - (s.ay + along * s.ty);
  const distance = sqrt<real>(dx * dx + dy * dy);
  const gap = distance - radius;
  if (!(distance > 0 && gap < (WALL_REACH - <real>1) * radius)) return;
  const friction = sqrt<real>(get(c.friction, row) * s.friction);
  recordNearWall(row, s.id, dx / distance, dy / distance, 0, friction, gap);
}

// The acceleration that no wall has taken away, and the step it acts for.
let freeX: real = 0;
let freeY: real = 0;
let whole: real = 0;

// Applies the hit that was found: the rebound if the step can resolve it, else the body rests on the wall.
function bounceOff(g: WallGrid, s: Segment, c: Columns, row: i32): void {
  const nx = hit.x;
  const ny = hit.y;
  const since = hit.since;
  const leave = max<real>(get(c.restitution, row), s.restitution) * hit.speed;
  const pull = -(path.ax * nx + path.ay * ny);
  const out = distanceOut<real>(leave, pull, since, 0.5);
  const flies = out > 0 && hit.speed > 0;
  const vx = get(c.velocityX, row);
  const vy = get(c.velocityY, row);
  const change = flies ? leave + hit.speed : max<real>(0, -(vx * nx + vy * ny));
  const shift = !flies ? hit.depth : hit.isEnd ? change * since : hit.depth + out;
  const impulse = change * get(c.mass, row);
  put(c.velocityX, row, vx + change * nx);
  put(c.velocityY, row, vy + change * ny);
  const friction = sqrt<real>(get(c.friction, row) * s.friction);
  rubWall(c, row, nx, ny, 0, friction, impulse);
  const dx = get(c.velocityX, row) - vx;
  const dy = get(c.velocityY, row) - vy;
  const x = path.x + shift * nx;
  const y = path.y + shift * ny;
  if (flies) flyOn(c, row, x, y, dx, dy, since);
  else restOn(x, y, nx, ny, dx, dy);
  // Neither an impact nor friction is an acceleration of this step, but what a wall holds does not accelerate.
  put(g.startX, row, get(c.velocityX, row) - path.ax * whole);
  put(g.startY, row, get(c.velocityY, row) - path.ay * whole);
  recordWallContact(row, s.id, nx, ny, 0, friction, impulse, flies ? <real>0 : impulse);
}

// The path after a rebound: a wall that held the body before holds it no longer, and what it took away acts again.
function flyOn(c: Columns, row: i32, x: real, y: real, dx: real, dy: real, since: real): void {
  const rx = freeX - path.ax;
  const ry = freeY - path.ay;
  const half = <real>0.5 * since * since;
  put(c.velocityX, row, get(c.velocityX, row) + rx * since);
  put(c.velocityY, row, get(c.velocityY, row) + ry * since);
  setPath(x + rx * half, y + ry * half, path.ux + dx + rx * since, path.uy + dy + ry * since, freeX, freeY);
}

// The path of a body that rests on a wall: along it.
function restOn(x: real, y: real, nx: real, ny: real, dx: real, dy: real): void {
  const held = path.ax * nx + path.ay * ny;
  const ux = path.ux + dx;
  const uy = path.uy + dy;
  const moving = ux * nx + uy * ny;
  setPath(x, y, ux - moving * nx, uy - moving * ny, path.ax - held * nx, path.ay - held * ny);
}

// Keeps the bodies of this step's contacts, which contacts moved since `fromX`, `fromY` of the table, on their side of
// the walls. Only positions change: the next step finds the body at the wall and its velocity into it.
export function confineToSegments(grid: usize): void {
  const g = changetype<WallGrid>(grid);
  const c = columns();
  const t = contactTable();
  for (let slot = 0; slot < t.bodyCount; slot++) confine(g, c, t, word(t.bodyRows, slot));
}

function confine(g: WallGrid, c: Columns, t: ContactTable, row: i32): void {
  let x = get(t.fromX, row);
  let y = get(t.fromY, row);
  const radius = get(c.radius, row);
  const goalX = get(c.positionX, row);
  const goalY = get(c.positionY, row);
  if (!(radius > 0 && get(c.mass, row) > 0) || (goalX == x && goalY == y)) return;
  setPath(goalX, goalY, goalX - x, goalY - y, 0, 0);
  setStart(x, y, 1, radius);
  let wall = -1;
  for (let k = 0; k < MOST_BOUNCES; k++) {
    findHit(g, wall);
    if (hit.wall < 0) break;
    wall = hit.wall;
    x = path.x - hit.since * path.ux;
    y = path.y - hit.since * path.uy;
    const into = path.ux * hit.x + path.uy * hit.y;
    const ux = k == MOST_BOUNCES - 1 ? <real>0 : path.ux - into * hit.x;
    const uy = k == MOST_BOUNCES - 1 ? <real>0 : path.uy - into * hit.y;
    setPath(x + ux * hit.since, y + uy * hit.since, ux, uy, 0, 0);
    setStart(x, y, hit.since, radius);
  }
  put(c.positionX, row, path.x);
  put(c.positionY, row, path.y);
}

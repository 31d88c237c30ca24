// Bodies inside an axis-aligned box, one axis at a time. kernels/walls/impact.ts has the formula.
import { Columns, columns, get } from '../columns';
import { BLOCK, LANES, add, at, div, laneOf, mul, splat, sub } from '../lanes';
import { rubWall } from '../collision/friction';
import { WALL_REACH } from '../collision/table';
import { distanceOut, impactSpeed, timeSince } from './impact';
import { recordNearWall, recordWallContact } from './record';

// A body so fast that it crosses the box within a step meets both walls; after this many it is put inside.
const MOST_BOUNCES: i32 = 4;

// Lanes of the last `rebound` that came to rest.
let rested: v128 = i32x4.splat(0);

// Bounces the lanes `hit` of one vector of rows off the wall at `plane` (already moved inward by the radius), whose
// inside is towards `side` (+1 or -1). Returns the change of normal velocity per lane, zero where nothing came in.
//
// `lag` is the time by which the integrator's velocities lag its positions. A rebound moves the start velocity along,
// so that the next wall sees the same acceleration; a body at rest is held, and its acceleration becomes zero.
// @ts-ignore: decorator
@inline function rebound(
  x: usize,
  v: usize,
  start: usize,
  plane: v128,
  side: v128,
  hit: v128,
  restitution: v128,
  dt: v128,
  lag: v128,
): v128 {
  const zero = splat(0);
  const position = v128.load(x);
  const velocity = v128.load(v);
  const before = v128.load(start);
  const depth = mul(side, sub(plane, position));
  const pull = div(mul(side, sub(before, velocity)), dt);
  const speed = add(v128.neg<real>(mul(side, velocity)), mul(pull, lag));
  const since = timeSince<v128>(depth, speed, pull, dt);
  const impact = impactSpeed<v128>(speed, pull, since);
  const leave = mul(restitution, impact);
  const out = distanceOut<v128>(leave, pull, since, splat(0.5));
  const entering = v128.and(hit, v128.gt<real>(speed, zero));
  const flies = v128.and(entering, v128.and(v128.gt<real>(out, zero), v128.gt<real>(impact, zero)));
  const away = v128.and(sub(leave, mul(pull, sub(since, lag))), flies);
  const after = mul(side, away);
  rested = v128.andnot(entering, flies);
  v128.store(x, v128.bitselect(add(plane, v128.and(mul(side, out), flies)), position, hit));
  v128.store(v, v128.bitselect(after, velocity, entering));
  v128.store(start, v128.bitselect(add(before, v128.and(sub(after, velocity), flies)), before, flies));
  v128.store(start, v128.andnot(v128.load(start), rested));
  return v128.and(add(away, mul(side, v128.neg<real>(velocity))), entering);
}

// @ts-ignore: decorator
@inline function isRough(c: Columns, row: i32): bool {
  return v128.any_true(v128.gt<real>(v128.load(c.friction + at(row)), splat(0)));
}

// Friction and the record of the lanes that came in.
function settle(c: Columns, row: i32, change: v128, axis: i32, side: real, friction: real): void {
  const nx = axis == 0 ? side : <real>0;
  const ny = axis == 1 ? side : <real>0;
  const nz = axis == 2 ? side : <real>0;
  const still = rested;
  if (c.contacts == 0 && (friction == 0 || !isRough(c, row))) return;
  for (let lane = 0; lane < LANES; lane++) {
    const body = row + lane;
    const impulse = laneOf(change, lane) * get(c.mass, body);
    if (!(impulse > 0)) continue;
    const own = get(c.friction, body);
    const mu = friction < 0 ? own : sqrt<real>(own * friction);
    rubWall(c, body, nx, ny, nz, mu, impulse);
    recordWallContact(body, 0, nx, ny, nz, mu, impulse, laneOf(still, lane) != 0 ? impulse : <real>0);
  }
}

// Bounces rows [first, last) off the planes `low` and `high` of one axis (0, 1, 2). Only bodies with a collider
// (radius > 0) and mass > 0 are moved. `start` is the velocity column at the start of the step; the contact's
// restitution is the larger of the body's and the wall's; the friction coefficient is the geometric mean of the two,
// or the body's own where `friction` is negative.
//
// Few bodies are at a wall: a block of four vectors is dismissed with one test.
export function boxAxis(
  axis: i32,
  x: usize,
  v: usize,
  start: usize,
  low: real,
  high: real,
  restitution: real,
  friction: real,
  dt: real,
  lag: real,
  first: i32,
  last: i32,
): void {
  const c = columns();
  const radius = c.radius;
  const lowest = splat(low);
  const highest = splat(high);
  const reach = splat(c.contacts == 0 ? <real>1 : WALL_REACH);
  for (let chunk = first; chunk < last; chunk += 64 * BLOCK) {
    let hits: u64 = 0;
    for (let row = min(chunk + 64 * BLOCK, last) - BLOCK; row >= chunk; row -= BLOCK) {
      const p = x + at(row);
      const r = radius + at(row);
      const outside = v128.or(
        v128.or(isOutside(p, r, reach, lowest, highest), isOutside(p + 16, r + 16, reach, lowest, highest)),
        v128.or(isOutside(p + 32, r + 32, reach, lowest, highest), isOutside(p + 48, r + 48, reach, lowest, highest)),
      );
      hits = (hits << 1) | u64(v128.any_true(outside));
    }
    for (; hits != 0; hits &= hits - 1) {
      const row = chunk + <i32>ctz(hits) * BLOCK;
      for (let i = row; i < row + BLOCK; i += LANES) {
        if (!v128.any_true(isOutside(x + at(i), radius + at(i), reach, lowest, highest))) continue;
        bounce(axis, x, v, start, low, high, restitution, friction, dt, lag, i);
        if (c.contacts == 0) continue;
        noteNear(c, i, axis, x, low, 1, friction);
        noteNear(c, i, axis, x, high, -1, friction);
      }
    }
  }
}

// @ts-ignore: decorator
@inline function isOutside(x: usize, radius: usize, reach: v128, low: v128, high: v128): v128 {
  const position = v128.load(x);
  const r = mul(v128.load(radius), reach);
  return v128.or(v128.lt<real>(position, add(low, r)), v128.gt<real>(position, sub(high, r)));
}

// The rare case: one vector of rows, some of them perhaps outside.
function bounce(
  axis: i32,
  x: usize,
  v: usize,
  start: usize,
  low: real,
  high: real,
  restitution: real,
  friction: real,
  dt: real,
  lag: real,
  row: i32,
): void {
  const c = columns();
  const zero = splat(0);
  const o = at(row);
  const radius = v128.load(c.radius + o);
  const lower = add(splat(low), radius);
  const upper = sub(splat(high), radius);
  const solid = v128.and(v128.gt<real>(radius, zero), v128.gt<real>(v128.load(c.mass + o), zero));
  // What contacts pushed beyond a wall and is on its way back within the step needs no help, which would lift it.
  const way = mul(v128.load(v + o), splat(dt));
  const x0 = v128.load(x + o);
  const returns = v128.or(
    v128.and(v128.lt<real>(x0, lower), v128.ge<real>(add(x0, way), lower)),
    v128.and(v128.gt<real>(x0, upper), v128.le<real>(add(x0, way), upper)),
  );
  const fits = v128.andnot(v128.and(solid, v128.le<real>(lower, upper)), returns);
  const e = v128.max<real>(v128.load(c.restitution + o), splat(restitution));
  for (let turn = 0; turn < MOST_BOUNCES; turn++) {
    const position = v128.load(x + o);
    const hitLow = v128.and(v128.lt<real>(position, lower), fits);
    const hitHigh = v128.and(v128.gt<real>(position, upper), fits);
    if (!v128.any_true(v128.or(hitLow, hitHigh))) break;
    if (v128.any_true(hitLow)) {
      const change = rebound(x + o, v + o, start + o, lower, splat(1), hitLow, e, splat(dt), splat(lag));
      settle(c, row, change, axis, 1, friction);
    }
    if (v128.any_true(hitHigh)) {
      const change = rebound(x + o, v + o, start + o, upper, splat(-1), hitHigh, e, splat(dt), splat(lag));
      settle(c, row, change, axis, -1, friction);
    }
  }
  // Whatever is still outside is put inside; what does not fit between the walls, in the middle and held.
  const position = v128.load(x + o);
  const inside = v128.min<real>(v128.max<real>(position, lower), upper);
  const tight = v128.and(solid, v128.gt<real>(lower, upper));
  const held = v128.bitselect(mul(splat(0.5), add(lower, upper)), position, tight);
  v128.store(x + o, v128.bitselect(inside, held, fits));
  v128.store(v + o, v128.andnot(v128.load(v + o), tight));
}

// Records the bodies that are near a wall without being beyond it.
function noteNear(c: Columns, row: i32, axis: i32, x: usize, plane: real, side: real, friction: real): void {
  for (let body = row; body < row + LANES; body++) {
    const radius = get(c.radius, body);
    const gap = (get(x, body) - plane) * side - radius;
    if (gap < (WALL_REACH - <real>1) * radius && get(c.mass, body) > 0) {
      const own = get(c.friction, body);
      const mu = friction < 0 ? own : sqrt<real>(own * friction);
      recordNearWall(body, 0, axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0, mu, gap);
    }
  }
}

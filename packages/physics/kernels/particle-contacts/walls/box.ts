// Bodies inside an axis-aligned box. kernels/particle-contacts/walls/impact.ts has the formula.
import { Columns, columns, get } from '../../memory/columns';
import { BLOCK, LANES, add, at, div, laneOf, mul, splat, sub } from '../../memory/lanes';
import { rubWall } from '../friction';
import { WALL_REACH } from '../table';
import { distanceOut, impactSpeed, timeSince } from './impact';
import { recordNearWall, recordWallContact } from './record';

// A body so fast that it crosses the box within a step meets both walls; after this many it is put inside.
const MOST_BOUNCES: i32 = 4;

// A body that began the step at rest on a wall and ends it beyond stays where it was, unless its restitution is more than
// this. src/dynamics/loop-checks.ts has the same rule, so that most of such bodies never come here.
const REST_RESTITUTION: real = 0.99;

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

// The walls of a box; src/particle-contacts/box-walls.ts writes it. A coordinate of 1e30 is no wall. `friction` is negative where
// the bodies' own counts; `start` and `origin` are the
// columns of velocities and positions at the start of the step.
@unmanaged
export class Box {
  lowX: f64;
  lowY: f64;
  lowZ: f64;
  highX: f64;
  highY: f64;
  highZ: f64;
  restitution: f64;
  friction: f64;
  startX: usize;
  startY: usize;
  startZ: usize;
  axes: i32;
  originX: usize;
  originY: usize;
  originZ: usize;
  unused: i32;
}

// One pair of walls: what `bounce` needs to know besides the row.
@unmanaged
class Walls {
  axis: i32;
  x: usize;
  v: usize;
  start: usize;
  origin: usize;
  low: real;
  high: real;
  restitution: real;
  friction: real;
  dt: real;
  lag: real;
}

const WALLS: usize = memory.data(offsetof<Walls>(), 8);

// The walls across an axis (0, 1, 2).
function wallsAcross(box: Box, axis: i32, dt: real, lag: real): Walls {
  const c = columns();
  const w = changetype<Walls>(WALLS);
  w.axis = axis;
  w.x = load<usize>(changetype<usize>(c) + ((<usize>axis) << 2), offsetof<Columns>('positionX'));
  w.v = load<usize>(changetype<usize>(c) + ((<usize>axis) << 2), offsetof<Columns>('velocityX'));
  w.start = load<usize>(changetype<usize>(box) + ((<usize>axis) << 2), offsetof<Box>('startX'));
  w.origin = load<usize>(changetype<usize>(box) + ((<usize>axis) << 2), offsetof<Box>('originX'));
  w.low = <real>load<f64>(changetype<usize>(box) + ((<usize>axis) << 3), offsetof<Box>('lowX'));
  w.high = <real>load<f64>(changetype<usize>(box) + ((<usize>axis) << 3), offsetof<Box>('highX'));
  w.restitution = <real>box.restitution;
  w.friction = <real>box.friction;
  w.dt = dt;
  w.lag = lag;
  return w;
}

// Bounces rows [first, last) off the walls. Only bodies with a collider (radius > 0) and mass > 0 are moved. A contact's
// restitution is the larger of the body's and the wall's, its friction coefficient the geometric mean.
//
// Few bodies are at a wall: a block of four vectors is dismissed with one test.
export function boxRows(box: usize, dt: real, lag: real, first: i32, last: i32): void {
  const b = changetype<Box>(box);
  for (let axis = 0; axis < b.axes; axis++) sweepRows(wallsAcross(b, axis, dt, lag), first, last);
}

function sweepRows(w: Walls, first: i32, last: i32): void {
  const c = columns();
  const radius = c.radius;
  const x = w.x;
  const lowest = splat(w.low);
  const highest = splat(w.high);
  const reach = splat(c.contacts == 0 ? <real>1 : WALL_REACH);
  for (let row = first; row < last; row += BLOCK) {
    const p = x + at(row);
    const r = radius + at(row);
    const outside = v128.or(
      v128.or(isOutside(p, r, reach, lowest, highest), isOutside(p + 16, r + 16, reach, lowest, highest)),
      v128.or(isOutside(p + 32, r + 32, reach, lowest, highest), isOutside(p + 48, r + 48, reach, lowest, highest)),
    );
    if (!v128.any_true(outside)) continue;
    for (let i = row; i < row + BLOCK; i += LANES) {
      if (!v128.any_true(isOutside(x + at(i), radius + at(i), reach, lowest, highest))) continue;
      bounce(w, i);
      if (c.contacts == 0) continue;
      noteNear(c, i, w.axis, x, w.low, 1, w.friction);
      noteNear(c, i, w.axis, x, w.high, -1, w.friction);
    }
  }
}

// Bounces the vectors of rows of a list: its end, then byte offsets in a column of reals. Returns how many have a
// velocity that is not in range after it.
export function boxListed(box: usize, list: usize, dt: real, lag: real, maxSpeed: real): i32 {
  const b = changetype<Box>(box);
  const c = columns();
  const end = load<usize>(list);
  const limit = splat(maxSpeed);
  const one = splat(1);
  let bad = 0;
  for (let axis = 0; axis < b.axes; axis++) {
    const w = wallsAcross(b, axis, dt, lag);
    const lowest = splat(w.low);
    const highest = splat(w.high);
    for (let p = list + 4; p < end; p += 4) {
      const o = load<usize>(p);
      if (!v128.any_true(isOutside(w.x + o, c.radius + o, one, lowest, highest))) continue;
      bounce(w, <i32>(o / sizeof<real>()));
      if (!v128.all_true<i32>(v128.le<real>(v128.abs<real>(v128.load(w.v + o)), limit))) bad++;
    }
  }
  return bad;
}

// @ts-ignore: decorator
@inline function isOutside(x: usize, radius: usize, reach: v128, low: v128, high: v128): v128 {
  const position = v128.load(x);
  const r = mul(v128.load(radius), reach);
  return v128.or(v128.lt<real>(position, add(low, r)), v128.gt<real>(position, sub(high, r)));
}

// The rare case: one vector of rows, some of them perhaps outside.
function bounce(w: Walls, row: i32): void {
  const axis = w.axis;
  const x = w.x;
  const v = w.v;
  const start = w.start;
  const low = w.low;
  const high = w.high;
  const restitution = w.restitution;
  const friction = w.friction;
  const dt = w.dt;
  const lag = w.lag;
  const c = columns();
  const zero = splat(0);
  const o = at(row);
  const radius = v128.load(c.radius + o);
  const lower = add(splat(low), radius);
  const upper = sub(splat(high), radius);
  const solid = v128.and(v128.gt<real>(radius, zero), v128.gt<real>(v128.load(c.mass + o), zero));
  const e = v128.max<real>(v128.load(c.restitution + o), splat(restitution));
  holdResting(w, row, lower, upper, v128.and(solid, v128.le<real>(e, splat(REST_RESTITUTION))));
  // What contacts pushed beyond a wall and is on its way back within the step needs no help, which would lift it.
  const way = mul(v128.load(v + o), splat(dt));
  const x0 = v128.load(x + o);
  const returns = v128.or(
    v128.and(v128.lt<real>(x0, lower), v128.ge<real>(add(x0, way), lower)),
    v128.and(v128.gt<real>(x0, upper), v128.le<real>(add(x0, way), upper)),
  );
  const fits = v128.andnot(v128.and(solid, v128.le<real>(lower, upper)), returns);
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

// Holds the lanes `able` that began the step at rest on a wall and end it beyond.
function holdResting(w: Walls, row: i32, lower: v128, upper: v128, able: v128): void {
  const o = at(row);
  const x = v128.load(w.x + o);
  const origin = v128.load(w.origin + o);
  const still = v128.and(able, v128.eq<real>(v128.load(w.start + o), splat(0)));
  const onLow = v128.and(still, v128.and(v128.lt<real>(x, lower), v128.eq<real>(origin, lower)));
  const onHigh = v128.and(still, v128.and(v128.gt<real>(x, upper), v128.eq<real>(origin, upper)));
  rested = v128.or(onLow, onHigh);
  if (!v128.any_true(rested)) return;
  const velocity = v128.load(w.v + o);
  v128.store(w.x + o, v128.bitselect(origin, x, rested));
  v128.store(w.v + o, v128.andnot(velocity, rested));
  const c = columns();
  settle(c, row, v128.and(v128.neg<real>(velocity), onLow), w.axis, 1, w.friction);
  settle(c, row, v128.and(velocity, onHigh), w.axis, -1, w.friction);
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

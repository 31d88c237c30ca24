// Bodies inside an axis-aligned box. The formulas are in impact.ts.
import { Columns, columns, get } from '../../memory/columns';
import { BLOCK, LANES, add, at, div, laneOf, larger, mul, smaller, splat, sub } from '../../memory/lanes';
import { Body } from '../body';
import { applyWallFriction } from '../friction';
import { WALL_MARGIN } from '../table';
import { computeReboundDistance, computeImpactSpeed, computeTimeSinceImpact } from './impact';
import { recordNearWall, recordWallContact } from './record';

// A body that crosses the box within a step hits both walls; after this many bounces its position is clamped.
const MAX_BOUNCES: i32 = 4;

// A body that began the step at rest on a wall and ends it beyond the wall is held in place unless its restitution is
// larger. src/dynamics/loop-checks.ts applies the same rule, so most such bodies are handled there.
const REST_RESTITUTION: real = 0.99;

// Lanes that came to rest in the last call of `rebound`.
let restingLanes: v128 = i32x4.splat(0);

// Speeds into the wall at the impacts of the last call of `rebound`.
let impactSpeeds: v128 = i32x4.splat(0);

// Distances by which that call moved the lanes away from the wall.
let shifts: v128 = i32x4.splat(0);

// Reflects the lanes `hit` of one vector of rows off the walls at `plane`, which are already offset by the radius; `side`
// (+1 or -1) points inside. Returns the change of normal velocity per lane, zero for lanes that do not approach.
//
// `lag` is the time by which the integrator's velocities lag its positions. A rebound also changes the start velocity,
// so that the acceleration stays the same for the next wall; the acceleration of a resting body becomes zero.
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
  const startVelocity = v128.load(start);
  const depth = mul(side, sub(plane, position));
  const acceleration = div(mul(side, sub(startVelocity, velocity)), dt);
  const speed = add(v128.neg<real>(mul(side, velocity)), mul(acceleration, lag));
  const timeSinceImpact = computeTimeSinceImpact<v128>(depth, speed, acceleration, dt);
  const impact = computeImpactSpeed<v128>(speed, acceleration, timeSinceImpact);
  const reboundSpeed = mul(restitution, impact);
  const reboundDistance = computeReboundDistance<v128>(reboundSpeed, acceleration, timeSinceImpact, splat(0.5));
  const entering = v128.and(hit, v128.gt<real>(speed, zero));
  const rebounds = v128.and(entering, v128.and(v128.gt<real>(reboundDistance, zero), v128.gt<real>(impact, zero)));
  const outgoing = v128.and(sub(reboundSpeed, mul(acceleration, sub(timeSinceImpact, lag))), rebounds);
  const newVelocity = mul(side, outgoing);
  restingLanes = v128.andnot(entering, rebounds);
  impactSpeeds = impact;
  shifts = add(depth, v128.and(reboundDistance, rebounds));
  v128.store(x, v128.bitselect(add(plane, v128.and(mul(side, reboundDistance), rebounds)), position, hit));
  v128.store(v, v128.bitselect(newVelocity, velocity, entering));
  v128.store(
    start,
    v128.bitselect(add(startVelocity, v128.and(sub(newVelocity, velocity), rebounds)), startVelocity, rebounds),
  );
  v128.store(start, v128.andnot(v128.load(start), restingLanes));
  return v128.and(add(outgoing, mul(side, v128.neg<real>(velocity))), entering);
}

// @ts-ignore: decorator
@inline function hasFriction(c: Columns, row: i32): bool {
  return v128.any_true(v128.gt<real>(v128.load(c.friction + at(row)), splat(0)));
}

// Applies friction to the lanes that hit the wall and records their contacts.
function recordImpacts(c: Columns, w: Walls, row: i32, change: v128, sides: v128): void {
  const resting = restingLanes;
  const speeds = impactSpeeds;
  // As `timeOfImpulse`; lanes without a change are not read.
  const times = smaller(larger(div(shifts, change), splat(0)), splat(w.dt));
  const axis = w.axis;
  const friction = w.friction;
  if (c.contacts == 0 && (friction == 0 || !hasFriction(c, row))) return;
  for (let lane = 0; lane < LANES; lane++) {
    const body = row + lane;
    const impulse = laneOf(change, lane) * get(c.mass, body);
    if (!(impulse > 0)) continue;
    const side = laneOf(sides, lane);
    const nx = axis == 0 ? side : <real>0;
    const ny = axis == 1 ? side : <real>0;
    const nz = axis == 2 ? side : <real>0;
    const own = get(c.friction, body);
    const mu = friction < 0 ? own : sqrt<real>(own * friction);
    if (mu > 0) slide(c, w, body, applyWallFriction(c, body, nx, ny, nz, mu, impulse, laneOf(times, lane)));
    const restingImpulse = laneOf(resting, lane) != 0 ? impulse : <real>0;
    recordWallContact(body, 0, nx, ny, nz, mu, laneOf(speeds, lane), impulse, restingImpulse);
  }
}

// Moves a body along a wall by the way in the position of `by`, but not out of the box.
function slide(c: Columns, w: Walls, row: i32, by: Body): void {
  const radius = get(c.radius, row);
  const offset = <usize>row * sizeof<real>();
  for (let axis = 0; axis < changetype<Box>(w.box).axes; axis++) {
    if (axis == w.axis) continue;
    const i = <usize>axis;
    const x = load<usize>(changetype<usize>(c) + (i << 2), offsetof<Columns>('positionX')) + offset;
    const from = load<real>(x);
    const to = from + load<real>(changetype<usize>(by) + i * sizeof<real>());
    const low = <real>load<f64>(w.box + (i << 3), offsetof<Box>('lowX')) + radius;
    const high = <real>load<f64>(w.box + (i << 3), offsetof<Box>('highX')) - radius;
    store<real>(x, min<real>(max<real>(to, min<real>(from, low)), max<real>(from, high)));
  }
}

// The vectors of bodies beyond a wall: the loop of the step lists them (src/laws/emit-checks.ts).
@unmanaged
export class WallList {
  // The address behind the last entry. The entries follow this record.
  end: usize;
  unused0: i32;
  unused1: i32;
  unused2: i32;
}

// One of them. Unless the loop saves the velocities of all bodies at the start of the step, those of these bodies follow
// this record, a vector an axis: in columns, each would be a line of the cache of which nothing else is used.
@unmanaged
export class ListedVector {
  // Bytes from the start of a column of reals.
  offset: usize;
  unused0: i32;
  unused1: i32;
  unused2: i32;
}

// From one entry of the list to the next. Behind the velocities is a vector for the restitutions.
export const LISTED_VECTOR_SIZE: usize = 4 * 16 + offsetof<ListedVector>();

// The walls of a box, written by src/particle-contacts/box-walls.ts. A coordinate of 1e30 means no wall. A negative
// `friction` means that the bodies' own coefficient applies. `start` and `origin` are the columns of velocity and
// position at the start of the step.
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

// The two walls across one axis: the parameters of `bounce` other than the row.
@unmanaged
class Walls {
  axis: i32;
  box: usize;
  x: usize;
  v: usize;
  start: usize;
  origin: usize;
  low: real;
  high: real;
  restitution: f64;
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
  w.box = changetype<usize>(box);
  w.x = load<usize>(changetype<usize>(c) + ((<usize>axis) << 2), offsetof<Columns>('positionX'));
  w.v = load<usize>(changetype<usize>(c) + ((<usize>axis) << 2), offsetof<Columns>('velocityX'));
  w.start = load<usize>(changetype<usize>(box) + ((<usize>axis) << 2), offsetof<Box>('startX'));
  w.origin = load<usize>(changetype<usize>(box) + ((<usize>axis) << 2), offsetof<Box>('originX'));
  w.low = <real>load<f64>(changetype<usize>(box) + ((<usize>axis) << 3), offsetof<Box>('lowX'));
  w.high = <real>load<f64>(changetype<usize>(box) + ((<usize>axis) << 3), offsetof<Box>('highX'));
  w.restitution = box.restitution;
  w.friction = <real>box.friction;
  w.dt = dt;
  w.lag = lag;
  return w;
}

// Bounces rows [first, last) off the walls. Only bodies with a collider (radius > 0) and mass > 0 move. The restitution
// of a contact is the larger of body and wall, its friction coefficient the geometric mean.
//
// Few bodies are at a wall, so one test rejects a block of four vectors.
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
  const reach = reachOf(c);
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
      bounceAndRecord(w, c, i, w.start + at(i), restitutionsOf(c, at(i), w.restitution));
    }
  }
}

// Bounces the listed vectors of rows. Returns the number of vectors whose velocity is out of range afterwards.
// `savesVelocity`: the velocities at the start of the step are in columns, which what follows this system reads as well.
export function boxListed(box: usize, list: usize, dt: real, lag: real, maxSpeed: real, savesVelocity: bool): i32 {
  const b = changetype<Box>(box);
  const c = columns();
  const end = changetype<WallList>(list).end;
  const limit = splat(maxSpeed);
  const reach = reachOf(c);
  const first = list + offsetof<WallList>();
  const restitutions = LISTED_VECTOR_SIZE - 16;
  // Nothing else of their column is read, so that each comes from far: all are asked for before the first is needed.
  for (let p = first; p < end; p += LISTED_VECTOR_SIZE) {
    v128.store(p + restitutions, restitutionsOf(c, changetype<ListedVector>(p).offset, b.restitution));
  }
  let invalidCount = 0;
  for (let axis = 0; axis < b.axes; axis++) {
    const w = wallsAcross(b, axis, dt, lag);
    const lowest = splat(w.low);
    const highest = splat(w.high);
    const start = offsetof<ListedVector>() + ((<usize>axis) << 4);
    for (let p = first; p < end; p += LISTED_VECTOR_SIZE) {
      const o = changetype<ListedVector>(p).offset;
      if (!v128.any_true(isOutside(w.x + o, c.radius + o, reach, lowest, highest))) continue;
      const row = <i32>(o / sizeof<real>());
      bounceAndRecord(w, c, row, savesVelocity ? w.start + o : p + start, v128.load(p + restitutions));
      if (!v128.all_true<i32>(v128.le<real>(v128.abs<real>(v128.load(w.v + o)), limit))) invalidCount++;
    }
  }
  return invalidCount;
}

// The multiple of their radius within which bodies are handled: contacts need those near a wall, too.
// @ts-ignore: decorator
@inline function reachOf(c: Columns): v128 {
  return splat(c.contacts == 0 ? <real>1 : WALL_MARGIN);
}

// Of contacts with a wall; `o` is the offset of the bodies in a column.
// @ts-ignore: decorator
@inline function restitutionsOf(c: Columns, o: usize, wall: f64): v128 {
  return larger(v128.load(c.restitution + o), splat(<real>wall));
}

// `start` is the address of the bodies' velocities at the start of the step, and `e` their restitutions.
function bounceAndRecord(w: Walls, c: Columns, row: i32, start: usize, e: v128): void {
  bounce(w, row, start, e);
  if (c.contacts == 0) return;
  recordNearWalls(c, row, w.axis, w.x, w.low, 1, w.friction);
  recordNearWalls(c, row, w.axis, w.x, w.high, -1, w.friction);
}

// Only bodies with a radius count: the positions of unused rows are zero, which may be outside for thousands of them.
// @ts-ignore: decorator
@inline function isOutside(x: usize, radius: usize, reach: v128, low: v128, high: v128): v128 {
  const position = v128.load(x);
  const r = mul(v128.load(radius), reach);
  const outside = v128.or(v128.lt<real>(position, add(low, r)), v128.gt<real>(position, sub(high, r)));
  return v128.and(outside, v128.gt<real>(r, splat(0)));
}

// Points inside: +1 at the lower wall, otherwise -1.
// @ts-ignore: decorator
@inline function sideOf(isLow: v128): v128 {
  return v128.bitselect(splat(1), splat(-1), isLow);
}

// Handles one vector of rows of which at least one may be outside.
function bounce(w: Walls, row: i32, start: usize, e: v128): void {
  const x = w.x;
  const v = w.v;
  const low = w.low;
  const high = w.high;
  const dt = w.dt;
  const lag = w.lag;
  const c = columns();
  const zero = splat(0);
  const o = at(row);
  const radius = v128.load(c.radius + o);
  const lower = add(splat(low), radius);
  const upper = sub(splat(high), radius);
  const solid = v128.and(v128.gt<real>(radius, zero), v128.gt<real>(v128.load(c.mass + o), zero));
  holdRestingBodies(w, row, start, lower, upper, v128.and(solid, v128.le<real>(e, splat(REST_RESTITUTION))));
  // A body that contacts pushed beyond a wall and that returns within the step is left alone; correcting it would lift
  // it.
  const displacement = mul(v128.load(v + o), splat(dt));
  const x0 = v128.load(x + o);
  const returns = v128.or(
    v128.and(v128.lt<real>(x0, lower), v128.ge<real>(add(x0, displacement), lower)),
    v128.and(v128.gt<real>(x0, upper), v128.le<real>(add(x0, displacement), upper)),
  );
  const active = v128.andnot(v128.and(solid, v128.le<real>(lower, upper)), returns);
  for (let bounceCount = 0; bounceCount < MAX_BOUNCES; bounceCount++) {
    const position = v128.load(x + o);
    const isLow = v128.lt<real>(position, lower);
    const hit = v128.and(v128.or(isLow, v128.gt<real>(position, upper)), active);
    if (!v128.any_true(hit)) break;
    const plane = v128.bitselect(lower, upper, isLow);
    const side = sideOf(isLow);
    const change = rebound(x + o, v + o, start, plane, side, hit, e, splat(dt), splat(lag));
    recordImpacts(c, w, row, change, side);
  }
  // Bodies still outside are clamped to the inside. A body larger than the gap between the walls is held in the middle.
  const position = v128.load(x + o);
  const inside = smaller(larger(position, lower), upper);
  const tooLarge = v128.and(solid, v128.gt<real>(lower, upper));
  const centred = v128.bitselect(mul(splat(0.5), add(lower, upper)), position, tooLarge);
  v128.store(x + o, v128.bitselect(inside, centred, active));
  v128.store(v + o, v128.andnot(v128.load(v + o), tooLarge));
}

// Holds the lanes `canRest` that began the step at rest on a wall and end it beyond the wall.
function holdRestingBodies(w: Walls, row: i32, start: usize, lower: v128, upper: v128, canRest: v128): void {
  const o = at(row);
  const x = v128.load(w.x + o);
  const origin = v128.load(w.origin + o);
  const resting = v128.and(canRest, v128.eq<real>(v128.load(start), splat(0)));
  const onLow = v128.and(resting, v128.and(v128.lt<real>(x, lower), v128.eq<real>(origin, lower)));
  const onHigh = v128.and(resting, v128.and(v128.gt<real>(x, upper), v128.eq<real>(origin, upper)));
  restingLanes = v128.or(onLow, onHigh);
  impactSpeeds = splat(0);
  if (!v128.any_true(restingLanes)) return;
  const velocity = v128.load(w.v + o);
  v128.store(w.x + o, v128.bitselect(origin, x, restingLanes));
  v128.store(w.v + o, v128.andnot(velocity, restingLanes));
  const c = columns();
  const side = sideOf(onLow);
  shifts = mul(side, sub(origin, x));
  recordImpacts(c, w, row, v128.and(v128.neg<real>(mul(side, velocity)), restingLanes), side);
}

// Records the bodies that are near a wall but not beyond it.
function recordNearWalls(c: Columns, row: i32, axis: i32, x: usize, plane: real, side: real, friction: real): void {
  for (let body = row; body < row + LANES; body++) {
    const radius = get(c.radius, body);
    const gap = (get(x, body) - plane) * side - radius;
    if (gap < (WALL_MARGIN - <real>1) * radius && get(c.mass, body) > 0) {
      const own = get(c.friction, body);
      const mu = friction < 0 ? own : sqrt<real>(own * friction);
      recordNearWall(body, 0, axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0, mu, gap);
    }
  }
}

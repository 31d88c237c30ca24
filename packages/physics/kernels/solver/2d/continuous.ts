// Continuous collision: a body that moved further in a step than contacts see ahead may have sunk into something, or passed
// through it. It is put back to where it came near the first body without mass on its way, and from there moved along the
// surface for the rest of the step, if that is flat and as far as nothing else is in the way. A bullet is put back to where it came
// near any other body, and is carried along by what goes on moving: or that would have passed it when the step ends. The contact
// there is found in the next step.
//
// Where bullets touch, the solver has held them off each other, and they are stopped only where the core of one would enter the other.
// None is stopped at another body where something of a higher rank would pass it then, such as the wall that drives a heap of bullets
// on: it enters the other, as a body that is no bullet would.
//
// Source: the bounds are those of Box2D 3 (solver.c).
import { TARGET } from '../../collision/narrow-phase/2d/collide-ahead';
import { sineCosine } from '../../math/elementary';
import {
  ASLEEP,
  COLLIDES,
  COMPOUND,
  DYNAMIC,
  FAST,
  MOVES,
  flagsOf,
  poseOf,
  putFlags,
  putWord,
  stateOf,
  word,
} from './body';
import {
  SAFE_PATH,
  WALLS,
  endsAlong,
  findImpact,
  findImpactOf,
  impact,
  isOnRail,
  isPassed,
  isWheel,
  rankOf,
} from './first-impact';
import { turnState } from './integrate-bodies';
import { inverseMassAlong, inverseMassX, inverseMassY } from './motion-locks';
import { passSensors } from './pass-sensors';
import { bodyOf, isBullet, turnTo } from './parts';
import { longestPath, pathOf } from './paths';
import { RigidTable } from './rigid-table';
import { rollOn } from './roll-on';
import { stopOf } from './sweep-shapes';

// A body that moves by more than this part of its least extent may pass through something thin.
const SAFE_PART: real = 0.5;

// Part of its inverse mass that a body must have along a surface to go on along it.
const OPEN: real = 0.999;

// In place of the fraction at which a bullet is stopped, until that is known.
const PENDING: real = 2;

// Bullets come after all others, whose motion is known then.
export function stopFastBodies(table: usize): void {
  const t = changetype<RigidTable>(table);
  let bullets = 0;
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const flags = flagsOf(t, row) & ~FAST;
    const mayStop = (flags & DYNAMIC) != 0 && (flags & (COLLIDES | COMPOUND)) != 0;
    const path = mayStop ? pathOf(t, row) : <real>0;
    const extent = SAFE_PART * poseOf(t, row).minExtent;
    putFlags(t, row, path > extent ? flags | FAST : flags);
    if (path <= min<real>(extent, SAFE_PATH)) continue;
    if (isBullet(t, row)) {
      putWord(t.bullets, bullets++, row);
      putStop(t, row, PENDING);
    } else stopBody(t, row, -1);
  }
  if (bullets == 0) return;
  const reach = longestPath(t);
  for (let i = 0; i < bullets; i++) stopBody(t, word(t.bullets, i), reach);
}

// With a `reach` of 0 and more the body is a bullet, and others may have left their boxes by so much. What it cannot stay out of
// without being passed by something of a higher rank it enters, as any body does.
function stopBody(t: RigidTable, row: i32, reach: real): void {
  const state = stateOf(t, row);
  const dx = state.dx;
  const dy = state.dy;
  const turned = state.turned;
  let rank = reach < 0 ? WALLS : 0;
  let first = sweepBody(t, row, reach, rank);
  while (first < 0) {
    state.dx = dx;
    state.dy = dy;
    state.turned = turned;
    turnState(state);
    first = sweepBody(t, row, reach, ++rank);
  }
  putStop(t, row, first);
  if (t.sensorCount > 0) passSensors(t, row);
}

// What `sweepBody` returns where something of a higher rank would pass the body, or it is wedged.
const NOWHERE: real = -1;

// Stops a body at what is of a rank and more. Returns the fraction of the step at which it is stopped.
function sweepBody(t: RigidTable, row: i32, reach: real, rank: i32): real {
  const first = findImpactOf(t, row, reach, rank);
  if (rank < WALLS && impact.isWedged) return NOWHERE;
  if (first < 1) {
    putFlags(t, row, flagsOf(t, row) | FAST);
    return stopAt(t, row, first, reach, rank);
  }
  // Its contacts are those of the middle of the step, as of what rolls slowly (mid-step.ts).
  if (isWheel(t, row)) putFlags(t, row, flagsOf(t, row) & ~FAST);
  return 1;
}

// Deals with an impact at a fraction of the step. Returns the fraction at which the body is stopped after all.
function stopAt(t: RigidTable, row: i32, fraction: real, reach: real, rank: i32): real {
  let first = fraction;
  if (isOnRail(t)) {
    const time = rollOn(t, row, first);
    first = rank == WALLS ? <real>1 : findImpactOf(t, row, reach, rank);
    if (first == 1) return time;
  } else if (rank == WALLS && !impact.touches && glide(t, row, first)) {
    first = findImpact(t, row, -1);
    if (first == 1) return 1;
  }
  moveBack(t, row, first);
  if (rank == WALLS) return first;
  const met = rankOf(t, bodyOf(t, impact.other));
  if (met < WALLS && carry(t, row, first)) {
    first = findImpact(t, row, -1);
    if (first < 1) moveBack(t, row, first);
  }
  return isPassed(t, row, reach, met < WALLS ? met + 1 : 1) ? NOWHERE : first;
}

// @ts-ignore: decorator
@inline function putStop(t: RigidTable, row: i32, fraction: real): void {
  store<f32>(t.stops + ((<usize>row) << 2), <f32>fraction);
}

// Moves a body along the surface from where it meets it, if there is some way to go. It does not turn any further. Where the surface
// is no longer the same there, as on a round one, the body stays: the next step finds the normal of the impact. So does one that is locked
// along an axis, but for a surface along the other.
function glide(t: RigidTable, row: i32, fraction: real): bool {
  if (inverseMassAlong(t, row, impact.ny, -impact.nx) < OPEN * poseOf(t, row).inverseMass) return false;
  const state = stateOf(t, row);
  const left = <real>1 - fraction;
  const along = left * (state.dx * impact.ny - state.dy * impact.nx);
  if (abs<real>(along) < TARGET) return false;
  const dx = state.dx;
  const dy = state.dy;
  const turned = state.turned;
  moveBack(t, row, fraction);
  moveBy(t, row, along * impact.ny, -along * impact.nx);
  if (endsAlong(t, row)) return true;
  state.dx = dx;
  state.dy = dy;
  state.turned = turned;
  turnState(state);
  return false;
}

// Moves a bullet with the body that it meets until that body stops. One that is a bullet itself is yet to be stopped by this one.
function carry(t: RigidTable, row: i32, fraction: real): bool {
  const other = bodyOf(t, impact.other);
  const stop = stopOf(t, other);
  if ((flagsOf(t, other) & MOVES) == 0 || (flagsOf(t, other) & ASLEEP) != 0) return false;
  if (stop > 1 || fraction >= stop) return false;
  const state = stateOf(t, row);
  const by = stateOf(t, other);
  const part = (stop - fraction) / stop;
  const dx = part * by.dx;
  const dy = part * by.dy;
  const x = poseOf(t, row).x - poseOf(t, other).x + (state.dx - (by.dx - dx));
  const y = poseOf(t, row).y - poseOf(t, other).y + (state.dy - (by.dy - dy));
  turnTo(<f64>(part * by.turned));
  const c = <real>sineCosine.cosine;
  const s = <real>sineCosine.sine;
  moveBy(t, row, dx + (c * x - s * y - x), dy + (s * x + c * y - y));
  return true;
}

// Adds to the way of a body, but along locked axes.
function moveBy(t: RigidTable, row: i32, x: real, y: real): void {
  const state = stateOf(t, row);
  if (inverseMassX(t, row) > 0) state.dx += x;
  if (inverseMassY(t, row) > 0) state.dy += y;
}

// The velocity stays: the contact of the next step takes it.
function moveBack(t: RigidTable, row: i32, fraction: real): void {
  const state = stateOf(t, row);
  state.dx *= fraction;
  state.dy *= fraction;
  state.turned *= fraction;
  turnState(state);
}

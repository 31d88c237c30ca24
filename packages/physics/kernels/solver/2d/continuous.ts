// Continuous collision: a body that moved further in a step than contacts see ahead may have sunk into something, or passed
// through it. It is put back to where it came near the first body without mass on its way, unless it only goes along the
// surface, and a bullet to where it came near any other; the contact there is found in the next step. Where a body that moved
// by more than half its least extent started in contact, it slides along the surface, if a core of a quarter of its size would
// pass through.
//
// Source: the bounds are those of Box2D 3 (solver.c); time of impact: narrow-phase/2d/time-of-impact.ts.
import { SHAPE_BYTES, Shape } from '../../collision/shapes/2d/shape';
import { makeCircle, shapeOf } from '../../collision/shapes/2d/shape-pool';
import { FatBox } from '../../collision/broad-phase/2d/fat-boxes';
import { areJoined, filtersMeet } from '../../collision/broad-phase/2d/pair-filter';
import { nextLeaf, nodeAt } from '../../collision/broad-phase/2d/box-tree';
import { isIgnored } from '../../collision/narrow-phase/2d/new-pairs';
import { SPECULATIVE_DISTANCE } from '../../collision/narrow-phase/2d/update-contacts';
import { isUpperSide } from '../../collision/narrow-phase/2d/one-way';
import { Sweep, timeOfImpact } from '../../collision/narrow-phase/2d/time-of-impact';
import {
  COLLIDES,
  COMPOUND,
  DYNAMIC,
  FAST,
  JOINED,
  ONE_WAY,
  SENSOR,
  flagsOf,
  poseOf,
  putFlags,
  putWord,
  stateOf,
  word,
} from './body';
import { passSensors } from './pass-sensors';
import { bodyOf } from './parts';
import { longestPath, pathOf } from './paths';
import { RigidTable } from './rigid-table';
import { shapeAt } from './walls';
import { measurePath, startSweepA, startSweepB, stopOf, sweepInPhases } from './sweep-shapes';

// A body that moves by more than this part of its least extent may pass through something thin.
const SAFE_PART: real = 0.5;
const CORE_PART: real = 0.25;
// How near a body is put: the slop of 5 mm, so that the contact is found.
const TARGET: real = 0.005;
// A body that moves by less than contacts see ahead and the slop sinks in by less than the slop. One that joints hold
// may sink in further: it would be put back without the others, and the joint torn apart by as much.
const SAFE_PATH: real = SPECULATIVE_DISTANCE + TARGET;

const sweep = changetype<Sweep>(memory.data(offsetof<Sweep>() + 8, 8));
const spareA = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const spareB = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const core = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const path = changetype<FatBox>(memory.data(offsetof<FatBox>() + 8, 8));

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
    if (path <= ((flags & JOINED) != 0 ? extent : min<real>(extent, SAFE_PATH))) continue;
    if (isBullet(t, row)) putWord(t.bullets, bullets++, row);
    else stopBody(t, row, -1);
  }
  if (bullets == 0) return;
  const reach = longestPath(t);
  for (let i = 0; i < bullets; i++) stopBody(t, word(t.bullets, i), reach);
}

// A compound is a bullet when one of its parts is.
function isBullet(t: RigidTable, row: i32): bool {
  if (word(t.bullet, row) != 0) return true;
  for (let part = word(t.firstParts, row); part != 0; part = word(t.nextParts, part)) {
    if (word(t.bullet, part) != 0) return true;
  }
  return false;
}

// With a `reach` of 0 and more the body is a bullet, and others may have left their boxes by so much.
function stopBody(t: RigidTable, row: i32, reach: real): void {
  let first: real = 1;
  if ((flagsOf(t, row) & COLLIDES) != 0) first = firstImpact(t, row, row, reach, first);
  for (let part = word(t.firstParts, row); part != 0; part = word(t.nextParts, part)) {
    first = firstImpact(t, row, part, reach, first);
  }
  // A shape of it touches something already: it does not fly.
  if (first == 0) first = 1;
  store<f32>(t.stops + ((<usize>row) << 2), <f32>first);
  if (first < 1) {
    putFlags(t, row, flagsOf(t, row) | FAST);
    moveBack(t, row, first);
  }
  if (t.sensorCount > 0) passSensors(t, row);
}

// The fraction of the step at which a shape of a body meets something, at most `first`.
function firstImpact(t: RigidTable, body: i32, row: i32, reach: real, first: real): real {
  if ((flagsOf(t, row) & SENSOR) != 0) return first;
  const shape = shapeOf(row, spareB);
  startSweepB(t, sweep, body, row);
  measurePath(path, sweep, shape, 0);
  const still = firstInTree(t, t.staticNodes, t.staticNodeCount, body, row, shape, first);
  if (reach < 0) return still;
  measurePath(path, sweep, shape, reach);
  return firstInTree(t, t.movingNodes, t.movingNodeCount, body, row, shape, still);
}

function firstInTree(t: RigidTable, nodes: usize, count: i32, body: i32, row: i32, shape: Shape, least: real): real {
  const mayPass = (flagsOf(t, body) & FAST) != 0;
  let first = least;
  for (let i = nextLeaf(nodes, count, 0, path); i < count; i = nextLeaf(nodes, count, i + 1, path)) {
    const other = nodeAt(nodes, i).row;
    if (!mayStop(t, body, row, other)) continue;
    const fraction = impactWith(t, other, shape, mayPass);
    if (fraction == SLIDES) {
      slide(t, body, sweep.nx, sweep.ny);
      startSweepB(t, sweep, body, row);
    } else {
      first = min<real>(first, fraction);
    }
  }
  return first;
}

// @ts-ignore: decorator
@inline function mayStop(t: RigidTable, body: i32, row: i32, other: i32): bool {
  if ((flagsOf(t, other) & SENSOR) != 0 || !filtersMeet(t, row, other)) return false;
  const otherBody = bodyOf(t, other);
  if (otherBody == body || areJoined(t, body, otherBody)) return false;
  return t.asksUser == 0 || !isIgnored(t, row, other);
}

// What `impactWith` returns for a shape that slides along another from the start of the step.
const SLIDES: real = 2;

// The fraction of the step at which the shape of the sweep meets another; 1 for never, and 0 where it starts in contact and may
// not pass through: it does not fly then, and is left to its contacts, or it would halt at every seam of a floor.
function impactWith(t: RigidTable, other: i32, shape: Shape, mayPass: bool): real {
  startSweepA(t, sweep, other);
  sweep.target = TARGET;
  if (!mayPass && !maySink(shape)) return 1;
  const wall = shapeAt(t, other, spareA);
  const stop = stopOf(t, other);
  if (stop < 1) sweepInPhases(sweep, wall, shape, stop);
  else timeOfImpact(sweep, wall, shape);
  if (sweep.isHit == 0) return 1;
  if ((flagsOf(t, other) & ONE_WAY) != 0 && (sweep.fraction == 0 || !isUpperSide(t, other, sweep.nx, sweep.ny)))
    return 1;
  if (sweep.fraction > 0) return entersDeep(wall, shape) ? sweep.fraction : 1;
  if (!mayPass) return 0;
  const nx = sweep.nx;
  const ny = sweep.ny;
  makeCircle(core, CORE_PART * shape.minExtent);
  timeOfImpact(sweep, wall, core);
  if (sweep.isHit == 0 || sweep.fraction == 0) return 1;
  if (nx == 0 && ny == 0) return sweep.fraction;
  sweep.nx = nx;
  sweep.ny = ny;
  return SLIDES;
}

// Whether the second shape moves so far against the first that it may enter it by more than the slop. A body that a turning drum
// carries does not.
function maySink(shape: Shape): bool {
  const c = sweep.ac * sweep.endAc + sweep.as * sweep.endAs;
  const s = sweep.ac * sweep.endAs - sweep.as * sweep.endAc;
  const x = sweep.bx - sweep.ax;
  const y = sweep.by - sweep.ay;
  const dx = sweep.endBx - sweep.endAx - (c * x - s * y);
  const dy = sweep.endBy - sweep.endAy - (c * y + s * x);
  const cb = sweep.bc * sweep.endBc + sweep.bs * sweep.endBs;
  const sb = sweep.bc * sweep.endBs - sweep.bs * sweep.endBc;
  const turn = abs<real>(sb * c - cb * s) * shape.extent;
  const limit = SAFE_PATH - turn;
  return limit < 0 || dx * dx + dy * dy > limit * limit;
}

// Whether the second shape would enter the first too far: by a quarter of its size, so that the contact of the next step might
// push it out on the other side, or by the slop where it flies against a surface at more than 45 degrees, so that it would be
// seen to sink in, and bounce from there. A ball that rolls from one segment to the next does neither.
function entersDeep(wall: Shape, shape: Shape): bool {
  const fraction = sweep.fraction;
  const nx = sweep.nx;
  const ny = sweep.ny;
  const dx = sweep.endBx - sweep.bx - (sweep.endAx - sweep.ax);
  const dy = sweep.endBy - sweep.by - (sweep.endAy - sweep.ay);
  const round = shape.minExtent == shape.extent;
  const turn = round ? <real>0 : abs<real>(sweep.endBs * sweep.bc - sweep.endBc * sweep.bs);
  const into = -(dx * nx + dy * ny);
  const depth = (<real>1 - fraction) * (shape.extent * turn + into);
  const isSteep = into > 0 && <real>2 * into * into > dx * dx + dy * dy;
  const limit = min<real>(isSteep ? TARGET : <real>Infinity, CORE_PART * shape.minExtent);
  if (depth < limit) return false;
  if (!round) return true;
  makeCircle(core, shape.minExtent - limit);
  timeOfImpact(sweep, wall, core);
  sweep.fraction = fraction;
  sweep.nx = nx;
  sweep.ny = ny;
  return sweep.isHit != 0;
}

// Takes the part of the movement that goes into a surface with this normal.
function slide(t: RigidTable, row: i32, nx: real, ny: real): void {
  const state = stateOf(t, row);
  const depth = min<real>(0, state.dx * nx + state.dy * ny);
  state.dx -= depth * nx;
  state.dy -= depth * ny;
}

// The velocity stays: the contact of the next step takes it.
function moveBack(t: RigidTable, row: i32, fraction: real): void {
  const state = stateOf(t, row);
  state.dx *= fraction;
  state.dy *= fraction;
  state.turned *= fraction;
}

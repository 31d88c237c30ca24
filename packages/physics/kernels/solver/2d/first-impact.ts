// The first thing without mass, or for a bullet the first of all, that a body meets on its way through a step, and would enter.
// Where a body that moved by more than half its least extent started in contact, it slides along the surface, if a core of a
// quarter of its size would pass through.
//
// Time of impact: narrow-phase/2d/time-of-impact.ts.
import { CIRCLE, SHAPE_BYTES, Shape } from '../../collision/shapes/2d/shape';
import { makeCircle, shapeOf } from '../../collision/shapes/2d/shape-pool';
import { FatBox } from '../../collision/broad-phase/2d/fat-boxes';
import { areJoined, filtersMeet } from '../../collision/broad-phase/2d/pair-filter';
import { nextLeaf, nodeAt } from '../../collision/broad-phase/2d/box-tree';
import { collideShapes } from '../../collision/narrow-phase/2d/collide-shapes';
import { LEAST_TARGET, TARGET, targetOf } from '../../collision/narrow-phase/2d/collide-ahead';
import { SPECULATIVE_DISTANCE } from '../../collision/narrow-phase/2d/far-points';
import { Manifold, setPoses } from '../../collision/narrow-phase/2d/manifold';
import { flagsOfPair, isIgnored } from '../../collision/narrow-phase/2d/new-pairs';
import { isUpperSide } from '../../collision/narrow-phase/2d/one-way';
import { COVERED, TOUCHING } from '../../collision/narrow-phase/2d/rigid-contact';
import { motionOfA, motionOfB, startAtEnd } from '../../collision/narrow-phase/2d/shape-motion';
import { Sweep, timeOfImpact } from '../../collision/narrow-phase/2d/time-of-impact';
import { COLLIDES, DYNAMIC, FAST, JOINED, LOCKED, MOVES, ONE_WAY, ROUND, SENSOR, flagsOf, stateOf, word } from './body';
import { comesFromBehind, isBeyondEnd, turnToSide } from './chain-impacts';
import { bodyOf, isBullet } from './parts';
import { RigidTable } from './rigid-table';
import { measurePath, startSweepA, startSweepB, stopOf, sweepInPhases } from './sweep-shapes';
import { shapeAt } from './walls';

// The core of a body that must not pass through anything, as part of its least extent.
const CORE_PART: real = 0.25;
// A body that moves by less than contacts see ahead and the slop sinks in by less than the slop.
export const SAFE_PATH: real = SPECULATIVE_DISTANCE + TARGET;
// What flies may enter something in passing by so many times the distance at which an impact counts.
const GRAZE: real = 2;
// A surface is flat as far as its normal turns by less than this angle, rad.
const FLAT: real = 0.001;
// What moves into a surface at an angle with a lower sine goes along it, but for rounding.
const LEVEL: real = 0.00001;

@unmanaged
class Impact {
  // Whether the body touches something at the start of the step.
  touches: bool;
  // Whether it slid along several things that leave it no way.
  isWedged: bool;
  // The shape of the body, and what it meets.
  row: i32;
  other: i32;
  // The normal, from what the body meets to the body.
  nx: real;
  ny: real;
}

// The last that `findImpact` found.
export const impact = changetype<Impact>(memory.data(offsetof<Impact>() + 8, 8));

const sweep = changetype<Sweep>(memory.data(offsetof<Sweep>() + 8, 8));
export const spareA = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const spareB = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const manifold = changetype<Manifold>(memory.data(offsetof<Manifold>() + 16, 16));
const core = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const path = changetype<FatBox>(memory.data(offsetof<FatBox>() + 8, 8));

// Returns the fraction of the step at which a body meets something; 1 for never. With a `reach` of 0 and more other bodies that
// move count, too, which may have left their boxes by so much.
export function findImpact(t: RigidTable, row: i32, reach: real): real {
  impact.touches = false;
  rolls = mayRoll(t, row);
  onAxle = isWheel(t, row);
  let first = firstOfShapes(t, row, reach);
  // Of a body that touches something fewer impacts count; some may have been found before its contact was. One that slides goes another
  // way than was looked at.
  let mustRepeat = hasSlid || (impact.touches && first < 1);
  for (let turn = 0; turn < MAX_TURNS && mustRepeat; turn++) {
    first = firstOfShapes(t, row, reach);
    mustRepeat = hasSlid;
  }
  impact.isWedged = mustRepeat;
  return mustRepeat ? 0 : first;
}

// Of bodies that move those of this rank and more count.
let leastRank: i32 = 0;

// The rank of what does not move.
export const WALLS: i32 = 3;

// What gives way to what, where a bullet cannot stay out of both: bullets to other bodies, these to what has no mass, and all to
// what does not move.
export function rankOf(t: RigidTable, body: i32): i32 {
  if ((flagsOf(t, body) & MOVES) == 0) return WALLS;
  if ((flagsOf(t, body) & DYNAMIC) == 0) return 2;
  return isBullet(t, body) ? 0 : 1;
}

// As `findImpact` with a reach, for bodies of a rank and more.
export function findImpactOf(t: RigidTable, row: i32, reach: real, rank: i32): real {
  leastRank = rank;
  const first = findImpact(t, row, rank < WALLS ? reach : -1);
  leastRank = 0;
  return first;
}

// Whether bodies of a rank and more that move would pass the body on its way. Where they are flush with it from the start they take it
// along, unless it is wedged.
export function isPassed(t: RigidTable, row: i32, reach: real, rank: i32): bool {
  passesWalls = true;
  const first = findImpactOf(t, row, reach, rank);
  passesWalls = false;
  return first < 1;
}

// Whether what does not move is left out.
let passesWalls: bool = false;

// What slides this often in one step is wedged.
const MAX_TURNS: i32 = 4;

// Whether `firstOfShapes` changed the way of the body.
let hasSlid: bool = false;

// Whether the body is deflected by what it meets while it touches something else (roll-on.ts).
let rolls: bool = false;

// Whether the body is a disc that joints hold. What bears a wheel deflects it and all that hangs on it in the next step: to halt it alone
// where it sinks in a little would tear at its joints, and a car in a loop lost most of its energy, or gained some.
// @ts-ignore: decorator
@inline export function isWheel(t: RigidTable, row: i32): bool {
  return (flagsOf(t, row) & (ROUND | JOINED)) == (ROUND | JOINED);
}

// Of the body for which findImpact looks.
let onAxle: bool = false;

// Joints hold a body back that would be deflected alone.
function mayRoll(t: RigidTable, row: i32): bool {
  return (flagsOf(t, row) & (FAST | ROUND | LOCKED | JOINED)) == (FAST | ROUND);
}

// Whether the body rolls or slides along something at rest, and met more of it.
export function isOnRail(t: RigidTable): bool {
  return rolls && impact.touches && (flagsOf(t, impact.other) & MOVES) == 0;
}

function firstOfShapes(t: RigidTable, row: i32, reach: real): real {
  let first: real = 1;
  hasSlid = false;
  if ((flagsOf(t, row) & COLLIDES) != 0) first = firstImpact(t, row, row, reach, first);
  for (let part = word(t.firstParts, row); part != 0; part = word(t.nextParts, part)) {
    first = firstImpact(t, row, part, reach, first);
  }
  return first;
}

// The fraction of the step at which a shape of a body meets something, at most `first`.
function firstImpact(t: RigidTable, body: i32, row: i32, reach: real, first: real): real {
  if ((flagsOf(t, row) & SENSOR) != 0) return first;
  const shape = shapeOf(row, spareB);
  startSweepB(t, sweep, body, row);
  measurePath(path, sweep, shape, 0);
  const still = passesWalls ? first : firstInTree(t, t.staticNodes, t.staticNodeCount, body, row, shape, first);
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
    if (leastRank > 0 && rankOf(t, bodyOf(t, other)) < leastRank) continue;
    const fraction = impactWith(t, row, other, shape, mayPass);
    if (fraction == SLIDES) {
      slide(t, body, sweep);
      hasSlid = true;
      startSweepB(t, sweep, body, row);
    } else if (fraction < first) {
      first = fraction;
      impact.row = row;
      impact.other = other;
      impact.nx = sweep.nx;
      impact.ny = sweep.ny;
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

// Whether both bodies move, and a contact between them acted in this step.
function isSolved(t: RigidTable, row: i32, other: i32): bool {
  if ((flagsOf(t, other) & MOVES) == 0) return false;
  return (flagsOfPair(t, row, other) & (TOUCHING | COVERED)) == TOUCHING;
}

// What `impactWith` returns for a shape that slides along another from the start of the step.
const SLIDES: real = 2;

// The fraction of the step at which the shape of the sweep meets another and would enter it; 1 for never, and where it starts in
// contact, unless it may pass through.
function impactWith(t: RigidTable, row: i32, other: i32, shape: Shape, mayPass: bool): real {
  startSweepA(t, sweep, other);
  const target = targetOf(shape.minExtent);
  sweep.target = target;
  if (!mayPass && !maySink(shape)) return 1;
  const wall = shapeAt(t, other, spareA);
  if (comesFromBehind(sweep, wall)) return 1;
  const stop = stopOf(t, other);
  if (stop < 1) sweepInPhases(sweep, wall, shape, stop);
  else timeOfImpact(sweep, wall, shape);
  if (sweep.isHit == 0 || (shape.kind == CIRCLE && isBeyondEnd(sweep, wall))) return 1;
  if ((flagsOf(t, other) & ONE_WAY) != 0 && (sweep.fraction == 0 || !isUpperSide(t, other, sweep.nx, sweep.ny)))
    return 1;
  const starts = sweep.fraction == 0;
  const isRail = rolls && (flagsOf(t, other) & MOVES) == 0;
  if (starts) impact.touches = true;
  const isEnd = turnToSide(sweep, wall);
  if ((isEnd || (starts && isRail)) && !goesIn(FLAT)) return 1;
  const grazes = onAxle && !goesIn(ROLLING);
  const solved = isSolved(t, row, other);
  if (!solved && !starts && !grazes && endsInside(wall, shape, isRail)) return sweep.fraction;
  if (!mayPass || (solved && starts && isBullet(t, bodyOf(t, other)))) return 1;
  const fraction = sweep.fraction;
  const nx = sweep.nx;
  const ny = sweep.ny;
  const part = CORE_PART * shape.minExtent;
  // What flies or rolls is deflected by what it grazes.
  const graze = impact.touches && !isRail ? SAFE_PATH : GRAZE * target;
  const sinks = solved || grazes || (starts && !isRail);
  moveCore(wall, sinks ? part : max<real>(part, shape.minExtent - graze));
  if (starts && isRail) {
    if (sweep.isHit == 0) return 1;
    if (sweep.fraction > 0) return hitFrom(nx, ny, isMet(wall, shape) ? 0 : SLIDES);
    moveCore(wall, part);
  }
  if (sweep.isHit == 0 || (sweep.fraction == 0 && !centerPasses(wall))) return 1;
  if (!starts) return hitFrom(nx, ny, fraction);
  // The normal of what overlaps deeply is unknown, or that of another side: the core's is left.
  return moveAlong(nx, ny) < 0 ? hitFrom(nx, ny, SLIDES) : SLIDES;
}

// When a core of a radius about the centre of the second shape meets the first.
function moveCore(wall: Shape, radius: real): void {
  makeCircle(core, radius);
  timeOfImpact(sweep, wall, core);
  if (sweep.isHit != 0 && isBeyondEnd(sweep, wall)) sweep.isHit = 0;
}

// Where the core is in something already, the centre of the body must stay on its side. Sets the fraction at which it comes there.
// One that is inside of something solid was put there, or pressed in: its contact pushes it out.
function centerPasses(wall: Shape): bool {
  sweep.target = LEAST_TARGET;
  moveCore(wall, 0);
  if (sweep.isHit == 0 || sweep.gap < -LEAST_TARGET) return false;
  return sweep.fraction > 0 || goesIn(LEVEL);
}

// @ts-ignore: decorator
@inline function hitFrom(nx: real, ny: real, fraction: real): real {
  sweep.nx = nx;
  sweep.ny = ny;
  return fraction;
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

// Whether the shapes have a contact at the start of the step. Where something deep in one segment of a chain is beyond the end of
// another, it has none with that one, which would take its velocity.
function isMet(wall: Shape, shape: Shape): bool {
  if (wall.isChained == 0) return true;
  setPoses(manifold, sweep.bx - sweep.ax, sweep.by - sweep.ay, sweep.ac, sweep.as, sweep.bc, sweep.bs);
  manifold.speculative = SPECULATIVE_DISTANCE;
  manifold.reach = Infinity;
  collideShapes(manifold, wall, shape);
  return manifold.count > 0;
}

// Whether the second shape ends in the first by more than the slop, so that it would be seen to sink in, and bounce from there. A
// body that slides or rolls from one tile or segment of a floor to the next does not, although it meets the end of the next
// one. Where a floor turns up, what is pressed on it may enter further, if it cannot be deflected: to halt it would only press others
// into it.
function endsInside(wall: Shape, shape: Shape, isRail: bool): bool {
  if (impact.touches && !isRail && !goesIn(STEEP)) return false;
  const x = sweep.endBx - sweep.endAx;
  const y = sweep.endBy - sweep.endAy;
  setPoses(manifold, x, y, sweep.endAc, sweep.endAs, sweep.endBc, sweep.endBs);
  manifold.speculative = impact.touches ? -TARGET : -min<real>(TARGET, GRAZE * sweep.target);
  manifold.reach = 0;
  collideShapes(manifold, wall, shape);
  return manifold.count > 0;
}

// Whether the shape that met something ends at the same surface: there, with the same normal.
export function endsAlong(t: RigidTable, body: i32): bool {
  startSweepB(t, sweep, body, impact.row);
  startSweepA(t, sweep, impact.other);
  startAtEnd(motionOfA(sweep));
  startAtEnd(motionOfB(sweep));
  sweep.target = SPECULATIVE_DISTANCE;
  timeOfImpact(sweep, shapeAt(t, impact.other, spareA), shapeOf(impact.row, spareB));
  if (sweep.isHit == 0 || sweep.nx * impact.nx + sweep.ny * impact.ny <= 0) return false;
  return abs<real>(sweep.nx * impact.ny - sweep.ny * impact.nx) < FLAT;
}

// Sines of angles: a wheel rolls along what it meets at less than the first, and what goes from one tile of a floor to the next is
// halted only by what it meets at more than the second, 45 degrees.
const ROLLING: real = 0.15;
const STEEP: real = 0.7071067811865476;

// Whether the second shape moves against the first at more than an angle with this sine.
// @ts-ignore: decorator
@inline function goesIn(sine: real): bool {
  const dx = sweep.endBx - sweep.bx - (sweep.endAx - sweep.ax);
  const dy = sweep.endBy - sweep.by - (sweep.endAy - sweep.ay);
  return dx * sweep.nx + dy * sweep.ny < -sine * sqrt<real>(dx * dx + dy * dy);
}

// How far the second shape moves against the first along a normal.
// @ts-ignore: decorator
@inline function moveAlong(nx: real, ny: real): real {
  return (
    (sweep.endBx - sweep.bx - (sweep.endAx - sweep.ax)) * nx + (sweep.endBy - sweep.by - (sweep.endAy - sweep.ay)) * ny
  );
}

// Takes the part of the movement that goes into a surface with this normal: what moves takes the body along.
function slide(t: RigidTable, row: i32, sweep: Sweep): void {
  const state = stateOf(t, row);
  const depth = min<real>(0, moveAlong(sweep.nx, sweep.ny));
  state.dx -= depth * sweep.nx;
  state.dy -= depth * sweep.ny;
}

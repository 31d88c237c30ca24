// Continuous collision: a body that moved further in a step than half its least extent may have passed through something
// thin. It is put back to where it came near the first body without mass on its way; the contact there is found in the next
// step. Where it started in contact it slides along the surface, if a core of a quarter of its size would pass through.
//
// Source: the bounds are those of Box2D 3 (solver.c); time of impact: narrow-phase/2d/time-of-impact.ts.
import { SHAPE_BYTES, Shape } from '../../collision/shapes/2d/shape';
import { makeCircle, shapeOf } from '../../collision/shapes/2d/shape-pool';
import { FatBox, measureBox, overlaps, rowBox, tight } from '../../collision/broad-phase/2d/fat-boxes';
import { layersMeet } from '../../collision/broad-phase/2d/find-pairs';
import { nodeAt } from '../../collision/broad-phase/2d/box-tree';
import { Sweep, timeOfImpact } from '../../collision/narrow-phase/2d/time-of-impact';
import { COLLIDES, COMPOUND, DYNAMIC, FAST, flagsOf, poseOf, putFlags, stateOf, word } from './body';
import { RigidTable } from './rigid-table';

// A body is fast when it moves by more than this part of its least extent.
const SAFE_PART: real = 0.5;
const CORE_PART: real = 0.25;
// How near a body is put: the slop of 5 mm, so that the contact is found.
const TARGET: real = 0.005;

const sweep = changetype<Sweep>(memory.data(offsetof<Sweep>() + 8, 8));
const spareA = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const spareB = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const core = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const path = changetype<FatBox>(memory.data(offsetof<FatBox>() + 8, 8));

export function stopFastBodies(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const flags = flagsOf(t, row) & ~FAST;
    const fast = (flags & DYNAMIC) != 0 && (flags & (COLLIDES | COMPOUND)) != 0 && isFast(t, row);
    putFlags(t, row, fast ? flags | FAST : flags);
    if (fast) stopBody(t, row);
  }
}

// @ts-ignore: decorator
@inline function isFast(t: RigidTable, row: i32): bool {
  const state = stateOf(t, row);
  const pose = poseOf(t, row);
  const moved = sqrt<real>(state.dx * state.dx + state.dy * state.dy) + abs<real>(state.turned) * pose.extent;
  return moved > SAFE_PART * pose.minExtent;
}

function stopBody(t: RigidTable, row: i32): void {
  let first: real = 1;
  if ((flagsOf(t, row) & COLLIDES) != 0) first = firstImpact(t, row, row, first);
  for (let part = word(t.firstParts, row); part != 0; part = word(t.nextParts, part)) {
    first = firstImpact(t, row, part, first);
  }
  if (first < 1) moveBack(t, row, first);
}

// The fraction of the step at which a shape of a body meets something, at most `first`.
function firstImpact(t: RigidTable, body: i32, row: i32, first: real): real {
  const shape = shapeOf(row, spareB);
  startSweep(t, body, row);
  measurePath(shape);
  let i = 0;
  while (i < t.staticNodeCount) {
    const node = nodeAt(t.staticNodes, i);
    if (!overlaps(changetype<FatBox>(node), path)) {
      i = node.skip;
      continue;
    }
    i++;
    if (node.row == 0 || !layersMeet(t, row, node.row)) continue;
    const fraction = impactWith(t, row, node.row, shape);
    if (fraction == SLIDES) {
      slide(t, body, sweep.nx, sweep.ny);
      startSweep(t, body, row);
    } else {
      first = min<real>(first, fraction);
    }
  }
  return first;
}

// What `impactWith` returns for a shape that slides along another from the start of the step.
const SLIDES: real = 2;

// The way of a shape of a body in this step, as the second of the two that meet.
function startSweep(t: RigidTable, body: i32, row: i32): void {
  const pose = poseOf(t, row);
  const centre = poseOf(t, body);
  const state = stateOf(t, body);
  const fromX = pose.x - centre.x;
  const fromY = pose.y - centre.y;
  sweep.bx = pose.x;
  sweep.by = pose.y;
  sweep.bc = pose.c;
  sweep.bs = pose.s;
  sweep.endBx = centre.x + state.dx + (state.dc * fromX - state.ds * fromY);
  sweep.endBy = centre.y + state.dy + (state.ds * fromX + state.dc * fromY);
  sweep.endBc = pose.c * state.dc - pose.s * state.ds;
  sweep.endBs = pose.s * state.dc + pose.c * state.ds;
}

function measurePath(shape: Shape): void {
  measureBox(shape, sweep.bx, sweep.by, sweep.bc, sweep.bs);
  path.minX = tight.minX;
  path.minY = tight.minY;
  path.maxX = tight.maxX;
  path.maxY = tight.maxY;
  measureBox(shape, sweep.endBx, sweep.endBy, sweep.endBc, sweep.endBs);
  path.minX = min<real>(path.minX, tight.minX);
  path.minY = min<real>(path.minY, tight.minY);
  path.maxX = max<real>(path.maxX, tight.maxX);
  path.maxY = max<real>(path.maxY, tight.maxY);
}

// The fraction of the step at which a shape meets another that does not move; 1 for never.
function impactWith(t: RigidTable, row: i32, other: i32, shape: Shape): real {
  const pose = poseOf(t, other);
  sweep.ax = pose.x;
  sweep.ay = pose.y;
  sweep.ac = pose.c;
  sweep.as = pose.s;
  sweep.endAx = pose.x;
  sweep.endAy = pose.y;
  sweep.endAc = pose.c;
  sweep.endAs = pose.s;
  sweep.target = TARGET;
  const wall = shapeOf(other, spareA);
  timeOfImpact(sweep, wall, shape);
  if (sweep.isHit == 0) return 1;
  if (sweep.fraction > 0) return sweep.fraction;
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

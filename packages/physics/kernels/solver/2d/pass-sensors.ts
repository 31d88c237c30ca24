// Sensors that a fast body passed within one step: the body overlaps them neither at the start nor
// at the end of the step, but in between. The overlap begins and ends in that step. Sensors that move within the step are tested at
// the ends of steps only.
import { SHAPE_BYTES, Shape } from '../../collision/shapes/2d/shape';
import { shapeOf } from '../../collision/shapes/2d/shape-pool';
import { FatBox } from '../../collision/broad-phase/2d/fat-boxes';
import { areJoined, filtersMeet } from '../../collision/broad-phase/2d/pair-filter';
import { nextLeaf, nodeAt } from '../../collision/broad-phase/2d/box-tree';
import { Distance, closestPoints } from '../../collision/narrow-phase/2d/distance';
import { isIgnored } from '../../collision/narrow-phase/2d/new-pairs';
import { RelativePose, setRelative } from '../../collision/narrow-phase/2d/relative-pose';
import { Sweep, timeOfImpact } from '../../collision/narrow-phase/2d/time-of-impact';
import { ASLEEP, COLLIDES, MOVES, SENSOR, flagsOf, poseOf, stateOf, word } from './body';
import { noteSensorBegin, noteSensorEnd } from './contact-events';
import { bodyOf } from './parts';
import { RigidTable } from './rigid-table';
import { measurePath, startSweepA, startSweepB } from './sweep-shapes';

// Surfaces this near overlap, m: a time of impact is found to a fraction of it.
const TARGET: real = 0.0001;

const sweep = changetype<Sweep>(memory.data(offsetof<Sweep>() + 8, 8));
const spareA = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const spareB = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const path = changetype<FatBox>(memory.data(offsetof<FatBox>() + 8, 8));
const nearest = changetype<Distance>(memory.data(offsetof<Distance>() + 8, 8));
const endInSensor = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

export function passSensors(t: RigidTable, body: i32): void {
  if ((flagsOf(t, body) & (COLLIDES | SENSOR)) == COLLIDES) passOf(t, body, body);
  for (let part = word(t.firstParts, body); part != 0; part = word(t.nextParts, part)) {
    if ((flagsOf(t, part) & (COLLIDES | SENSOR)) == COLLIDES) passOf(t, body, part);
  }
}

function passOf(t: RigidTable, body: i32, row: i32): void {
  const shape = shapeOf(row, spareB);
  startSweepB(t, sweep, body, row);
  measurePath(path, sweep, shape, 0);
  passInTree(t, t.staticNodes, t.staticNodeCount, row, shape);
  if (t.movingSensorCount > 0) passInTree(t, t.movingNodes, t.movingNodeCount, row, shape);
}

function passInTree(t: RigidTable, nodes: usize, count: i32, row: i32, shape: Shape): void {
  for (let i = nextLeaf(nodes, count, 0, path); i < count; i = nextLeaf(nodes, count, i + 1, path)) {
    const sensor = nodeAt(nodes, i).row;
    if ((flagsOf(t, sensor) & SENSOR) == 0 || !stays(t, sensor) || !filtersMeet(t, row, sensor)) continue;
    if (areJoined(t, bodyOf(t, row), bodyOf(t, sensor))) continue;
    if (t.asksUser != 0 && isIgnored(t, row, sensor)) continue;
    if (!passes(t, sensor, shape)) continue;
    noteSensorBegin(t, sensor, row);
    noteSensorEnd(t, sensor, row);
  }
}

// Whether a shape is where it was when the step began.
function stays(t: RigidTable, row: i32): bool {
  const flags = flagsOf(t, row);
  if ((flags & MOVES) == 0 || (flags & ASLEEP) != 0) return true;
  const state = stateOf(t, bodyOf(t, row));
  return state.dx == 0 && state.dy == 0 && state.turned == 0;
}

function passes(t: RigidTable, sensor: i32, shape: Shape): bool {
  startSweepA(t, sweep, sensor);
  sweep.target = TARGET;
  const area = shapeOf(sensor, spareA);
  timeOfImpact(sweep, area, shape);
  if (sweep.isHit == 0 || sweep.fraction == 0) return false;
  setRelative(endInSensor, poseOf(t, sensor), sweep.endBx, sweep.endBy, sweep.endBc, sweep.endBs);
  closestPoints(nearest, area, shape, endInSensor);
  return nearest.distance > area.radius + shape.radius;
}

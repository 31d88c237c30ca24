// The motion of shapes in a step, for the time of impact: from the pose at the start of the step by the movement of the body.
import { FatBox, measureBox, tight } from '../../collision/broad-phase/2d/fat-boxes';
import {
  ShapeMotion,
  motionOfA,
  motionOfB,
  move,
  startAtEnd,
  stay,
} from '../../collision/narrow-phase/2d/shape-motion';
import { Sweep, timeOfImpact } from '../../collision/narrow-phase/2d/time-of-impact';
import { Shape } from '../../collision/shapes/2d/shape';
import { ASLEEP, BodyPose, FAST, MOVES, flagsOf, poseOf, stateOf } from './body';
import { bodyOf } from './parts';
import { RigidTable } from './rigid-table';

// Where the motion of a disc starts in a step in which it was deflected, m from where it was.
let legX: real = 0;
let legY: real = 0;

export function startLeg(x: real, y: real): void {
  legX = x;
  legY = y;
}

// The motion of a shape of a body, as the second of the two that meet.
export function startSweepB(t: RigidTable, sweep: Sweep, body: i32, row: i32): void {
  const motion = motionOfB(sweep);
  startAt(motion, poseOf(t, row));
  follow(t, motion, body, row);
  motion.x += legX;
  motion.y += legY;
}

// The motion of another shape, as the first of the two. A shape that sleeps or is static stays where it is.
export function startSweepA(t: RigidTable, sweep: Sweep, row: i32): void {
  const motion = motionOfA(sweep);
  startAt(motion, poseOf(t, row));
  const flags = flagsOf(t, row);
  if ((flags & MOVES) != 0 && (flags & ASLEEP) == 0) follow(t, motion, bodyOf(t, row), row);
}

// @ts-ignore: decorator
@inline function startAt(motion: ShapeMotion, pose: BodyPose): void {
  stay(motion, pose.x, pose.y, pose.c, pose.s);
}

// Where the movement of its body takes a shape.
// @ts-ignore: decorator
@inline function follow(t: RigidTable, motion: ShapeMotion, body: i32, row: i32): void {
  const pose = poseOf(t, row);
  const centre = poseOf(t, body);
  const state = stateOf(t, body);
  move(motion, pose.x - centre.x, pose.y - centre.y, state.dx, state.dy, state.dc, state.ds);
}

// Writes the box about the path of the second shape to `path`, and `reach` around it.
export function measurePath(path: FatBox, sweep: Sweep, shape: Shape, reach: real): void {
  measureBox(shape, sweep.bx, sweep.by, sweep.bc, sweep.bs);
  path.minX = tight.minX;
  path.minY = tight.minY;
  path.maxX = tight.maxX;
  path.maxY = tight.maxY;
  measureBox(shape, sweep.endBx, sweep.endBy, sweep.endBc, sweep.endBs);
  path.minX = min<real>(path.minX, tight.minX) - reach;
  path.minY = min<real>(path.minY, tight.minY) - reach;
  path.maxX = max<real>(path.maxX, tight.maxX) + reach;
  path.maxY = max<real>(path.maxY, tight.maxY) + reach;
}

// The fraction of the step at which the body of a shape was stopped; 1 if it was not.
export function stopOf(t: RigidTable, row: i32): real {
  const body = bodyOf(t, row);
  const flags = flagsOf(t, body);
  if ((flags & FAST) == 0 || (flags & MOVES) == 0 || (flags & ASLEEP) != 0) return 1;
  return <real>load<f32>(t.stops + ((<usize>body) << 2));
}

// The time of impact with a first shape that was stopped at a fraction of the step and stays there.
export function sweepInPhases(sweep: Sweep, a: Shape, b: Shape, stop: real): void {
  const bx = sweep.bx;
  const by = sweep.by;
  const bc = sweep.bc;
  const bs = sweep.bs;
  const endX = sweep.endBx;
  const endY = sweep.endBy;
  const endC = sweep.endBc;
  const endS = sweep.endBs;
  sweep.endBx = bx + stop * (endX - bx);
  sweep.endBy = by + stop * (endY - by);
  const c = bc + stop * (endC - bc);
  const s = bs + stop * (endS - bs);
  const length = sqrt<real>(c * c + s * s);
  sweep.endBc = c / length;
  sweep.endBs = s / length;
  timeOfImpact(sweep, a, b);
  if (sweep.isHit != 0) {
    sweep.fraction *= stop;
  } else {
    startAtEnd(motionOfA(sweep));
    startAtEnd(motionOfB(sweep));
    sweep.endBx = endX;
    sweep.endBy = endY;
    sweep.endBc = endC;
    sweep.endBs = endS;
    timeOfImpact(sweep, a, b);
    sweep.fraction = stop + sweep.fraction * (1 - stop);
  }
  sweep.bx = bx;
  sweep.by = by;
  sweep.bc = bc;
  sweep.bs = bs;
  sweep.endBx = endX;
  sweep.endBy = endY;
  sweep.endBc = endC;
  sweep.endBs = endS;
}

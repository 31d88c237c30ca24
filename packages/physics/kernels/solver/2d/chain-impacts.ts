// What an impact with a segment of a chain counts for. As in contacts (narrow-phase/2d/chain-segment.ts), a segment is met from the
// side of its first normal only, and beyond its ends nothing is met: there its neighbour is, or the chain is over. A body that was
// halted there would find no contact in the next step, and hang in the air for ever.
import { AFTER, BEFORE, END, START, isBehind, isChainSegment } from '../../collision/narrow-phase/2d/chain-segment';
import { Sweep } from '../../collision/narrow-phase/2d/time-of-impact';
import { Shape, vertexX, vertexY } from '../../collision/shapes/2d/shape';

// Sine of the angle by which a normal may lean over an end of a segment, so that no disc meets an end of neither of two.
const LEANING: real = 0.01;

// Sine of the angle by which a chain turns at most where it goes straight on, but for rounding.
const STRAIGHT: real = 0.0001;

// Whether the centre of the second shape starts behind a segment: it passes.
export function comesFromBehind(sweep: Sweep, wall: Shape): bool {
  if (!isChainSegment(wall)) return false;
  const dx = sweep.bx - sweep.ax;
  const dy = sweep.by - sweep.ay;
  return isBehind(wall, sweep.ac * dx + sweep.as * dy, sweep.ac * dy - sweep.as * dx);
}

// What `measureEnd` found last. The direction of the segment, m, its length, and the part of the normal that is across it.
let edgeX: real = 0;
let edgeY: real = 0;
let length: real = 0;
let across: real = 0;
// The parts along it, towards the end over which the normal leans, and along and across the next segment there, as sines.
let leaning: real = 0;
let leaningOn: real = 0;
let acrossNext: real = 0;
// Sine of the angle by which the way on turns at the end, against that of the segment: above 0 to its left.
let turn: real = 0;

function measureEnd(sweep: Sweep, wall: Shape): void {
  const x = sweep.ac * sweep.nx + sweep.as * sweep.ny;
  const y = sweep.ac * sweep.ny - sweep.as * sweep.nx;
  edgeX = vertexX(wall, END) - vertexX(wall, START);
  edgeY = vertexY(wall, END) - vertexY(wall, START);
  length = sqrt<real>(edgeX * edgeX + edgeY * edgeY);
  const along = x * edgeX + y * edgeY;
  leaning = abs<real>(along) / length;
  across = (y * edgeX - x * edgeY) / length;
  const end = along < 0 ? START : END;
  const next = along < 0 ? BEFORE : AFTER;
  const nextX = vertexX(wall, next) - vertexX(wall, end);
  const nextY = vertexY(wall, next) - vertexY(wall, end);
  const nextLength = sqrt<real>(nextX * nextX + nextY * nextY);
  turn = (nextY * edgeX - nextX * edgeY) / (length * nextLength);
  leaningOn = (x * nextX + y * nextY) / nextLength;
  // Of the way back, the left is the right of the chain.
  const side: real = end == START ? -1 : 1;
  acrossNext = (side * (y * nextX - x * nextY)) / nextLength;
}

// Whether a disc that met a segment is beyond an end of it: where the chain turns away from the disc there, is over, or turns so that
// the disc is behind its next segment. What starts there has no contact.
export function isBeyondEnd(sweep: Sweep, wall: Shape): bool {
  if (!isChainSegment(wall)) return false;
  measureEnd(sweep, wall);
  const most = sweep.fraction > 0 ? LEANING : <real>0;
  if (leaning <= most || leaningOn <= most) return false;
  return turn * across <= STRAIGHT || acrossNext * across < 0;
}

// What rolls along the inside of a curve presses into the next segment a little and is at the end of that first. Where this segment
// turns towards the body, it would meet its side: the normal there would throw it off the rail. Returns whether it is so.
export function turnToSide(sweep: Sweep, wall: Shape): bool {
  if (!isChainSegment(wall)) return false;
  measureEnd(sweep, wall);
  if (turn * across <= 0) return false;
  const side: real = across > 0 ? 1 : -1;
  sweep.nx = (side * (-sweep.ac * edgeY - sweep.as * edgeX)) / length;
  sweep.ny = (side * (sweep.ac * edgeX - sweep.as * edgeY)) / length;
  return true;
}

// The motion of a shape through a step, as it lies in a Sweep: its pose at the start, and at the end.
import { Sweep } from './time-of-impact';

@unmanaged
export class ShapeMotion {
  x: real;
  y: real;
  c: real;
  s: real;
  endX: real;
  endY: real;
  endC: real;
  endS: real;
}

// @ts-ignore: decorator
@inline export function motionOfA(sweep: Sweep): ShapeMotion {
  return changetype<ShapeMotion>(changetype<usize>(sweep) + offsetof<Sweep>('ax'));
}

// @ts-ignore: decorator
@inline export function motionOfB(sweep: Sweep): ShapeMotion {
  return changetype<ShapeMotion>(changetype<usize>(sweep) + offsetof<Sweep>('bx'));
}

// A shape that stays where it is.
export function stay(motion: ShapeMotion, x: real, y: real, c: real, s: real): void {
  motion.x = motion.endX = x;
  motion.y = motion.endY = y;
  motion.c = motion.endC = c;
  motion.s = motion.endS = s;
}

// A shape that is where its motion ended.
export function startAtEnd(motion: ShapeMotion): void {
  motion.x = motion.endX;
  motion.y = motion.endY;
  motion.c = motion.endC;
  motion.s = motion.endS;
}

// Its body moves by (dx, dy) and turns about a point, from which the shape is at (armX, armY), by an angle with this cosine and sine.
export function move(motion: ShapeMotion, armX: real, armY: real, dx: real, dy: real, c: real, s: real): void {
  motion.endX += dx + (c * armX - s * armY) - armX;
  motion.endY += dy + (s * armX + c * armY) - armY;
  motion.endC = motion.c * c - motion.s * s;
  motion.endS = motion.s * c + motion.c * s;
}

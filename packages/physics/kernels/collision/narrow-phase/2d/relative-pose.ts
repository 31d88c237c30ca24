// The pose of one shape in the frame of another. Positions are subtracted before anything is rotated, so that shapes far
// from the origin lose no digits.
import { BodyPose } from '../../../solver/2d/body';
import { Manifold } from './manifold';

@unmanaged
export class RelativePose {
  x: real;
  y: real;
  // Cosine and sine of the angle.
  c: real;
  s: real;
}

// The pose of b in the frame of a.
// @ts-ignore: decorator
@inline export function poseOfB(pose: RelativePose, m: Manifold): void {
  const dx = m.bx - m.ax;
  const dy = m.by - m.ay;
  pose.x = m.ac * dx + m.as * dy;
  pose.y = m.ac * dy - m.as * dx;
  pose.c = m.ac * m.bc + m.as * m.bs;
  pose.s = m.ac * m.bs - m.as * m.bc;
}

// A pose with cosine c and sine s in the frame of a body.
// @ts-ignore: decorator
@inline export function setRelative(to: RelativePose, frame: BodyPose, x: real, y: real, c: real, s: real): void {
  const dx = x - frame.x;
  const dy = y - frame.y;
  to.x = frame.c * dx + frame.s * dy;
  to.y = frame.c * dy - frame.s * dx;
  to.c = frame.c * c + frame.s * s;
  to.s = frame.c * s - frame.s * c;
}

// The pose of the first shape in the frame of the second.
// @ts-ignore: decorator
@inline export function invert(to: RelativePose, from: RelativePose): void {
  to.x = -(from.c * from.x + from.s * from.y);
  to.y = from.s * from.x - from.c * from.y;
  to.c = from.c;
  to.s = -from.s;
}

// @ts-ignore: decorator
@inline export function pointX(pose: RelativePose, x: real, y: real): real {
  return pose.x + (pose.c * x - pose.s * y);
}

// @ts-ignore: decorator
@inline export function pointY(pose: RelativePose, x: real, y: real): real {
  return pose.y + (pose.s * x + pose.c * y);
}

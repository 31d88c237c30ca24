// When two shapes that move through a step first come within a distance of each other, by conservative advancement: along
// the line between their nearest points they approach no faster than their velocities and rotations let any of their
// points, so time may go on until they could be there at that rate, again and again. Source: Mirtich, Impulse-based
// dynamic simulation of rigid body systems (1996), chapter 2; Ericson, Real-time collision detection (2005), section
// 5.5.2. Rotations of less than half a turn a step are followed.
import { Shape } from '../../shapes/2d/shape';
import { Distance, closestPoints } from './distance';
import { RelativePose } from './relative-pose';

@unmanaged
export class Sweep {
  // 1 when the shapes come within `target` of each other, or start so.
  isHit: i32;
  // Poses of a at the start and at the end of the step: position, m, cosine and sine of the angle; then those of b.
  ax: real;
  ay: real;
  ac: real;
  as: real;
  endAx: real;
  endAy: real;
  endAc: real;
  endAs: real;
  bx: real;
  by: real;
  bc: real;
  bs: real;
  endBx: real;
  endBy: real;
  endBc: real;
  endBs: real;
  // Distance of the surfaces that counts as an impact, m, above 0. It is met to a quarter.
  target: real;
  // Fraction of the step until then, 1 without an impact. At this moment: normal from a to b, zero where the shapes
  // without their rounding overlap, the point half-way between the surfaces, m, and their distance, below 0 where they overlap.
  fraction: real;
  nx: real;
  ny: real;
  x: real;
  y: real;
  gap: real;
}

// A search that needs more turns has come so near that time hardly goes on: it ends before the impact, never after.
const MAX_TURNS: i32 = 40;

const nearest = changetype<Distance>(memory.data(offsetof<Distance>() + 8, 8));
const bInA = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// Cosine and sine of a at the fraction that was looked at last.
let cosA: real = 1;
let sinA: real = 0;

export function timeOfImpact(sweep: Sweep, a: Shape, b: Shape): void {
  const radii = a.radius + b.radius;
  // What is round about a point comes no nearer as it turns about it.
  const turning =
    turnRate(sweep.ac, sweep.as, sweep.endAc, sweep.endAs) * (a.extent - a.radius) +
    turnRate(sweep.bc, sweep.bs, sweep.endBc, sweep.endBs) * (b.extent - b.radius);
  const moveX = sweep.endBx - sweep.bx - (sweep.endAx - sweep.ax);
  const moveY = sweep.endBy - sweep.by - (sweep.endAy - sweep.ay);
  sweep.isHit = 0;
  sweep.fraction = 0;
  for (let turn = 0; turn < MAX_TURNS; turn++) {
    placeAt(sweep, sweep.fraction);
    closestPoints(nearest, a, b, bInA);
    const gap = nearest.distance - radii;
    const nx = cosA * nearest.nx - sinA * nearest.ny;
    const ny = sinA * nearest.nx + cosA * nearest.ny;
    if (gap <= <real>1.25 * sweep.target) {
      report(sweep, a, b, nx, ny);
      return;
    }
    const approach = turning - (moveX * nx + moveY * ny);
    // Also where the two move apart, and approach is negative.
    if (approach * (1 - sweep.fraction) <= gap - sweep.target) {
      sweep.fraction = 1;
      return;
    }
    sweep.fraction += (gap - sweep.target) / approach;
  }
  report(sweep, a, b, cosA * nearest.nx - sinA * nearest.ny, sinA * nearest.nx + cosA * nearest.ny);
}

// The greatest angular speed, radians a step, of a rotation between two angles whose cosine and sine are interpolated: 2
// tan(angle/2), in the middle.
// @ts-ignore: decorator
@inline function turnRate(c: real, s: real, endC: real, endS: real): real {
  const cosine = c * endC + s * endS;
  const sine = abs<real>(c * endS - s * endC);
  return (<real>2 * sine) / max<real>(1 + cosine, <real>1e-6);
}

// Sets `bInA`, `cosA` and `sinA` to those at a fraction of the step.
function placeAt(sweep: Sweep, t: real): void {
  const ac = sweep.ac + t * (sweep.endAc - sweep.ac);
  const as = sweep.as + t * (sweep.endAs - sweep.as);
  const bc = sweep.bc + t * (sweep.endBc - sweep.bc);
  const bs = sweep.bs + t * (sweep.endBs - sweep.bs);
  const lengthA = sqrt<real>(ac * ac + as * as);
  const lengthB = sqrt<real>(bc * bc + bs * bs);
  cosA = ac / lengthA;
  sinA = as / lengthA;
  const cosB = bc / lengthB;
  const sinB = bs / lengthB;
  // Differences of positions first: they are small where the positions may be large.
  const startX = sweep.bx - sweep.ax;
  const startY = sweep.by - sweep.ay;
  const dx = startX + t * (sweep.endBx - sweep.endAx - startX);
  const dy = startY + t * (sweep.endBy - sweep.endAy - startY);
  bInA.x = cosA * dx + sinA * dy;
  bInA.y = cosA * dy - sinA * dx;
  bInA.c = cosA * cosB + sinA * sinB;
  bInA.s = cosA * sinB - sinA * cosB;
}

function report(sweep: Sweep, a: Shape, b: Shape, nx: real, ny: real): void {
  const t = sweep.fraction;
  const middle = <real>0.5 * (a.radius + nearest.distance - b.radius);
  sweep.isHit = 1;
  sweep.gap = nearest.distance - a.radius - b.radius;
  sweep.nx = nx;
  sweep.ny = ny;
  sweep.x = sweep.ax + t * (sweep.endAx - sweep.ax) + (cosA * nearest.ax - sinA * nearest.ay) + middle * nx;
  sweep.y = sweep.ay + t * (sweep.endAy - sweep.ay) + (sinA * nearest.ax + cosA * nearest.ay) + middle * ny;
}

// For tests: the records at these addresses.
export function sweepPair(sweep: usize, a: usize, b: usize): void {
  timeOfImpact(changetype<Sweep>(sweep), changetype<Shape>(a), changetype<Shape>(b));
}

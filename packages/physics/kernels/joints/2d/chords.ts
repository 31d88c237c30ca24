// What a joint holds moves on an arc. Velocities along the tangent leave it by h² a/2 in a sub-step of h seconds, where a is the
// acceleration of the locked coordinate while no force acts; what pulls them back then takes the energy of the motion. So a
// locked direction gets the speed -h a/2, with which the sub-step is a chord of the arc, and the energy stays where it is. Here
// a chord is h a/2.
//
//   point at r from the centre of its body        a = -ω² r
//   length of d, which moves by d' across it      a = d'²/|d|
//   along an axis u that turns with a body        a = ±2 ω d' - ω² u · d, with d' across u
//
// Speeds are those of the end of the last sub-step: forces, contacts and warm starting change them for a moment. Of a chord as much
// is taken as there is of it in these speeds along the new directions: in a steady motion all of it, and none where an impact has just
// ended it, for this would give energy. Hinges that close loops side by side (solve-loops.ts) take all of it. A body that is held at two
// ends and whose inertia was raised (brace-joints.ts) swings too fast to be followed, and has no chords: its inertia changes, by which
// it would gain energy.
//
// Source: the position constraint of SHAKE to second order in h (Ryckaert, Ciccotti and Berendsen 1977; Hairer, Lubich and
// Wanner, Geometric Numerical Integration, section VII.1.4).
import { jointed } from './brace-joints';
import { JointTable } from './joint-table';
import { JointWork } from './joint-work';

// The chord of a point at a unit distance that turns with the angular velocity w, towards the centre. It is at most half of the speed of
// the point, as where it turns by 1 rad: farther on, the point may be on any side of its circle.
// @ts-ignore: decorator
@inline export function bend(w: f64, halfStep: f64): f64 {
  const speed = abs<f64>(w);
  const part = halfStep * speed;
  return speed * (part < 0.5 ? part : 0.5);
}

// Which part of the chord (x, y) there is in the velocity (vx, vy) of the anchors.
// @ts-ignore: decorator
@inline export function partOfChord(x: f64, y: f64, vx: f64, vy: f64): f64 {
  return partOfLength(x * x + y * y, x * vx + y * vy);
}

// The same, from the squared length of the chord, and its dot product with the velocity.
// @ts-ignore: decorator
@inline export function partOfLength(squaredLength: f64, along: f64): f64 {
  if (!(along > 0)) return 0;
  return along < squaredLength ? along / squaredLength : 1;
}

// What the chords of a joint with rows follow from, once its anchors are known.
export function measureBends(t: JointTable, work: JointWork): void {
  const a = jointed(t, work.a);
  const b = jointed(t, work.b);
  work.bendA = bend(a.w, a.halfStep);
  work.bendB = bend(b.w, b.halfStep);
  work.slideX = b.vx - b.w * work.rby - (a.vx - a.w * work.ray);
  work.slideY = b.vy + b.w * work.rbx - (a.vy + a.w * work.rax);
  work.halfStep = min<f64>(a.halfStep, b.halfStep);
  work.turning = a.w;
}

// The chord of the points of both bodies along the direction (x, y).
// @ts-ignore: decorator
@inline export function chordOfPoints(work: JointWork, x: f64, y: f64): f64 {
  return (work.bendA * work.rax - work.bendB * work.rbx) * x + (work.bendA * work.ray - work.bendB * work.rby) * y;
}

// What of a chord there is in a speed along it.
// @ts-ignore: decorator
@inline export function withinSpeed(chord: f64, speed: f64): f64 {
  return chord > 0 ? max<f64>(0, min<f64>(chord, speed)) : min<f64>(0, max<f64>(chord, speed));
}

// The chord of a length whose end moves by `speed` across it.
// @ts-ignore: decorator
@inline export function chordOfLength(length: f64, speed: f64, halfStep: f64): f64 {
  return bend(speed / length, halfStep) * length;
}

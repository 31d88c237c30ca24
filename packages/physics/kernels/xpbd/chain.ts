// Chains solved directly: Newton's method on all rows of a chain together, whose matrix has three diagonals because a
// row meets only the one before and the one after it. A thousand links are as rigid as one.
//
// For row j between bodies j and j + 1, with its unit vector n_j now and o_j when the sub-step began, flexibility
// e = 1 / (k h^2) and sum of inverse masses w:
//
//   (w n_j.o_j + e) D_j - w_j (n_j.o_j-1) D_j-1 - w_j+1 (n_j.o_j+1) D_j+1 = C_j - e tension_j
//
// Impulses act along o, which makes the scheme that of SHAKE and RATTLE: second order, and no torque. A chain
// of which a row turned by more than 37 degrees in the sub-step is corrected along n; one too taut for directions of the
// start is left to taut-chain.ts. Slack cords, and rows without stiffness or weight, take no part. Sums are f64: the matrix of N links has a condition of N^2. Cost: three divisions and two square roots a row
// and iteration, of which two or three are enough.
import { columns, get, put } from '../memory/columns';
import { SpringTable } from '../forces/springs';
import { packBody } from './nodes';
import { solveRow } from './sweep';
import { isTaut, solveTautChain } from './taut-chain';
import { ConstraintTable, RIGID, isCord, packedAt, part, putPart, tableAt, word } from './table';

// Bytes a row takes of `work`, at most those of taut-chain.ts.
const LINK: usize = 96;

// What elimination keeps of a row.
@unmanaged
class Link {
  // Direction now and when the sub-step began.
  x: f64;
  y: f64;
  z: f64;
  ox: f64;
  oy: f64;
  oz: f64;
  // Share of the next row's unknown, and the known side, both by the pivot.
  upper: f64;
  known: f64;
  pivot: f64;
  active: f64;
  // The unknown itself.
  change: f64;
}

// @ts-ignore: decorator
@inline function linkOf(t: ConstraintTable, row: i32): Link {
  return changetype<Link>(t.work + <usize>row * LINK);
}

// Times Newton's method is tried on a chain, and how far from its length a row may be left.
const NEWTON: i32 = 12;
const TOLERANCE: f64 = 1e-3;
const ROUNDED: f64 = 1e-5;

// Solves every chain to what reals can say. One that bends too sharply for that within the sub-step is solved as if it were
// taut, and where that fails row by row, `iterations` times up and down: that stretches, but nothing upsets it.
export function solveChains(table: usize, iterations: i32, h: f64): void {
  const t = tableAt(table);
  for (let chain = 0; chain < t.chainCount; chain++) {
    const first = <i32>word(t.chains, chain);
    const last = <i32>word(t.chains, chain + 1);
    if (!isTaut(t, first, last)) {
      if (newton(t, first, last, findStart(t, first, last, h))) continue;
      takeBack(t, first, last);
    }
    if (solveTautChain(t, first, last)) continue;
    takeBack(t, first, last);
    for (let i = 0; i < iterations; i++) {
      for (let row = first; row < last; row++) solveRow(t, row);
      for (let row = last - 1; row >= first; row--) solveRow(t, row);
    }
  }
}

// Puts the bodies back where they came from, without tensions.
function takeBack(t: ConstraintTable, first: i32, last: i32): void {
  for (let row = first; row < last; row++) {
    packBody(t, word(t.a, row));
    packBody(t, word(t.b, row));
    put(t.tension, row, 0);
  }
}

function newton(t: ConstraintTable, first: i32, last: i32, sharp: bool): bool {
  const enough: f64 = sizeof<real>() == 4 ? 3e-7 : 1e-14;
  let before: f64 = Infinity;
  for (let row = first; row < last; row++) put(t.tension, row, 0);
  for (let i = 0; i < NEWTON; i++) {
    const error = eliminate(t, first, last, sharp);
    if (error <= enough) return true;
    // Rounding ends what converged; growth ends what does not.
    if (error >= before && error <= ROUNDED) return true;
    if (!(error < 10 * before)) return false;
    before = error;
    substitute(t, first, last);
  }
  return eliminate(t, first, last, sharp) <= TOLERANCE;
}

// Sets the rows up and eliminates downwards; returns the largest error by the length.
function eliminate(t: ConstraintTable, first: i32, last: i32, sharp: bool): f64 {
  let worst: f64 = 0;
  let before = changetype<Link>(0);
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    const pa = packedAt(t, word(t.a, row));
    const pb = packedAt(t, word(t.b, row));
    link.x = <f64>part(pb, 0) - <f64>part(pa, 0);
    link.y = <f64>part(pb, 1) - <f64>part(pa, 1);
    link.z = <f64>part(pb, 2) - <f64>part(pa, 2);
    const d = normalise(link);
    if (sharp) turnNow(link);
    const gain = <f64>get(t.gain, row);
    const length = get(t.length, row);
    const tension = <f64>get(t.tension, row);
    const rest = abs<f64>(<f64>length);
    const e = gain > 0 ? <f64>get(t.softness, row) / gain : 0;
    const error = d - rest - e * tension;
    const slack = isCord(length) && error <= 0 && tension <= 0;
    const wa = <f64>part(pa, 3);
    const wb = <f64>part(pb, 3);
    link.active = gain > 0 && !slack ? 1 : 0;
    if (link.active > 0) worst = max<f64>(worst, abs<f64>(error) / (d + rest));
    eliminateRow(link, before, wa, (wa + wb) * cosine(link, link) + e, error);
    before = link;
  }
  return worst;
}

// One step of the elimination of a matrix with three diagonals.
// @ts-ignore: decorator
@inline function eliminateRow(link: Link, before: Link, wa: f64, diagonal: f64, known: f64): void {
  link.known = 0;
  link.upper = 0;
  if (link.active == 0) return;
  let pivot = diagonal;
  let right = known;
  if (changetype<usize>(before) != 0 && before.active > 0) {
    before.upper = (-wa * cosine(before, link)) / before.pivot;
    const lower = -wa * cosine(link, before);
    pivot -= lower * before.upper;
    right -= lower * before.known;
  }
  // A straight chain between two anchors is held twice: one of its rows has nothing left to say.
  if (!(pivot > 1e-12 * diagonal)) {
    link.active = 0;
    if (changetype<usize>(before) != 0) before.upper = 0;
    return;
  }
  link.pivot = pivot;
  link.known = right / pivot;
}

// Between the direction of one row now and that of another when the sub-step began.
// @ts-ignore: decorator
@inline function cosine(now: Link, start: Link): f64 {
  return now.x * start.ox + now.y * start.oy + now.z * start.oz;
}

// Finds the directions that rows had when the sub-step began: the bodies' columns hold what they had before any
// correction, and their velocities are the way back from there. True where a row turned by more than 37 degrees since.
function findStart(t: ConstraintTable, first: i32, last: i32, h: f64): bool {
  const c = columns();
  let sharp = false;
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    const a = word(t.a, row);
    const b = word(t.b, row);
    pointNow(link, a, b);
    link.ox = link.x - h * (<f64>get(c.velocityX, b) - <f64>get(c.velocityX, a));
    link.oy = link.y - h * (<f64>get(c.velocityY, b) - <f64>get(c.velocityY, a));
    link.oz = link.z - h * (<f64>get(c.velocityZ, b) - <f64>get(c.velocityZ, a));
    normalise(link);
    const d = sqrt<f64>(link.ox * link.ox + link.oy * link.oy + link.oz * link.oz);
    link.ox /= d;
    link.oy /= d;
    link.oz /= d;
    if (!(cosine(link, link) > 0.8)) sharp = true;
  }
  return sharp;
}

// From a to b, by the bodies' columns.
// @ts-ignore: decorator
@inline function pointNow(link: Link, a: u32, b: u32): void {
  const c = columns();
  link.x = <f64>get(c.positionX, b) - <f64>get(c.positionX, a);
  link.y = <f64>get(c.positionY, b) - <f64>get(c.positionY, a);
  link.z = <f64>get(c.positionZ, b) - <f64>get(c.positionZ, a);
}

// @ts-ignore: decorator
@inline function turnNow(link: Link): void {
  link.ox = link.x;
  link.oy = link.y;
  link.oz = link.z;
}

// @ts-ignore: decorator
@inline function normalise(link: Link): f64 {
  const d = sqrt<f64>(link.x * link.x + link.y * link.y + link.z * link.z);
  if (d < 1e-15) {
    link.x = 1;
    link.y = 0;
    link.z = 0;
  } else {
    link.x /= d;
    link.y /= d;
    link.z /= d;
  }
  return d;
}

// Finds the tensions upwards and moves the bodies.
function substitute(t: ConstraintTable, first: i32, last: i32): void {
  let next: f64 = 0;
  for (let row = last - 1; row >= first; row--) {
    const link = linkOf(t, row);
    next = link.active > 0 ? link.known - link.upper * next : 0;
    link.change = next;
  }
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    if (link.active == 0) continue;
    const tension = <f64>get(t.tension, row);
    let by = link.change;
    if (isCord(get(t.length, row)) && tension + by < 0) by = -tension;
    put(t.tension, row, <real>(tension + by));
    moveEnd(packedAt(t, word(t.a, row)), link, by);
    moveEnd(packedAt(t, word(t.b, row)), link, -by);
  }
}

// @ts-ignore: decorator
@inline function moveEnd(p: usize, link: Link, by: f64): void {
  const step = by * <f64>part(p, 3);
  putPart(p, 0, <real>(<f64>part(p, 0) + step * link.ox));
  putPart(p, 1, <real>(<f64>part(p, 1) + step * link.oy));
  putPart(p, 2, <real>(<f64>part(p, 2) + step * link.oz));
}

// Takes from the velocities what would lengthen or shorten the rods of every chain, all at once.
export function solveChainVelocities(table: usize): void {
  const t = tableAt(table);
  const springs = changetype<SpringTable>(t.springs);
  const c = columns();
  for (let chain = 0; chain < t.chainCount; chain++) {
    const first = <i32>word(t.chains, chain);
    const last = <i32>word(t.chains, chain + 1);
    let before = changetype<Link>(0);
    for (let row = first; row < last; row++) {
      const link = linkOf(t, row);
      const a = word(t.a, row);
      const b = word(t.b, row);
      pointNow(link, a, b);
      normalise(link);
      turnNow(link);
      const rate =
        link.x * (<f64>get(c.velocityX, b) - <f64>get(c.velocityX, a)) +
        link.y * (<f64>get(c.velocityY, b) - <f64>get(c.velocityY, a)) +
        link.z * (<f64>get(c.velocityZ, b) - <f64>get(c.velocityZ, a));
      const rigid = <f64>get(springs.stiffness, word(t.source, row)) >= RIGID;
      const slack = isCord(get(t.length, row)) && (rate <= 0 || get(t.tension, row) <= 0);
      link.active = rigid && !slack && get(t.gain, row) > 0 ? 1 : 0;
      const wa = <f64>part(packedAt(t, a), 3);
      eliminateRow(link, before, wa, wa + <f64>part(packedAt(t, b), 3), rate);
      before = link;
    }
    pushChain(t, first, last);
  }
}

function pushChain(t: ConstraintTable, first: i32, last: i32): void {
  let next: f64 = 0;
  for (let row = last - 1; row >= first; row--) {
    const link = linkOf(t, row);
    next = link.active > 0 ? link.known - link.upper * next : 0;
    if (next == 0) continue;
    pushEnd(t, word(t.a, row), link, next);
    pushEnd(t, word(t.b, row), link, -next);
  }
}

// @ts-ignore: decorator
@inline function pushEnd(t: ConstraintTable, body: u32, link: Link, by: f64): void {
  const c = columns();
  const w = by * <f64>part(packedAt(t, body), 3);
  put(c.velocityX, body, <real>(<f64>get(c.velocityX, body) + w * link.x));
  put(c.velocityY, body, <real>(<f64>get(c.velocityY, body) + w * link.y));
  put(c.velocityZ, body, <real>(<f64>get(c.velocityZ, body) + w * link.z));
}

// Solves chains directly, by Newton's method on all rows of a chain at once. The matrix is tridiagonal, because a row
// couples only to the rows before and after it. A thousand links are as rigid as a single link.
//
// For row j between bodies j and j + 1, with unit vector n_j now and o_j at the start of the sub-step, compliance e =
// 1 / (k h^2) and sum of inverse masses w:
//
//   (w n_j.o_j + e) D_j - w_j (n_j.o_j-1) D_j-1 - w_j+1 (n_j.o_j+1) D_j+1 = C_j - e tension_j
//
// Impulses act along o, as in SHAKE and RATTLE: second order, and no torque. If a row of a chain turned by more than
// 37 degrees in the sub-step, the impulses act along n. A chain too taut for directions of the start is left to
// taut-chain.ts. Slack tension-only rows and rows without stiffness or inverse mass are skipped. Sums are f64, since
// the matrix of N links has a condition number of N^2. Cost: three divisions and two square roots per row and
// iteration, of which two or three suffice.
import { columns, get, put } from '../memory/columns';
import { SpringTable } from '../forces/springs';
import { complianceOf } from './chain-node';
import { solveDualChain } from './dual-chain';
import { packBody } from './nodes';
import { stretchBetweenAnchors } from './overstretched';
import { solveRow } from './sweep';
import { isTaut, solveTautChain } from './taut-chain';
import {
  ConstraintTable,
  RIGID,
  isTensionOnly,
  packedAt,
  packedComponent,
  putPackedComponent,
  tableAt,
  word,
} from './table';

// Bytes of scratch memory per row; at most those of taut-chain.ts.
const LINK_BYTES: usize = 112;

// The state of a row between elimination and back substitution.
@unmanaged
class Link {
  // Direction now, and at the start of the sub-step.
  x: f64;
  y: f64;
  z: f64;
  ox: f64;
  oy: f64;
  oz: f64;
  // Coefficient of the next row's unknown, and the right-hand side, both divided by the pivot.
  upper: f64;
  rhs: f64;
  pivot: f64;
  active: f64;
  // The unknown: the change of the tension; after the velocities are solved, the impulse that it took, N s.
  change: f64;
  // Of the velocities: the rate of extension, the diagonal of the matrix, and HELD, LOOSE or SLACK.
  rate: f64;
  diagonal: f64;
  hold: f64;
}

// In the solve of the velocities a row without tension is slack. The others are held, unless that would need a push.
const HELD: f64 = 1;
const LOOSE: f64 = 0;
const SLACK: f64 = -1;

// @ts-ignore: decorator
@inline function linkOf(t: ConstraintTable, row: i32): Link {
  return changetype<Link>(t.scratch + <usize>row * LINK_BYTES);
}

// The maximum number of Newton iterations, and the relative length errors that count as solved and as stalled by rounding.
const MAX_NEWTON_ITERATIONS: i32 = 12;
const TOLERANCE: f64 = 1e-3;
const ROUNDING_TOLERANCE: f64 = 1e-5;
// The maximum number of times that rows are held or let loose in a solve of the velocities.
const MAX_HOLDS: i32 = 12;
// The sum of squares of the angles at which the links of a chain between anchors meet, below which it is nearly straight.
const NEARLY_STRAIGHT: f64 = 1e-3;

// Solves every chain to the precision of `real`. A chain that turns too sharply within the sub-step is solved as a
// taut chain, and if that does not converge, as with heavy loads on light nodes, by its dual, unless its anchors are too
// far apart. If that fails too, it is swept row by row, up and down, `iterations` times, which stretches the chain but
// is always stable.
export function solveChains(table: usize, iterations: i32, h: f64): void {
  const t = tableAt(table);
  for (let chain = 0; chain < t.chainCount; chain++) {
    const first = <i32>word(t.chains, chain);
    const last = <i32>word(t.chains, chain + 1);
    if (!isTaut(t, first, last)) {
      if (solveNewton(t, first, last, findStartDirections(t, first, last, h))) continue;
      restoreBodies(t, first, last);
    }
    if (solveTautChain(t, first, last)) continue;
    if (stretchBetweenAnchors(t, first, last) || solveDualChain(t, first, last)) continue;
    restoreBodies(t, first, last);
    for (let i = 0; i < iterations; i++) {
      for (let row = first; row < last; row++) solveRow(t, row);
      for (let row = last - 1; row >= first; row--) solveRow(t, row);
    }
  }
}

// Restores the bodies of a chain to their positions before the solve, and clears the tensions.
function restoreBodies(t: ConstraintTable, first: i32, last: i32): void {
  for (let row = first; row < last; row++) {
    packBody(t, word(t.a, row));
    packBody(t, word(t.b, row));
    put(t.tension, row, 0);
  }
}

function solveNewton(t: ConstraintTable, first: i32, last: i32, turnsSharply: bool): bool {
  const tolerance: f64 = sizeof<real>() == 4 ? 3e-7 : 1e-14;
  let previousError: f64 = Infinity;
  for (let row = first; row < last; row++) put(t.tension, row, 0);
  for (let i = 0; i < MAX_NEWTON_ITERATIONS; i++) {
    const error = eliminate(t, first, last, turnsSharply, i == 0 ? TOLERANCE : 0);
    if (error <= tolerance) return true;
    // A converged iteration stalls by rounding; a diverging one grows.
    if (error >= previousError && error <= ROUNDING_TOLERANCE) return true;
    if (!(error < 10 * previousError)) return false;
    previousError = error;
    substitute(t, first, last);
    applyChanges(t, first, last);
  }
  return eliminate(t, first, last, turnsSharply, 0) <= TOLERANCE;
}

// Assembles the rows and eliminates forward; returns the largest relative length error. A string that is short of its
// length by more than `margin` of it is slack. All links of a hanging string fall alike before its first link holds
// them: without a margin in the first iteration, each iteration would find one link more.
function eliminate(t: ConstraintTable, first: i32, last: i32, turnsSharply: bool, margin: f64): f64 {
  let largestError: f64 = 0;
  let before = changetype<Link>(0);
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    const pa = packedAt(t, word(t.a, row));
    const pb = packedAt(t, word(t.b, row));
    link.x = <f64>packedComponent(pb, 0) - <f64>packedComponent(pa, 0);
    link.y = <f64>packedComponent(pb, 1) - <f64>packedComponent(pa, 1);
    link.z = <f64>packedComponent(pb, 2) - <f64>packedComponent(pa, 2);
    const d = normalise(link);
    if (turnsSharply) useCurrentDirection(link);
    const gain = <f64>get(t.gain, row);
    const length = get(t.length, row);
    const tension = <f64>get(t.tension, row);
    const restLength = abs<f64>(<f64>length);
    const e = complianceOf(t, row);
    const error = d - restLength - e * tension;
    const slack = isTensionOnly(length) && error <= -margin * restLength && tension <= 0;
    const wa = <f64>packedComponent(pa, 3);
    const wb = <f64>packedComponent(pb, 3);
    link.active = gain > 0 && !slack ? 1 : 0;
    if (link.active > 0) largestError = max<f64>(largestError, abs<f64>(error) / (d + restLength));
    eliminateRow(link, before, wa, (wa + wb) * cosine(link, link) + e, error);
    before = link;
  }
  return largestError;
}

// One step of the forward elimination of a tridiagonal matrix.
// @ts-ignore: decorator
@inline function eliminateRow(link: Link, before: Link, wa: f64, diagonal: f64, rhs: f64): void {
  link.rhs = 0;
  link.upper = 0;
  if (link.active == 0) return;
  let pivot = diagonal;
  let right = rhs;
  if (changetype<usize>(before) != 0 && before.active > 0) {
    before.upper = (-wa * cosine(before, link)) / before.pivot;
    const lower = -wa * cosine(link, before);
    pivot -= lower * before.upper;
    right -= lower * before.rhs;
  }
  // A straight chain between two anchors is overdetermined: one of its rows is redundant.
  if (!(pivot > 1e-12 * diagonal)) return dropRow(link, before);
  link.pivot = pivot;
  link.rhs = right / pivot;
}

// Leaves a redundant row out.
// @ts-ignore: decorator
@inline function dropRow(link: Link, before: Link): void {
  link.active = 0;
  if (changetype<usize>(before) != 0) before.upper = 0;
}

// The cosine between a direction now and one at the start of the sub-step.
// @ts-ignore: decorator
@inline function cosine(now: Link, start: Link): f64 {
  return now.x * start.ox + now.y * start.oy + now.z * start.oz;
}

// Computes the directions at the start of the sub-step: the bodies' columns hold the positions before any correction,
// from which the velocities lead back. Returns true if a row has turned by more than 37 degrees since.
function findStartDirections(t: ConstraintTable, first: i32, last: i32, h: f64): bool {
  const c = columns();
  let turnsSharply = false;
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    const a = word(t.a, row);
    const b = word(t.b, row);
    setVector(link, a, b);
    link.ox = link.x - h * (<f64>get(c.velocityX, b) - <f64>get(c.velocityX, a));
    link.oy = link.y - h * (<f64>get(c.velocityY, b) - <f64>get(c.velocityY, a));
    link.oz = link.z - h * (<f64>get(c.velocityZ, b) - <f64>get(c.velocityZ, a));
    normalise(link);
    const d = sqrt<f64>(link.ox * link.ox + link.oy * link.oy + link.oz * link.oz);
    link.ox /= d;
    link.oy /= d;
    link.oz /= d;
    if (!(cosine(link, link) > 0.8)) turnsSharply = true;
  }
  return turnsSharply;
}

// Sets the vector from a to b by the bodies' columns.
// @ts-ignore: decorator
@inline function setVector(link: Link, a: u32, b: u32): void {
  const c = columns();
  link.x = <f64>get(c.positionX, b) - <f64>get(c.positionX, a);
  link.y = <f64>get(c.positionY, b) - <f64>get(c.positionY, a);
  link.z = <f64>get(c.positionZ, b) - <f64>get(c.positionZ, a);
}

// @ts-ignore: decorator
@inline function useCurrentDirection(link: Link): void {
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

// Back substitution: computes the unknowns.
function substitute(t: ConstraintTable, first: i32, last: i32): void {
  let next: f64 = 0;
  for (let row = last - 1; row >= first; row--) {
    const link = linkOf(t, row);
    next = link.active > 0 ? link.rhs - link.upper * next : 0;
    link.change = next;
  }
}

// Changes the tensions and moves the bodies.
function applyChanges(t: ConstraintTable, first: i32, last: i32): void {
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    if (link.active == 0) continue;
    const tension = <f64>get(t.tension, row);
    let by = link.change;
    if (isTensionOnly(get(t.length, row)) && tension + by < 0) by = -tension;
    put(t.tension, row, <real>(tension + by));
    moveBody(packedAt(t, word(t.a, row)), link, by);
    moveBody(packedAt(t, word(t.b, row)), link, -by);
  }
}

// @ts-ignore: decorator
@inline function moveBody(p: usize, link: Link, by: f64): void {
  const step = by * <f64>packedComponent(p, 3);
  putPackedComponent(p, 0, <real>(<f64>packedComponent(p, 0) + step * link.ox));
  putPackedComponent(p, 1, <real>(<f64>packedComponent(p, 1) + step * link.oy));
  putPackedComponent(p, 2, <real>(<f64>packedComponent(p, 2) + step * link.oz));
}

// Removes the relative velocities along the rods of every chain, with one direct solve per chain. Strings only pull:
// with impulses p and rates u after them, p >= 0 and u <= 0, and one of both is zero. Which rows pull is not to be seen
// from the rates before the solve: those of a hanging string fall alike, and are held up by the first. So all taut rows
// are held at first, and the solve is repeated while one pushes, or one that was let loose for it extends (the
// primal-dual active set method). Source: Hintermueller, Ito, Kunisch, SIAM J. Optim. 13, 865 (2002).
export function solveChainVelocities(table: usize, h: f64): void {
  const t = tableAt(table);
  for (let chain = 0; chain < t.chainCount; chain++) {
    const first = <i32>word(t.chains, chain);
    const last = <i32>word(t.chains, chain + 1);
    const hasStrings = assembleVelocities(t, first, last);
    solveImpulses(t, first, last, h);
    if (hasStrings) {
      for (let i = 0; i < MAX_HOLDS && changeHolds(t, first, last); i++) solveImpulses(t, first, last, h);
    }
    applyImpulses(t, first, last);
  }
}

// Computes directions, rates and diagonals; returns whether a taut row only pulls.
function assembleVelocities(t: ConstraintTable, first: i32, last: i32): bool {
  const springs = changetype<SpringTable>(t.springs);
  const c = columns();
  let hasStrings = false;
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    const a = word(t.a, row);
    const b = word(t.b, row);
    setVector(link, a, b);
    normalise(link);
    useCurrentDirection(link);
    link.rate =
      link.x * (<f64>get(c.velocityX, b) - <f64>get(c.velocityX, a)) +
      link.y * (<f64>get(c.velocityY, b) - <f64>get(c.velocityY, a)) +
      link.z * (<f64>get(c.velocityZ, b) - <f64>get(c.velocityZ, a));
    link.diagonal = <f64>packedComponent(packedAt(t, a), 3) + <f64>packedComponent(packedAt(t, b), 3);
    const rigid = <f64>get(springs.stiffness, word(t.springIds, row)) >= RIGID;
    const isString = isTensionOnly(get(t.length, row));
    link.hold = rigid && get(t.gain, row) > 0 && !(isString && get(t.tension, row) <= 0) ? HELD : SLACK;
    if (isString && link.hold == HELD) hasStrings = true;
  }
  return hasStrings;
}

// Computes the impulses of the rows that are held.
function solveImpulses(t: ConstraintTable, first: i32, last: i32, h: f64): void {
  let before = changetype<Link>(0);
  // Whether all rows since the last anchor are held.
  let hangs = false;
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    const wa = <f64>packedComponent(packedAt(t, word(t.a, row)), 3);
    link.active = link.hold == HELD ? 1 : 0;
    hangs = link.active > 0 && (hangs || wa == 0);
    eliminateRow(link, before, wa, link.diagonal, link.rate);
    if (hangs && wa == link.diagonal) dropIfStraight(link, before, abs<f64>(<f64>get(t.length, row)), h);
    before = link;
  }
  substitute(t, first, last);
}

// With an angle f between its links, a chain whose anchors move apart at u swings at u / f, and is straight when it has moved by f times a
// link. What would be so within the sub-step gets no such speed, which would be 10⁵ m/s where rounding alone bends the links: the
// positions are solved, and the row that ends at the anchor is as redundant as that of a straight chain.
// @ts-ignore: decorator
@inline function dropIfStraight(link: Link, before: Link, length: f64, h: f64): void {
  if (link.active == 0 || link.pivot > NEARLY_STRAIGHT * link.diagonal) return;
  if (2 * h * link.diagonal * abs<f64>(link.rhs) < length) return;
  dropRow(link, before);
}

// Lets rows loose that would push, and holds loose ones that would extend. Returns whether there were any.
function changeHolds(t: ConstraintTable, first: i32, last: i32): bool {
  let changed = false;
  for (let row = first; row < last; row++) {
    const link = linkOf(t, row);
    if (link.hold == SLACK || !isTensionOnly(get(t.length, row))) continue;
    if (link.hold == HELD ? link.change >= 0 : !isExtending(t, row, first, last)) continue;
    link.hold = link.hold == HELD ? LOOSE : HELD;
    changed = true;
  }
  return changed;
}

// Tests whether a loose row extends after the impulses of its neighbours, by more than rounding.
function isExtending(t: ConstraintTable, row: i32, first: i32, last: i32): bool {
  const link = linkOf(t, row);
  let by: f64 = 0;
  if (row > first) {
    const above = linkOf(t, row - 1);
    by += <f64>packedComponent(packedAt(t, word(t.a, row)), 3) * cosine(link, above) * above.change;
  }
  if (row < last - 1) {
    const below = linkOf(t, row + 1);
    by += <f64>packedComponent(packedAt(t, word(t.b, row)), 3) * cosine(link, below) * below.change;
  }
  return link.rate + by > 1e-12 * (abs<f64>(link.rate) + abs<f64>(by));
}

// The impulse of a row in the last sub-step times h. Under RATTLE the correction of the positions, which `tension` holds,
// is about half of it, and that of the velocities the rest.
export function rodImpulse(t: ConstraintTable, row: i32, h: f64): f64 {
  return <f64>get(t.tension, row) + h * linkOf(t, row).change;
}

function applyImpulses(t: ConstraintTable, first: i32, last: i32): void {
  for (let row = last - 1; row >= first; row--) {
    const link = linkOf(t, row);
    if (link.change < 0 && isTensionOnly(get(t.length, row))) link.change = 0;
    if (link.change == 0) continue;
    applyImpulse(t, word(t.a, row), link, link.change);
    applyImpulse(t, word(t.b, row), link, -link.change);
  }
}

// @ts-ignore: decorator
@inline function applyImpulse(t: ConstraintTable, body: u32, link: Link, by: f64): void {
  const c = columns();
  const w = by * <f64>packedComponent(packedAt(t, body), 3);
  put(c.velocityX, body, <real>(<f64>get(c.velocityX, body) + w * link.x));
  put(c.velocityY, body, <real>(<f64>get(c.velocityY, body) + w * link.y));
  put(c.velocityZ, body, <real>(<f64>get(c.velocityZ, body) + w * link.z));
}

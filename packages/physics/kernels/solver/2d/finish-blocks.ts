// Computes what follows from the numbers with which a block of contacts was filled, for all of its contacts at once: levers,
// effective masses, the speeds at which points approach, and anchors.
import { add, div, larger, mul, smaller, splat, sub } from '../../memory/lanes';
import * as block from './contact-block';
import { lanesX, lanesY, lanesZ } from './gather-lanes';
import { RigidTable } from './rigid-table';

export function finishBlocks(t: RigidTable): void {
  for (let i = 0; i < t.blockCount; i++) finishBlock(t, block.blockOf(t, i));
}

// @ts-ignore: decorator
@inline function finishBlock(t: RigidTable, at: usize): void {
  const a = at + block.A;
  const b = at + block.B;
  const vx = sub(lanesX(b, 0), lanesX(a, 0));
  const vy = sub(lanesY(b, 0), lanesY(a, 0));
  const wA = lanesZ(a, 0);
  const wB = lanesZ(b, 0);
  turnNormal(at, mul(inCommon(wA, wB), v128.load(at, block.AHEAD)));
  const turning = add(v128.load(at, block.INERTIA_A), v128.load(at, block.INERTIA_B));
  v128.store(at, reciprocal(turning), block.ROLLING_MASS);
  const bounces = v128.gt<real>(v128.load(at, block.RESTITUTION), splat(0));
  v128.store(at, splat(0), block.RESTITUTION);
  const roundingA = v128.load(at, block.ROUNDING_A);
  const roundingB = v128.load(at, block.ROUNDING_B);
  const apartX = v128.load(at, block.APART_X);
  const apartY = v128.load(at, block.APART_Y);
  for (let p = at + block.POINTS; p < at + block.CONTACT_BLOCK; p += block.POINT) {
    setDistances(at, p, roundingA, roundingB);
    setLevers(at, p, apartX, apartY);
    setMasses(at, p);
    setSpeed(at, p, vx, vy, wA, wB);
  }
  setCornerShares(at, vx, vy, wA, wB);
  const second = v128.load(at, block.POINTS + block.POINT + block.NORMAL_SPEED);
  if (v128.any_true(v128.lt<real>(second, splat(-block.HIT_SPEED)))) t.hitCount++;
  setReach(t, at, bounces);
}

// Levers do not follow where an impact may bounce (impacts/2d takes back what acted at them): where points met, or parted, fast enough.
// @ts-ignore: decorator
@inline function setReach(t: RigidTable, at: usize, bounces: v128): void {
  const first = v128.load(at, block.POINTS + block.NORMAL_SPEED);
  const second = v128.load(at, block.POINTS + block.POINT + block.NORMAL_SPEED);
  const fastest = larger(v128.abs<real>(first), v128.abs<real>(second));
  const impact = v128.and(bounces, v128.ge<real>(fastest, splat(<real>t.restitutionThreshold)));
  const follows = v128.andnot(v128.gt<real>(v128.load(at, block.SHARES), splat(0)), impact);
  v128.store(at, v128.and(reachOf(at), follows), block.REACH);
}

// By which part of it a point may give way more than its effective mass says, which is that of the start. Where it gives way twice as
// much, each pass of the solver overshoots by as much as it corrects; beyond that energy grows.
const MOST_EXCESS: real = 0.5;

// At an inverse moment of inertia I, a lever l that is longer by w lets a point of the effective mass m give way by m I (2 l w + w²)
// more. The root of p w² + q w = MOST_EXCESS, for the larger p and q of both points and directions; infinite where nothing turns.
// @ts-ignore: decorator
@inline function reachOf(at: usize): v128 {
  const shareA = v128.load(at, block.SHARE_A);
  const shareB = sub(splat(1), shareA);
  const turnA = mul(v128.load(at, block.INERTIA_A), shareA);
  const turnB = mul(v128.load(at, block.INERTIA_B), shareB);
  const square = add(mul(turnA, shareA), mul(turnB, shareB));
  let mass = splat(0);
  let half = splat(0);
  for (let p = at + block.POINTS; p < at + block.CONTACT_BLOCK; p += block.POINT) {
    const normal = v128.load(p, block.NORMAL_MASS);
    const tangent = v128.load(p, block.TANGENT_MASS);
    mass = larger(mass, larger(normal, tangent));
    const alongNormal = turned(turnA, v128.load(p, block.NORMAL_LEVER_A), turnB, v128.load(p, block.NORMAL_LEVER_B));
    const alongTangent = turned(turnA, v128.load(p, block.TANGENT_LEVER_A), turnB, v128.load(p, block.TANGENT_LEVER_B));
    half = larger(half, larger(mul(normal, alongNormal), mul(tangent, alongTangent)));
  }
  const most = splat(MOST_EXCESS);
  return div(most, add(half, v128.sqrt<real>(add(mul(half, half), mul(most, mul(mass, square))))));
}

// @ts-ignore: decorator
@inline function turned(turnA: v128, leverA: v128, turnB: v128, leverB: v128): v128 {
  return add(mul(turnA, v128.abs<real>(leverA)), mul(turnB, v128.abs<real>(leverB)));
}

// The angular velocity that two bodies have in common: the slower one if both turn the same way, otherwise 0.
// @ts-ignore: decorator
@inline function inCommon(wA: v128, wB: v128): v128 {
  const zero = splat(0);
  return add(larger(zero, smaller(wA, wB)), smaller(zero, larger(wA, wB)));
}

// The normal stays as it is in all sub-steps, and so it is that of their mean: one that lags behind pushes two smooth boxes along
// their way, which go round each other pressed together.
// @ts-ignore: decorator
@inline function turnNormal(at: usize, tangent: v128): void {
  const cosine = div(splat(1), v128.sqrt<real>(add(splat(1), mul(tangent, tangent))));
  const nx = v128.load(at, block.NX);
  const ny = v128.load(at, block.NY);
  v128.store(at, mul(cosine, sub(nx, mul(tangent, ny))), block.NX);
  v128.store(at, mul(cosine, add(ny, mul(tangent, nx))), block.NY);
}

// A corner on an edge stays where it is on its body. Its lever follows as this body turns, and that of the other what is left of the
// way of the one centre along the other's edge.
// @ts-ignore: decorator
@inline function setCornerShares(at: usize, vx: v128, vy: v128, wA: v128, wB: v128): void {
  const corner = v128.load(at, block.CORNER);
  v128.store(at, splat(0), block.CORNER);
  const ofA = v128.eq<real>(corner, splat(block.CORNER_OF_A));
  const ofB = v128.eq<real>(corner, splat(block.CORNER_OF_B));
  const along = sub(mul(vx, v128.load(at, block.NY)), mul(vy, v128.load(at, block.NX)));
  const partA = part(v128.neg<real>(mul(wA, v128.load(at, block.POINTS + block.ALONG_A))), along);
  const partB = part(mul(wB, v128.load(at, block.POINTS + block.ALONG_B)), along);
  const shareA = v128.bitselect(sub(splat(1), partB), v128.load(at, block.SHARE_A), ofB);
  v128.store(at, v128.bitselect(partA, shareA, ofA), block.SHARE_A);
}

// Between 0 and 1.
// @ts-ignore: decorator
@inline function part(value: v128, whole: v128): v128 {
  return larger(splat(0), smaller(splat(1), div(value, whole)));
}

// Along the normal, to what the surfaces are round about, and the separation less what is between these.
// @ts-ignore: decorator
@inline function setDistances(at: usize, p: usize, roundingA: v128, roundingB: v128): void {
  const nx = v128.load(at, block.NX);
  const ny = v128.load(at, block.NY);
  const a = sub(add(mul(v128.load(p, block.AX), nx), mul(v128.load(p, block.AY), ny)), roundingA);
  const b = add(add(mul(v128.load(p, block.BX), nx), mul(v128.load(p, block.BY), ny)), roundingB);
  v128.store(p, a, block.ALONG_A);
  v128.store(p, b, block.ALONG_B);
  v128.store(p, sub(v128.load(p, block.SEPARATION), sub(b, a)), block.SEPARATION);
}

// Levers at one point of both bodies, of which b is at (apartX, apartY) from a: the anchors of a manifold that is used again have slid
// along each other. A contact with one point has nothing at the second.
// @ts-ignore: decorator
@inline function setLevers(at: usize, p: usize, apartX: v128, apartY: v128): void {
  const nx = v128.load(at, block.NX);
  const ny = v128.load(at, block.NY);
  const shareA = v128.load(at, block.SHARE_A);
  const shareB = sub(v128.load(at, block.SHARES), shareA);
  const exists = v128.gt<real>(v128.load(p, block.NORMAL_MASS), splat(0));
  const anchorAX = v128.load(p, block.AX);
  const anchorAY = v128.load(p, block.AY);
  const anchorBX = v128.load(p, block.BX);
  const anchorBY = v128.load(p, block.BY);
  const slidX = v128.and(add(sub(anchorBX, anchorAX), apartX), exists);
  const slidY = v128.and(add(sub(anchorBY, anchorAY), apartY), exists);
  const ax = add(anchorAX, mul(shareA, slidX));
  const ay = add(anchorAY, mul(shareA, slidY));
  const bx = sub(anchorBX, mul(shareB, slidX));
  const by = sub(anchorBY, mul(shareB, slidY));
  v128.store(p, sub(mul(ax, ny), mul(ay, nx)), block.NORMAL_LEVER_A);
  v128.store(p, sub(mul(bx, ny), mul(by, nx)), block.NORMAL_LEVER_B);
  // The tangent is the normal turned to the right: (ny, -nx).
  v128.store(p, v128.neg<real>(add(mul(ax, nx), mul(ay, ny))), block.TANGENT_LEVER_A);
  v128.store(p, v128.neg<real>(add(mul(bx, nx), mul(by, ny))), block.TANGENT_LEVER_B);
}

// @ts-ignore: decorator
@inline function setMasses(at: usize, p: usize): void {
  const normalA = v128.load(p, block.NORMAL_LEVER_A);
  const normalB = v128.load(p, block.NORMAL_LEVER_B);
  const tangentA = v128.load(p, block.TANGENT_LEVER_A);
  const tangentB = v128.load(p, block.TANGENT_LEVER_B);
  const normal = withTurning(at, v128.load(p, block.NORMAL_MASS), normalA, normalB);
  const tangent = withTurning(at, v128.load(p, block.TANGENT_MASS), tangentA, tangentB);
  v128.store(p, reciprocal(normal), block.NORMAL_MASS);
  v128.store(p, reciprocal(tangent), block.TANGENT_MASS);
}

// Of b from a, the bodies have the velocity (vx, vy); they turn at wA and wB.
// @ts-ignore: decorator
@inline function setSpeed(at: usize, p: usize, vx: v128, vy: v128, wA: v128, wB: v128): void {
  const turningA = mul(wA, v128.load(p, block.NORMAL_LEVER_A));
  const turningB = mul(wB, v128.load(p, block.NORMAL_LEVER_B));
  const moving = add(mul(v128.load(at, block.NX), vx), mul(v128.load(at, block.NY), vy));
  const exists = v128.gt<real>(v128.load(p, block.NORMAL_MASS), splat(0));
  v128.store(p, v128.and(add(moving, sub(turningB, turningA)), exists), block.NORMAL_SPEED);
}

// Adds what bodies that turn yield at the levers of an impulse to an inverse mass.
// @ts-ignore: decorator
@inline function withTurning(at: usize, inverseMass: v128, leverA: v128, leverB: v128): v128 {
  const turnA = mul(mul(v128.load(at, block.INERTIA_A), leverA), leverA);
  const turnB = mul(mul(v128.load(at, block.INERTIA_B), leverB), leverB);
  return add(add(inverseMass, turnA), turnB);
}

// Of 0, 0.
// @ts-ignore: decorator
@inline function reciprocal(value: v128): v128 {
  return v128.and(div(splat(1), value), v128.gt<real>(value, splat(0)));
}

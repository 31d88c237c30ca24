// Contacts in blocks of LANES: soft constraints along the normals, then friction and rolling resistance.
//
// For a point with accumulated impulse λ, effective mass m, relative normal speed u and separation s:
//
//   s > 0     Δλ = -m (u + s/h)                                   it may close within the sub-step, and not more
//   s <= 0    Δλ = -m (q u + max(q r s, -v)) - p λ                r, q, p: bias rate, mass and impulse scale (softness.ts)
//   relaxing  Δλ = -m u                                           takes back the speed that pushed the bodies apart
//
// and λ + Δλ is at least 0. Anchors are those at the start of the step, but separations follow the bodies, and turn with
// them; what is round about its anchor keeps its distance. Levers follow by shares (contact-block.ts), so that bodies that are pressed
// together make no angular momentum. Friction, in the relaxing pass: |λ_t| <= μ λ. Rolling resistance bounds the angular impulse in
// the same way.
// Sources: Catto, Solver2D (2024); Macklin et al., Small Steps in Physics Simulation (2019); Box2D 3.
import { add, larger, mul, smaller, splat, sub } from '../../memory/lanes';
import * as block from './contact-block';
import { MOVEMENT, lanesW, lanesX, lanesY, lanesZ, scatter } from './gather-lanes';
import { DEEP_PASSES, deepPairLanes } from './deep-pairs';
import { RigidTable } from './rigid-table';

// The second point of round bodies has no mass.
// @ts-ignore: decorator
@inline function hasSecondPoint(at: usize): bool {
  return v128.any_true(v128.load(at, block.POINTS + block.POINT + block.NORMAL_MASS));
}

// @ts-ignore: decorator
@inline function endOfPoints(at: usize): usize {
  const second = at + block.POINTS + block.POINT;
  return hasSecondPoint(at) ? second + block.POINT : second;
}

// Applies the impulses of the last sub-step once more.
export function warmStartContacts(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.blockCount; i++) warmStartBlock(block.blockOf(t, i));
}

// @ts-ignore: decorator
@inline function warmStartBlock(at: usize): void {
  const nx = v128.load(at, block.NX);
  const ny = v128.load(at, block.NY);
  let normals = splat(0);
  let tangents = splat(0);
  const end = endOfPoints(at);
  let turnA = v128.load(at, block.ROLLING_IMPULSE);
  let turnB = turnA;
  const a = at + block.A;
  const b = at + block.B;
  const dx = sub(lanesX(b, MOVEMENT), lanesX(a, MOVEMENT));
  const dy = sub(lanesY(b, MOVEMENT), lanesY(a, MOVEMENT));
  for (let p = at + block.POINTS; p < end; p += block.POINT) {
    const normal = v128.load(p, block.NORMAL_IMPULSE);
    const tangent = v128.load(p, block.TANGENT_IMPULSE);
    normals = add(normals, normal);
    tangents = add(tangents, tangent);
    turnA = add(
      turnA,
      add(mul(normal, v128.load(p, block.NORMAL_LEVER_A)), mul(tangent, v128.load(p, block.TANGENT_LEVER_A))),
    );
    turnB = add(
      turnB,
      add(mul(normal, v128.load(p, block.NORMAL_LEVER_B)), mul(tangent, v128.load(p, block.TANGENT_LEVER_B))),
    );
  }
  const reach = v128.load(at, block.REACH);
  const along = clamp(add(mul(dx, nx), mul(dy, ny)), reach);
  const across = clamp(sub(mul(dx, ny), mul(dy, nx)), reach);
  const moved = sub(mul(normals, across), mul(tangents, along));
  const movedA = mul(v128.load(at, block.SHARE_A), moved);
  turnA = add(turnA, movedA);
  turnB = sub(turnB, sub(moved, movedA));
  const px = add(mul(normals, nx), mul(tangents, ny));
  const py = sub(mul(normals, ny), mul(tangents, nx));
  const mxA = v128.load(at, block.MASS_AX);
  const myA = v128.load(at, block.MASS_AY);
  const mxB = v128.load(at, block.MASS_BX);
  const myB = v128.load(at, block.MASS_BY);
  const vxA = sub(lanesX(at + block.A, 0), mul(mxA, px));
  const vyA = sub(lanesY(at + block.A, 0), mul(myA, py));
  const wA = sub(lanesZ(at + block.A, 0), mul(v128.load(at, block.INERTIA_A), turnA));
  const vxB = add(lanesX(at + block.B, 0), mul(mxB, px));
  const vyB = add(lanesY(at + block.B, 0), mul(myB, py));
  const wB = add(lanesZ(at + block.B, 0), mul(v128.load(at, block.INERTIA_B), turnB));
  scatter(at + block.A, vxA, vyA, wA, lanesW(at + block.A, 0));
  scatter(at + block.B, vxB, vyB, wB, lanesW(at + block.B, 0));
}

// Softly, with overlap pushed out at a bounded speed.
export function solveContacts(table: usize): void {
  const t = changetype<RigidTable>(table);
  const inverseH = splat(<real>(1 / t.h));
  const speed = splat(<real>-t.contactSpeed);
  const all = i32x4.splat(-1);
  for (let i = 0; i < t.blockCount; i++) {
    const at = block.blockOf(t, i);
    const passes = passesOf(t, at);
    for (let pass = 0; pass < passes; pass++) solveBlock(at, inverseH, speed, true, false, all, all);
  }
  if (t.hitCount > 0) solveHits(t, inverseH, speed, true);
}

// Rigidly and without pushing, with friction.
export function relaxContacts(table: usize): void {
  const t = changetype<RigidTable>(table);
  const inverseH = splat(<real>(1 / t.h));
  const all = i32x4.splat(-1);
  const none = i32x4.splat(0);
  for (let i = 0; i < t.blockCount; i++) {
    const at = block.blockOf(t, i);
    const passes = passesOf(t, at);
    for (let pass = 0; pass < passes; pass++) relaxBlock(at, inverseH, all, pass == 0 ? none : all);
  }
  if (t.hitCount > 0) solveHits(t, inverseH, inverseH, false);
  if (t.deepPairCount > 0) relaxDeepPairs(t, inverseH);
}

// What one point of a contact takes turns the body, which changes the load of the other: after one pass the second bears what it
// should, and the first not quite. Short sub-steps make up for it. In longer ones, s, a column of boxes would lean and fall.
const LONG_SUBSTEP: f64 = 1 / 200;

// @ts-ignore: decorator
@inline function passesOf(t: RigidTable, at: usize): i32 {
  return t.h > LONG_SUBSTEP && hasSecondPoint(at) ? 2 : 1;
}

// Additional passes for contacts with two points that an impact hits: what one point takes turns the body, which changes the load of
// the other, and so does friction. Resting contacts converge over the next sub-steps; an impact has only this one. Soft passes are
// repeated for what is still apart: what falls onto something that gives way would sink in by more.
const HIT_PASSES: i32 = 3;

function solveHits(t: RigidTable, inverseH: v128, slowest: v128, soft: bool): void {
  const all = i32x4.splat(-1);
  for (let pass = 0; pass < HIT_PASSES; pass++) {
    for (let i = 0; i < t.blockCount; i++) {
      const at = block.blockOf(t, i);
      const hit = hitLanes(at);
      if (!v128.any_true(hit)) continue;
      if (soft) solveBlock(at, inverseH, slowest, true, true, hit, all);
      else relaxBlock(at, inverseH, hit, all);
    }
  }
}

function relaxDeepPairs(t: RigidTable, inverseH: v128): void {
  const all = i32x4.splat(-1);
  for (let i = 0; i < t.blockCount; i++) {
    const at = block.blockOf(t, i);
    const lanes = deepPairLanes(t, at);
    if (!v128.any_true(lanes)) continue;
    for (let pass = 0; pass < DEEP_PASSES; pass++) relaxBlock(at, inverseH, lanes, all);
  }
}

function relaxBlock(at: usize, inverseH: v128, lanes: v128, repeat: v128): void {
  solveBlock(at, inverseH, inverseH, false, true, lanes, repeat);
}

// The contacts of a block whose second point is hit. The others must not notice: which share a block depends on all bodies.
// @ts-ignore: decorator
@inline function hitLanes(at: usize): v128 {
  const speed = v128.load(at, block.POINTS + block.POINT + block.NORMAL_SPEED);
  return v128.lt<real>(speed, splat(-block.HIT_SPEED));
}

// @ts-ignore: decorator
@inline function addToTotal(total: usize, impulse: v128): void {
  v128.store(total, add(v128.load(total), impulse));
}

// How far the surfaces are from each other at a point, where b has moved by `along` from a along the normal and both have turned: what
// is d along the normal and at a lever l is at d cos θ + l sin θ then.
// @ts-ignore: decorator
@inline function separationAt(p: usize, along: v128, cA: v128, sA: v128, cB: v128, sB: v128): v128 {
  const alongA = add(mul(cA, v128.load(p, block.ALONG_A)), mul(sA, v128.load(p, block.NORMAL_LEVER_A)));
  const alongB = add(mul(cB, v128.load(p, block.ALONG_B)), mul(sB, v128.load(p, block.NORMAL_LEVER_B)));
  return add(v128.load(p, block.SEPARATION), add(along, sub(alongB, alongA)));
}

// By how much the normal impulse of a point is too large at this speed and separation.
// @ts-ignore: decorator
@inline function changeAt(
  at: usize,
  p: usize,
  impulse: v128,
  speed: v128,
  separation: v128,
  inverseH: v128,
  slowest: v128,
  soft: bool,
): v128 {
  const apart = v128.gt<real>(separation, splat(0));
  const mass = v128.load(p, block.NORMAL_MASS);
  const rigid = add(speed, v128.and(apart, mul(separation, inverseH)));
  if (!soft) return mul(mass, rigid);
  const bias = larger(slowest, mul(v128.load(at, block.BIAS_RATE), separation));
  const massScale = v128.load(at, block.MASS_SCALE);
  const change = v128.bitselect(rigid, add(mul(massScale, speed), bias), apart);
  return add(mul(mass, change), v128.andnot(mul(sub(splat(1), massScale), impulse), apart));
}

// The contacts that such a pass acts on at a point with this separation.
// @ts-ignore: decorator
@inline function repeatedAt(separation: v128, soft: bool, lanes: v128): v128 {
  return soft ? v128.and(lanes, v128.gt<real>(separation, splat(0))) : lanes;
}

// The normals, and when relaxing friction, of a block's contacts: of all, or of `some`, whose lane is set. The total impulse is the
// sum of those with which the sub-steps end. With `repeat`, the pass was made in this sub-step before, and only their change is added.
// @ts-ignore: decorator
@inline function solveBlock(
  at: usize,
  inverseH: v128,
  slowest: v128,
  soft: bool,
  some: bool,
  lanes: v128,
  repeat: v128,
): void {
  const a = at + block.A;
  const b = at + block.B;
  const dx = sub(lanesX(b, MOVEMENT), lanesX(a, MOVEMENT));
  const dy = sub(lanesY(b, MOVEMENT), lanesY(a, MOVEMENT));
  const cA = lanesZ(a, MOVEMENT);
  const sA = lanesW(a, MOVEMENT);
  const cB = lanesZ(b, MOVEMENT);
  const sB = lanesW(b, MOVEMENT);
  let vxA = lanesX(a, 0);
  let vyA = lanesY(a, 0);
  let wA = lanesZ(a, 0);
  const turnedA = lanesW(a, 0);
  let vxB = lanesX(b, 0);
  let vyB = lanesY(b, 0);
  let wB = lanesZ(b, 0);
  const turnedB = lanesW(b, 0);
  const mxA = v128.load(at, block.MASS_AX);
  const myA = v128.load(at, block.MASS_AY);
  const iA = v128.load(at, block.INERTIA_A);
  const mxB = v128.load(at, block.MASS_BX);
  const myB = v128.load(at, block.MASS_BY);
  const iB = v128.load(at, block.INERTIA_B);
  const nx = v128.load(at, block.NX);
  const ny = v128.load(at, block.NY);
  const along = add(mul(dx, nx), mul(dy, ny));
  const moved = clamp(sub(mul(dx, ny), mul(dy, nx)), v128.load(at, block.REACH));
  const shiftA = mul(v128.load(at, block.SHARE_A), moved);
  const shiftB = sub(moved, shiftA);
  const end = endOfPoints(at);
  for (let p = at + block.POINTS; p < end; p += block.POINT) {
    const s = separationAt(p, along, cA, sA, cB, sB);
    const leverA = add(v128.load(p, block.NORMAL_LEVER_A), shiftA);
    const leverB = sub(v128.load(p, block.NORMAL_LEVER_B), shiftB);
    const moving = add(mul(sub(vxB, vxA), nx), mul(sub(vyB, vyA), ny));
    const speed = add(moving, sub(mul(wB, leverB), mul(wA, leverA)));
    const old = v128.load(p, block.NORMAL_IMPULSE);
    const wanted = changeAt(at, p, old, speed, s, inverseH, slowest, soft);
    const change = some ? v128.and(wanted, repeatedAt(s, soft, lanes)) : wanted;
    // Of a number and what is none, these take the number.
    const impulse = smaller(splat(block.MAX_IMPULSE), larger(splat(0), sub(old, change)));
    v128.store(p, impulse, block.NORMAL_IMPULSE);
    const delta = sub(impulse, old);
    if (!soft) addToTotal(p + block.TOTAL_IMPULSE, sub(impulse, v128.and(old, repeat)));
    const px = mul(delta, nx);
    const py = mul(delta, ny);
    vxA = sub(vxA, mul(mxA, px));
    vyA = sub(vyA, mul(myA, py));
    wA = sub(wA, mul(iA, mul(delta, leverA)));
    vxB = add(vxB, mul(mxB, px));
    vyB = add(vyB, mul(myB, py));
    wB = add(wB, mul(iB, mul(delta, leverB)));
  }
  if (!soft) return applyFriction(at, lanes, repeat, along, vxA, vyA, wA, turnedA, vxB, vyB, wB, turnedB);
  scatter(a, vxA, vyA, wA, turnedA);
  scatter(b, vxB, vyB, wB, turnedB);
}

// Friction and rolling resistance, at the velocities that the normals have left. Along the normal, b has moved by `along` from a.
// @ts-ignore: decorator
@inline function applyFriction(
  at: usize,
  lanes: v128,
  repeat: v128,
  along: v128,
  vxA: v128,
  vyA: v128,
  wA: v128,
  turnedA: v128,
  vxB: v128,
  vyB: v128,
  wB: v128,
  turnedB: v128,
): void {
  const mxA = v128.load(at, block.MASS_AX);
  const myA = v128.load(at, block.MASS_AY);
  const iA = v128.load(at, block.INERTIA_A);
  const mxB = v128.load(at, block.MASS_BX);
  const myB = v128.load(at, block.MASS_BY);
  const iB = v128.load(at, block.INERTIA_B);
  const nx = v128.load(at, block.NX);
  const ny = v128.load(at, block.NY);
  const surface = v128.load(at, block.TANGENT_SPEED);
  const moved = clamp(along, v128.load(at, block.REACH));
  const shiftA = mul(v128.load(at, block.SHARE_A), moved);
  const shiftB = sub(moved, shiftA);
  const end = endOfPoints(at);
  let total = splat(0);
  for (let p = at + block.POINTS; p < end; p += block.POINT) {
    const leverA = sub(v128.load(p, block.TANGENT_LEVER_A), shiftA);
    const leverB = add(v128.load(p, block.TANGENT_LEVER_B), shiftB);
    const turning = sub(mul(wB, leverB), mul(wA, leverA));
    const sliding = sub(mul(sub(vxB, vxA), ny), mul(sub(vyB, vyA), nx));
    const speed = add(sub(sliding, surface), turning);
    const normal = v128.load(p, block.NORMAL_IMPULSE);
    total = add(total, normal);
    const old = v128.load(p, block.TANGENT_IMPULSE);
    const wanted = sub(old, v128.and(mul(v128.load(p, block.TANGENT_MASS), speed), lanes));
    const impulse = clamp(wanted, mul(v128.load(at, block.FRICTION), normal));
    v128.store(p, impulse, block.TANGENT_IMPULSE);
    addToTotal(p + block.TOTAL_TANGENT_IMPULSE, sub(impulse, v128.and(old, repeat)));
    const delta = sub(impulse, old);
    const px = mul(delta, ny);
    const py = mul(delta, nx);
    vxA = sub(vxA, mul(mxA, px));
    vyA = add(vyA, mul(myA, py));
    wA = sub(wA, mul(iA, mul(delta, leverA)));
    vxB = add(vxB, mul(mxB, px));
    vyB = sub(vyB, mul(myB, py));
    wB = add(wB, mul(iB, mul(delta, leverB)));
  }
  const old = v128.load(at, block.ROLLING_IMPULSE);
  const wanted = sub(old, v128.and(mul(v128.load(at, block.ROLLING_MASS), sub(wB, wA)), lanes));
  const impulse = clamp(wanted, mul(v128.load(at, block.ROLLING), total));
  v128.store(at, impulse, block.ROLLING_IMPULSE);
  const delta = sub(impulse, old);
  scatter(at + block.A, vxA, vyA, sub(wA, mul(iA, delta)), turnedA);
  scatter(at + block.B, vxB, vyB, add(wB, mul(iB, delta)), turnedB);
}

// Within plus and minus `limit`; what is not a number becomes the limit.
// @ts-ignore: decorator
@inline function clamp(value: v128, limit: v128): v128 {
  return larger(v128.neg<real>(limit), smaller(limit, value));
}

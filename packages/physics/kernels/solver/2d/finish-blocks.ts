// Computes what follows from the numbers with which a block of contacts was filled, for all of its contacts at once: levers,
// effective masses, the speeds at which points approach, and anchors.
import { add, div, mul, splat, sub } from '../../memory/lanes';
import * as block from './contact-block';
import { lanesX, lanesY, lanesZ } from './gather-lanes';
import { RigidTable } from './rigid-table';

export function finishBlocks(t: RigidTable): void {
  for (let i = 0; i < t.blockCount; i++) finishBlock(t, block.blockOf(t, i));
}

// @ts-ignore: decorator
@inline function finishBlock(t: RigidTable, at: usize): void {
  const turning = add(v128.load(at, block.INERTIA_A), v128.load(at, block.INERTIA_B));
  v128.store(at, reciprocal(turning), block.ROLLING_MASS);
  const a = at + block.A;
  const b = at + block.B;
  const vx = sub(lanesX(b, 0), lanesX(a, 0));
  const vy = sub(lanesY(b, 0), lanesY(a, 0));
  const wA = lanesZ(a, 0);
  const wB = lanesZ(b, 0);
  finishPoint(at, at + block.POINTS, vx, vy, wA, wB);
  finishPoint(at, at + block.POINTS + block.POINT, vx, vy, wA, wB);
  const speed = v128.load(at, block.POINTS + block.POINT + block.NORMAL_SPEED);
  if (v128.any_true(v128.lt<real>(speed, splat(-block.HIT_SPEED)))) t.hitCount++;
}

// Of b from a, the bodies have the velocity (vx, vy); they turn at wA and wB.
// @ts-ignore: decorator
@inline function finishPoint(at: usize, p: usize, vx: v128, vy: v128, wA: v128, wB: v128): void {
  const nx = v128.load(at, block.NX);
  const ny = v128.load(at, block.NY);
  const ax = v128.load(p, block.AX);
  const ay = v128.load(p, block.AY);
  const bx = v128.load(p, block.BX);
  const by = v128.load(p, block.BY);
  const normalA = sub(mul(ax, ny), mul(ay, nx));
  const normalB = sub(mul(bx, ny), mul(by, nx));
  // The tangent is the normal turned to the right: (ny, -nx).
  const tangentA = v128.neg<real>(add(mul(ax, nx), mul(ay, ny)));
  const tangentB = v128.neg<real>(add(mul(bx, nx), mul(by, ny)));
  v128.store(p, normalA, block.NORMAL_LEVER_A);
  v128.store(p, normalB, block.NORMAL_LEVER_B);
  v128.store(p, tangentA, block.TANGENT_LEVER_A);
  v128.store(p, tangentB, block.TANGENT_LEVER_B);
  const normal = withTurning(at, v128.load(p, block.NORMAL_MASS), normalA, normalB);
  v128.store(p, reciprocal(normal), block.NORMAL_MASS);
  v128.store(p, reciprocal(withTurning(at, v128.load(p, block.TANGENT_MASS), tangentA, tangentB)), block.TANGENT_MASS);
  const turning = sub(mul(wB, normalB), mul(wA, normalA));
  // A contact with one point has nothing at the second.
  const exists = v128.gt<real>(normal, splat(0));
  v128.store(p, v128.and(add(add(mul(nx, vx), mul(ny, vy)), turning), exists), block.NORMAL_SPEED);
  const roundingA = v128.load(at, block.ROUNDING_A);
  const roundingB = v128.load(at, block.ROUNDING_B);
  const anchorAX = sub(ax, mul(roundingA, nx));
  const anchorAY = sub(ay, mul(roundingA, ny));
  const anchorBX = add(bx, mul(roundingB, nx));
  const anchorBY = add(by, mul(roundingB, ny));
  v128.store(p, anchorAX, block.AX);
  v128.store(p, anchorAY, block.AY);
  v128.store(p, anchorBX, block.BX);
  v128.store(p, anchorBY, block.BY);
  const between = add(mul(nx, sub(anchorBX, anchorAX)), mul(ny, sub(anchorBY, anchorAY)));
  v128.store(p, sub(v128.load(p, block.SEPARATION), between), block.SEPARATION);
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

// Hinges that close loops, in blocks of LANES (color-loops.ts), by the formulas of solve-locks.ts in reals of the world.
import { add, div, larger, mul, smaller, splat, sub } from '../../memory/lanes';
import { MOVEMENT, lanesW, lanesX, lanesY, lanesZ, scatter } from '../../solver/2d/gather-lanes';
import { softness } from '../../solver/2d/softness';
import { MOST_ERROR } from './joint-rows';
import { JointTable } from './joint-table';
import * as block from './loop-block';
import { blockOf } from './loop-block';

// No impulse is larger, N s: what is not finite would reach every body of a net.
const MAX_IMPULSE: real = 1e30;

// Begins a sub-step: anchors and matrices where the bodies are now, and the impulses of the last sub-step.
export function startLoops(t: JointTable): void {
  const rate = splat(<real>softness.biasRate);
  for (let i = 0; i < t.blockCount; i++) {
    const at = blockOf(t, i);
    measureBlock(at, rate);
    factorBlock(at);
    solveBlock(at, splat(0), splat(0), WARM);
  }
}

// @ts-ignore: decorator
@inline function measureBlock(at: usize, rate: v128): void {
  const movedX = sub(lanesX(at + block.B, MOVEMENT), lanesX(at + block.A, MOVEMENT));
  const movedY = sub(lanesY(at + block.B, MOVEMENT), lanesY(at + block.A, MOVEMENT));
  let c = lanesZ(at + block.A, MOVEMENT);
  let s = lanesW(at + block.A, MOVEMENT);
  let x = v128.load(at, block.START_AX);
  let y = v128.load(at, block.START_AY);
  const ax = sub(mul(c, x), mul(s, y));
  const ay = add(mul(s, x), mul(c, y));
  c = lanesZ(at + block.B, MOVEMENT);
  s = lanesW(at + block.B, MOVEMENT);
  x = v128.load(at, block.START_BX);
  y = v128.load(at, block.START_BY);
  const bx = sub(mul(c, x), mul(s, y));
  const by = add(mul(s, x), mul(c, y));
  v128.store(at, ax, block.AX);
  v128.store(at, ay, block.AY);
  v128.store(at, bx, block.BX);
  v128.store(at, by, block.BY);
  const bendA = v128.load(at, block.BEND_A);
  const bendB = v128.load(at, block.BEND_B);
  const chordX = sub(mul(bendA, ax), mul(bendB, bx));
  const chordY = sub(mul(bendA, ay), mul(bendB, by));
  v128.store(at, chordX, block.CHORD_X);
  v128.store(at, chordY, block.CHORD_Y);
  const dx = bounded(add(v128.load(at, block.START_X), add(movedX, sub(bx, ax))));
  const dy = bounded(add(v128.load(at, block.START_Y), add(movedY, sub(by, ay))));
  v128.store(at, add(chordX, mul(rate, dx)), block.WANTED_X);
  v128.store(at, add(chordY, mul(rate, dy)), block.WANTED_Y);
}

// @ts-ignore: decorator
@inline function bounded(error: v128): v128 {
  return smaller(splat(<real>MOST_ERROR), larger(splat(<real>-MOST_ERROR), error));
}

// @ts-ignore: decorator
@inline function factorBlock(at: usize): void {
  const ax = v128.load(at, block.AX);
  const ay = v128.load(at, block.AY);
  const bx = v128.load(at, block.BX);
  const by = v128.load(at, block.BY);
  const iA = v128.load(at, block.INERTIA_A);
  const iB = v128.load(at, block.INERTIA_B);
  const massX = add(v128.load(at, block.MASS_AX), v128.load(at, block.MASS_BX));
  const massY = add(v128.load(at, block.MASS_AY), v128.load(at, block.MASS_BY));
  const xx = add(massX, add(mul(iA, mul(ay, ay)), mul(iB, mul(by, by))));
  const xy = add(mul(iA, mul(ax, ay)), mul(iB, mul(bx, by)));
  const yy = add(massY, add(mul(iA, mul(ax, ax)), mul(iB, mul(bx, bx))));
  const determinant = sub(mul(xx, yy), mul(xy, xy));
  // A lane without a hinge has no impulses.
  const k = v128.and(div(splat(1), determinant), v128.gt<real>(determinant, splat(0)));
  v128.store(at, mul(yy, k), block.K00);
  v128.store(at, mul(xy, k), block.K01);
  v128.store(at, mul(xx, k), block.K11);
}

// Softly, pulling together what is apart.
export function solveLoops(t: JointTable): void {
  const massScale = splat(<real>softness.massScale);
  const impulseScale = splat(<real>softness.impulseScale);
  for (let i = 0; i < t.blockCount; i++) solveBlock(blockOf(t, i), massScale, impulseScale, SOFT);
}

// Rigidly. Ends the sub-step.
export function relaxLoops(t: JointTable): void {
  const none = splat(0);
  for (let i = 0; i < t.blockCount; i++) {
    const at = blockOf(t, i);
    solveBlock(at, none, none, RIGID);
    const x = v128.load(at, block.IMPULSE_X);
    const y = v128.load(at, block.IMPULSE_Y);
    v128.store(at, larger(v128.load(at, block.LARGEST), add(mul(x, x), mul(y, y))), block.LARGEST);
  }
}

// What a pass does: applies impulses as they are, or changes them.
const WARM: i32 = 0;
const SOFT: i32 = 1;
const RIGID: i32 = 2;

function solveBlock(at: usize, massScale: v128, impulseScale: v128, pass: i32): void {
  const ax = v128.load(at, block.AX);
  const ay = v128.load(at, block.AY);
  const bx = v128.load(at, block.BX);
  const by = v128.load(at, block.BY);
  const vxA = lanesX(at + block.A, 0);
  const vyA = lanesY(at + block.A, 0);
  const wA = lanesZ(at + block.A, 0);
  const turnedA = lanesW(at + block.A, 0);
  const vxB = lanesX(at + block.B, 0);
  const vyB = lanesY(at + block.B, 0);
  const wB = lanesZ(at + block.B, 0);
  const turnedB = lanesW(at + block.B, 0);
  let x = v128.load(at, block.IMPULSE_X);
  let y = v128.load(at, block.IMPULSE_Y);
  if (pass != WARM) {
    const wantedX = pass == SOFT ? v128.load(at, block.WANTED_X) : v128.load(at, block.CHORD_X);
    const wantedY = pass == SOFT ? v128.load(at, block.WANTED_Y) : v128.load(at, block.CHORD_Y);
    const ux = add(wantedX, sub(sub(vxB, mul(wB, by)), sub(vxA, mul(wA, ay))));
    const uy = add(wantedY, sub(add(vyB, mul(wB, bx)), add(vyA, mul(wA, ax))));
    const k01 = v128.load(at, block.K01);
    let jx = add(mul(v128.load(at, block.K00), ux), mul(k01, uy));
    let jy = add(mul(k01, ux), mul(v128.load(at, block.K11), uy));
    if (pass == SOFT) {
      jx = add(mul(massScale, jx), mul(impulseScale, x));
      jy = add(mul(massScale, jy), mul(impulseScale, y));
    }
    const oldX = x;
    const oldY = y;
    x = finite(sub(x, jx));
    y = finite(sub(y, jy));
    v128.store(at, x, block.IMPULSE_X);
    v128.store(at, y, block.IMPULSE_Y);
    x = sub(x, oldX);
    y = sub(y, oldY);
  }
  const mxA = v128.load(at, block.MASS_AX);
  const myA = v128.load(at, block.MASS_AY);
  const mxB = v128.load(at, block.MASS_BX);
  const myB = v128.load(at, block.MASS_BY);
  const wOfA = sub(wA, mul(v128.load(at, block.INERTIA_A), sub(mul(ax, y), mul(ay, x))));
  const wOfB = add(wB, mul(v128.load(at, block.INERTIA_B), sub(mul(bx, y), mul(by, x))));
  if (pass == RIGID) {
    v128.store(at, bend(wOfA, v128.load(at, block.HALF_STEP_A)), block.BEND_A);
    v128.store(at, bend(wOfB, v128.load(at, block.HALF_STEP_B)), block.BEND_B);
  }
  scatter(at + block.A, sub(vxA, mul(mxA, x)), sub(vyA, mul(myA, y)), wOfA, turnedA);
  scatter(at + block.B, add(vxB, mul(mxB, x)), add(vyB, mul(myB, y)), wOfB, turnedB);
}

// As in chords.ts.
// @ts-ignore: decorator
@inline function bend(w: v128, halfStep: v128): v128 {
  const speed = v128.abs<real>(w);
  return mul(speed, smaller(mul(halfStep, speed), splat(0.5)));
}

// What is not finite, or nearly so, becomes 0.
// @ts-ignore: decorator
@inline function finite(impulse: v128): v128 {
  return v128.and(impulse, v128.lt<real>(v128.abs<real>(impulse), splat(MAX_IMPULSE)));
}

// Colors the hinges that close loops and do nothing else, so that hinges of one color have no body in common and LANES of
// them can be solved at once. Each takes the first color that neither of its bodies has, in the order of their ids. What
// finds no color is solved by itself.
import { get, put } from '../../memory/columns';
import { LANES, splat } from '../../memory/lanes';
import { BodyPose, LOOPED, flagsOf, poseOf, putFlags, putWord, stateOf, word } from '../../solver/2d/body';
import { UNLIKE } from '../../solver/2d/crowds';
import { inverseMassX, inverseMassY } from '../../solver/2d/motion-locks';
import { RigidTable } from '../../solver/2d/rigid-table';
import { JointedBody, jointed, keepVelocity, stiffen } from './brace-joints';
import { bend } from './chords';
import { JointTable, impulsesOf } from './joint-table';
import { CLOSING, LOOP, isInTree } from './joint-trees';
import { LOCKS, ROPE, isPlainHinge } from './list-active';
import * as block from './loop-block';
import { blockOf } from './loop-block';

// In t.parents, the color of a hinge, then its lane: these and more. Values up to 3 are of joint-trees.ts.
const FIRST: i32 = 4;
const COLORS: i32 = 32;

// Lists joints that are solved by themselves after the trees, and finds lanes for the others.
export function colorLoops(t: JointTable): void {
  memory.fill(t.colors, 0, (<usize>COLORS) << 2);
  for (let i = 0; i < t.activeCount; i++) {
    if (word(t.parents, i) != LOOP) continue;
    const color = isPlainHinge(word(t.roles, i)) ? chooseColor(t, i) : COLORS;
    if (color == COLORS) {
      putWord(t.order, t.orderCount++, i);
      continue;
    }
    putWord(t.parents, i, FIRST + color);
    putWord(t.colors, color, word(t.colors, color) + 1);
  }
  layOutColors(t);
  for (let i = 0; i < t.activeCount; i++) {
    const color = word(t.parents, i) - FIRST;
    if (color < 0) continue;
    const lane = word(t.colors, color);
    putWord(t.colors, color, lane + 1);
    putWord(t.parents, i, FIRST + lane);
  }
}

// Marks the bodies at the ends of joints that close loops (crowds.ts).
export function markLoops(t: JointTable, rigid: RigidTable): void {
  rigid.loopCount = 0;
  if (t.closedCount == t.activeCount || !haveUnlikeMasses(t, rigid)) return;
  for (let i = 0; i < t.activeCount; i++) {
    const parent = word(t.parents, i);
    if (isInTree(parent) || parent == CLOSING || (word(t.roles, i) & (LOCKS | ROPE)) == 0) continue;
    rigid.loopCount++;
    markEnd(rigid, word(t.nodes, 2 * i));
    markEnd(rigid, word(t.nodes, 2 * i + 1));
  }
}

// Whether any two bodies of all trees have masses that are unlike.
function haveUnlikeMasses(t: JointTable, rigid: RigidTable): bool {
  let least: real = Infinity;
  let most: real = 0;
  for (let i = 0; i < t.bodyCount; i++) {
    const inverseMass = poseOf(rigid, word(t.bodyRows, i)).inverseMass;
    if (inverseMass > 0) least = min<real>(least, inverseMass);
    most = max<real>(most, inverseMass);
  }
  return most > <real>UNLIKE * least;
}

// @ts-ignore: decorator
@inline function markEnd(rigid: RigidTable, row: i32): void {
  if (row != 0) putFlags(rigid, row, flagsOf(rigid, row) | LOOPED);
}

// A hinge that closes a loop has two bodies that move.
function chooseColor(t: JointTable, i: i32): i32 {
  const a = word(t.nodes, 2 * i);
  const b = word(t.nodes, 2 * i + 1);
  const usedA = <u32>word(t.marks, a);
  const usedB = <u32>word(t.marks, b);
  const open = ~(usedA | usedB);
  if (open == 0) return COLORS;
  const bit = open & (0 - open);
  putWord(t.marks, a, usedA | bit);
  putWord(t.marks, b, usedB | bit);
  return ctz<u32>(bit);
}

// The first lane of each color.
function layOutColors(t: JointTable): void {
  let lane = 0;
  for (let color = 0; color < COLORS; color++) {
    const size = word(t.colors, color);
    putWord(t.colors, color, lane);
    lane += (size + LANES - 1) & -LANES;
  }
  t.blockCount = lane / LANES;
}

// Lanes without a hinge act on row 0 without mass.
export function layOutLoops(t: JointTable, rigid: RigidTable): void {
  memory.fill(t.blocks, 0, <usize>t.blockCount * block.LOOP_BLOCK);
  const none = i32x4.splat(<i32>rigid.states);
  for (let i = 0; i < t.blockCount; i++) {
    const at = blockOf(t, i);
    v128.store(at, none, block.A);
    v128.store(at, none, block.B);
    v128.store(at, i32x4.splat(-1), block.JOINT);
  }
  for (let i = 0; i < t.activeCount; i++) {
    const lane = word(t.parents, i) - FIRST;
    if (lane < 0) continue;
    const at = blockOf(t, lane / LANES);
    const l = lane & (LANES - 1);
    const id = word(t.active, i);
    putWord(at + block.JOINT, l, id);
    putWord(at + block.ROW_A, l, word(t.a, id));
    putWord(at + block.ROW_B, l, word(t.b, id));
    putWord(at + block.A, l, <i32>changetype<usize>(stateOf(rigid, word(t.a, id))));
    putWord(at + block.B, l, <i32>changetype<usize>(stateOf(rigid, word(t.b, id))));
    put(at + block.IMPULSE_X, l, <real>impulsesOf(t, id).lock0);
    put(at + block.IMPULSE_Y, l, <real>impulsesOf(t, id).lock1);
  }
}

// Begins a step: masses and anchors.
export function beginLoops(t: JointTable, rigid: RigidTable): void {
  for (let i = 0; i < t.blockCount; i++) {
    const at = blockOf(t, i);
    v128.store(at, splat(0), block.LARGEST);
    for (let l = 0; l < LANES; l++) if (word(at + block.JOINT, l) >= 0) fillLane(t, rigid, at, l);
  }
}

// @ts-ignore: decorator
@inline function fillLane(t: JointTable, rigid: RigidTable, at: usize, l: i32): void {
  const id = word(at + block.JOINT, l);
  const rowA = word(at + block.ROW_A, l);
  const rowB = word(at + block.ROW_B, l);
  const a = poseOf(rigid, rowA);
  const b = poseOf(rigid, rowB);
  put(at + block.MASS_AX, l, inverseMassX(rigid, rowA));
  put(at + block.MASS_AY, l, inverseMassY(rigid, rowA));
  put(at + block.MASS_BX, l, inverseMassX(rigid, rowB));
  put(at + block.MASS_BY, l, inverseMassY(rigid, rowB));
  put(at + block.START_X, l, b.x - a.x);
  put(at + block.START_Y, l, b.y - a.y);
  keepVelocity(t, rigid, rowA);
  keepVelocity(t, rigid, rowB);
  const x = <f64>get(at + block.IMPULSE_X, l);
  const y = <f64>get(at + block.IMPULSE_Y, l);
  fillAnchor(t, a, at + block.START_AX, l, rowA, get(t.ax, id), get(t.ay, id), -x, -y);
  fillAnchor(t, b, at + block.START_BX, l, rowB, get(t.bx, id), get(t.by, id), x, y);
}

// @ts-ignore: decorator
@inline function fillAnchor(
  t: JointTable,
  pose: BodyPose,
  at: usize,
  l: i32,
  row: i32,
  localX: real,
  localY: real,
  impulseX: f64,
  impulseY: f64,
): void {
  const x = pose.c * localX - pose.s * localY;
  const y = pose.s * localX + pose.c * localY;
  put(at, l, x);
  put(at + block.START_AY - block.START_AX, l, y);
  stiffen(t, row, impulseX, impulseY, <f64>x, <f64>y);
}

// @ts-ignore: decorator
@inline function braceBody(
  at: usize,
  l: i32,
  inertia: usize,
  halfStep: usize,
  bends: usize,
  body: JointedBody,
): void {
  put(at + inertia, l, <real>body.inverseInertia);
  put(at + halfStep, l, <real>body.halfStep);
  put(at + bends, l, <real>bend(body.w, body.halfStep));
}

// The inertias that they see in this step (brace-joints.ts).
export function braceLoops(t: JointTable): void {
  for (let i = 0; i < t.blockCount; i++) {
    const at = blockOf(t, i);
    for (let l = 0; l < LANES; l++) {
      if (word(at + block.JOINT, l) < 0) continue;
      braceBody(at, l, block.INERTIA_A, block.HALF_STEP_A, block.BEND_A, jointed(t, word(at + block.ROW_A, l)));
      braceBody(at, l, block.INERTIA_B, block.HALF_STEP_B, block.BEND_B, jointed(t, word(at + block.ROW_B, l)));
    }
  }
}

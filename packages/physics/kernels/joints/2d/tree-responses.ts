// What an impulse on one body of a tree does to all of it, in an impact. A projection P (project-trees.ts) is affine in the velocities:
//
//   P(v + d) = P(v) + D d
//
// The columns of D of a body are measured when something strikes it first. A heap of ragdolls that lands takes thirty impulses a contact: to
// add D d for each takes a fifth of the time of a projection of both trees. A mechanism of several trees, and what there is no room for,
// is projected.
import { BodyState, putWord, stateOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { ArticulatedBody, articulated, pushBody } from './articulated-body';
import { jointed } from './brace-joints';
import { listRows, respondClosed } from './close-loops';
import { finite } from './joint-rows';
import { JointTable } from './joint-table';
import { treeBody } from './joint-trees';
import { placeAt } from './joint-work';
import { bodyOfTree, jointsOfTree } from './list-by-tree';
import { mechanismAt, mechanismOf } from './mechanisms';
import { projectTree } from './project-trees';
import { respond } from './sweep-tree';

// Numbers of a column by body of the tree: how its x, y and angle follow x, then y, then the angle of the body that is struck.
const NUMBERS: i32 = 9;

// In t.responseOf, beside twice one more than where the columns of a body begin: whether they hold.
const HOLDS: i32 = 1;

// Forgets all columns.
export function forgetResponses(t: JointTable): void {
  for (let i = 0; i < t.bodyCount; i++) putWord(t.responseOf, word(t.bodyRows, i), 0);
  for (let tree = 0; tree < t.rootCount; tree++) putWord(t.responsesIn, tree, 0);
  t.responseCount = 0;
}

// The columns of a tree do not hold any more.
export function endResponses(t: JointTable, tree: i32): void {
  for (let i = jointsOfTree(t, tree); i >= 0; i--) {
    const row = bodyOfTree(t, tree, i);
    putWord(t.responseOf, row, word(t.responseOf, row) & ~HOLDS);
  }
}

// The address of the columns of a body, 0 for none. Where it measures them it projects the tree.
export function responseOf(t: JointTable, rigid: RigidTable, tree: i32, row: i32): usize {
  let place = word(t.responseOf, row);
  if ((place & HOLDS) == 0) {
    if (place == 0) place = makeRoom(t, tree);
    if (place == 0) return 0;
    measure(t, rigid, tree, row, columnAt(t, place));
    putWord(t.responseOf, row, place | HOLDS);
  }
  return columnAt(t, place);
}

// @ts-ignore: decorator
@inline function columnAt(t: JointTable, place: i32): usize {
  return t.responses + <usize>((place >> 1) - 1) * sizeof<real>();
}

// Each tree has room for itself, so that what it does depends on no other, and not on the capacity of the world.
function makeRoom(t: JointTable, tree: i32): i32 {
  const joints = jointsOfTree(t, tree);
  const used = word(t.responsesIn, tree);
  const numbers = NUMBERS * (joints + 1);
  if (used + numbers > t.responseRoom * joints) return 0;
  const mechanism = mechanismOf(t, tree);
  if (mechanism >= 0 && mechanismAt(t, mechanism).trees > 1) return 0;
  putWord(t.responsesIn, tree, used + numbers);
  t.responseCount += numbers;
  return (t.responseRoom * word(t.treeStarts, tree) + used + 1) << 1;
}

// The projection at the end leaves the velocities of the tree where trees keep them.
function measure(t: JointTable, rigid: RigidTable, tree: i32, row: i32, to: usize): void {
  const at = treeBody(t, row);
  const body = changetype<ArticulatedBody>(at);
  const number = mechanismOf(t, tree);
  if (number >= 0) listRows(t, rigid, mechanismAt(t, number), 0);
  for (let axis = 0; axis < 3; axis++) {
    const x = axis == 0 ? body.mass : 0;
    const y = axis == 1 ? body.mass : 0;
    const turn = axis == 2 ? body.inertia : 0;
    if (number < 0) {
      pushBody(at, x, y, turn);
      respond(t, tree);
    } else respondClosed(t, mechanismAt(t, number), at, x, y, turn);
    const first = word(t.treeStarts, tree);
    keep(articulated(t, tree), jointed(t, word(t.roots, tree)).inverseInertia > 0, to, axis);
    for (let i = 0; i < jointsOfTree(t, tree); i++) {
      const place = placeAt(t, word(t.treeJoints, first + i));
      const numbers = to + <usize>(NUMBERS * (i + 1)) * sizeof<real>();
      if (place.below != 0) keep(changetype<ArticulatedBody>(place.below), place.turns != 0, numbers, axis);
    }
  }
  projectTree(t, rigid, tree);
}

function keep(body: ArticulatedBody, turns: bool, numbers: usize, axis: i32): void {
  const to = numbers + <usize>(3 * axis) * sizeof<real>();
  store<real>(to, <real>finite(body.vx));
  store<real>(to, <real>finite(body.vy), sizeof<real>());
  store<real>(to, turns ? <real>finite(body.w) : <real>0, 2 * sizeof<real>());
}

// Adds what a change of the velocity of a body does to all of its tree, that body among them.
export function addResponse(
  t: JointTable,
  rigid: RigidTable,
  tree: i32,
  columns: usize,
  dx: real,
  dy: real,
  dw: real,
): void {
  let numbers = columns;
  for (let i = 0; i <= jointsOfTree(t, tree); i++) {
    const row = bodyOfTree(t, tree, i);
    if (row != 0) addTo(stateOf(rigid, row), numbers, dx, dy, dw);
    numbers += <usize>NUMBERS * sizeof<real>();
  }
}

// @ts-ignore: decorator
@inline function addTo(state: BodyState, numbers: usize, dx: real, dy: real, dw: real): void {
  state.vx += number(numbers, 0) * dx + number(numbers, 3) * dy + number(numbers, 6) * dw;
  state.vy += number(numbers, 1) * dx + number(numbers, 4) * dy + number(numbers, 7) * dw;
  state.w += number(numbers, 2) * dx + number(numbers, 5) * dy + number(numbers, 8) * dw;
}

// @ts-ignore: decorator
@inline function number(numbers: usize, i: usize): real {
  return load<real>(numbers + i * sizeof<real>());
}

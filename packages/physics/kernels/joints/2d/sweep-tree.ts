// A tree of joints, from its ends to its root and back, by itself.
import { stateOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { addOwnMass, articulated, freeVelocity, invert, massOf } from './articulated-body';
import { jointed } from './brace-joints';
import { follow, gatherHinge, gatherHingeResponse, passHinge, passHingeResponse } from './hinge-locks';
import { JointTable } from './joint-table';
import { placeAt, startAt, workAt } from './joint-work';
import { jointsOfTree } from './list-by-tree';
import { pushAxes } from './push-axes';
import { gatherJoint, gatherResponse, passJoint, pullChild } from './row-locks';

// From the ends: what the root bears. With `factor`, also the matrices.
export function gatherTree(t: JointTable, rigid: RigidTable, tree: i32, bias: f64, soft: bool, factor: bool): void {
  const first = word(t.treeStarts, tree);
  for (let i = jointsOfTree(t, tree) - 1; i >= 0; i--) pushAxes(t, word(t.treeJoints, first + i));
  for (let i = jointsOfTree(t, tree) - 1; i >= 0; i--) {
    const k = word(t.treeJoints, first + i);
    const at = placeAt(t, k);
    if (at.hinge != 0) gatherHinge(t, rigid, at, startAt(t, k), soft, factor);
    else gatherJoint(t, rigid, k, bias, factor);
  }
  if (factor) factorRoot(t, tree);
}

// From the root: the velocities of all bodies. Joints exert what they must, and none of it is kept.
export function passTree(t: JointTable, rigid: RigidTable, tree: i32, soft: bool): void {
  const first = word(t.treeStarts, tree);
  const count = jointsOfTree(t, tree);
  moveRoot(t, rigid, tree);
  for (let i = 0; i < count; i++) {
    const k = word(t.treeJoints, first + i);
    const at = placeAt(t, k);
    if (at.hinge != 0) passHinge(rigid, at, startAt(t, k), soft);
    else passJoint(t, rigid, k);
  }
}

// What a tree does that is at rest and wants to stay so, under the impulses on its bodies: the velocities of these.
export function respond(t: JointTable, tree: i32): void {
  const first = word(t.treeStarts, tree);
  const count = jointsOfTree(t, tree);
  for (let i = count - 1; i >= 0; i--) {
    const k = word(t.treeJoints, first + i);
    const at = placeAt(t, k);
    if (at.hinge != 0) gatherHingeResponse(at);
    else gatherResponse(t, at, workAt(t, k));
  }
  freeVelocity(articulated(t, tree), massOf(t, tree), 0, 0, 0);
  for (let i = 0; i < count; i++) {
    const k = word(t.treeJoints, first + i);
    const at = placeAt(t, k);
    if (at.hinge != 0) passHingeResponse(at);
    else pullChild(t, at, workAt(t, k));
  }
}

// The matrices of all roots, with all that hangs below them.
export function factorRoots(t: JointTable): void {
  for (let k = 0; k < t.rootCount; k++) factorRoot(t, k);
}

function factorRoot(t: JointTable, k: i32): void {
  const mass = massOf(t, k);
  addOwnMass(mass, articulated(t, k));
  invert(changetype<usize>(mass));
}

export function moveRoot(t: JointTable, rigid: RigidTable, k: i32): void {
  const root = articulated(t, k);
  const row = word(t.roots, k);
  const state = stateOf(rigid, row);
  freeVelocity(root, massOf(t, k), <f64>state.vx, <f64>state.vy, <f64>state.w);
  follow(state, root, jointed(t, row).inverseInertia > 0);
}

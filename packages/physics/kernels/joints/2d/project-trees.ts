// What an impact at a body does to all that joints hold to it: the velocities of its tree are projected to the nearest ones, in
// energy, that its joints allow (solve-locks.ts). An impact is no load of a joint: what it exerts is not kept.
import { putWord, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { releaseRods, startRods } from './brace-rods';
import { closeLoops } from './close-loops';
import { hasTreeLimits } from './engage-limits';
import { measureHinge } from './hinge-locks';
import { JointTable } from './joint-table';
import { PLAIN, placeAt, startAt, workAt } from './joint-work';
import { measureJoint } from './measure-joints';
import { Mechanism, mechanismAt, mechanismOf, treeOfMechanism } from './mechanisms';
import { softenJoint } from './soft-impulse';
import { solveAll } from './solve-locks';
import { clearMasses, clearTree } from './start-joints';
import { gatherTree, passTree } from './sweep-tree';

// Projects all trees, after the last sub-step. Matrices are made again, for joints that are rigid and without the limits that have
// let go: between a light body and a heavy one the least softness leaves much for later projections, and impacts would diverge.
export function startProjections(t: JointTable, rigid: RigidTable): void {
  const factor = t.otherCount > 0;
  for (let k = 0; factor && k < t.closedCount; k++) if (hasTreeLimits(t, workAt(t, k))) measureJoint(t, k);
  if (factor) releaseRods(t);
  if (factor) clearMasses(t, rigid);
  softness.massScale = 1;
  softness.impulseScale = 0;
  softness.compliance = 0;
  solveAll(t, rigid, 0, false, factor);
}

// The same before the first sub-step: joints are measured where bodies are, and what they exert is not noted.
export function foreseeProjections(t: JointTable, rigid: RigidTable): void {
  softenJoint(rigid);
  startRods(t);
  for (let k = 0; k < t.workCount; k++) {
    if (placeAt(t, k).hinge == PLAIN) measureHinge(t, rigid, placeAt(t, k), startAt(t, k));
    else measureJoint(t, k);
  }
  if (t.otherCount > 0) releaseRods(t);
  clearMasses(t, rigid);
  softness.impulseScale = 0;
  softness.compliance = 0;
  // Bodies keep their velocities while the matrices are made.
  softness.massScale = 0;
  startRound(t);
  for (let tree = 0; tree < t.rootCount; tree++) projectOnce(t, rigid, tree, true);
  softness.massScale = 1;
}

// Makes the matrices of a tree, or of the mechanism that it is part of, again, and projects it.
export function projectAgain(t: JointTable, rigid: RigidTable, tree: i32): void {
  const number = mechanismOf(t, tree);
  if (number < 0) clearTree(t, rigid, tree);
  else {
    const mechanism = mechanismAt(t, number);
    for (let i = 0; i < mechanism.trees; i++) clearTree(t, rigid, treeOfMechanism(t, mechanism, i));
  }
  project(t, rigid, tree, true);
}

// Projects one tree, or the mechanism that it is part of, with the matrices that there are.
export function projectTree(t: JointTable, rigid: RigidTable, tree: i32): void {
  project(t, rigid, tree, false);
}

function project(t: JointTable, rigid: RigidTable, tree: i32, factor: bool): void {
  const number = mechanismOf(t, tree);
  if (number >= 0) return projectMechanism(t, rigid, mechanismAt(t, number), factor);
  gatherTree(t, rigid, tree, 0, false, factor);
  passTree(t, rigid, tree, false);
}

function projectMechanism(t: JointTable, rigid: RigidTable, mechanism: Mechanism, factor: bool): void {
  for (let i = 0; i < mechanism.trees; i++) gatherTree(t, rigid, treeOfMechanism(t, mechanism, i), 0, false, factor);
  closeLoops(t, rigid, mechanism, 0, false, factor);
  for (let i = 0; i < mechanism.trees; i++) {
    const tree = treeOfMechanism(t, mechanism, i);
    passTree(t, rigid, tree, false);
    putWord(t.projected, tree, t.projections);
  }
}

// Begins a round of projections, in which `projectTreeOnce` projects each tree at most once.
export function startRound(t: JointTable): void {
  t.projections++;
}

export function projectTreeOnce(t: JointTable, rigid: RigidTable, tree: i32): void {
  projectOnce(t, rigid, tree, false);
}

function projectOnce(t: JointTable, rigid: RigidTable, tree: i32, factor: bool): void {
  if (word(t.projected, tree) == t.projections) return;
  project(t, rigid, tree, factor);
  putWord(t.projected, tree, t.projections);
}

// What an impact at a body does to all that joints hold to it: the velocities of its tree are projected to the nearest ones, in
// energy, that its joints allow (solve-locks.ts). An impact is no load of a joint: what it exerts is not kept.
import { putWord, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { releaseRods } from './brace-rods';
import { closeLoops } from './close-loops';
import { JointTable } from './joint-table';
import { Mechanism, mechanismAt, mechanismOf, treeOfMechanism } from './mechanisms';
import { solveAll } from './solve-locks';
import { clearMasses } from './start-joints';
import { gatherTree, passTree } from './sweep-tree';

// Projects all trees, after the last sub-step. Matrices are made again, for joints that are rigid and without the limits that have
// let go: between a light body and a heavy one the least softness leaves much for later projections, and impacts would diverge.
export function startProjections(t: JointTable, rigid: RigidTable): void {
  const factor = t.otherCount > 0;
  if (factor) releaseRods(t);
  if (factor) clearMasses(t, rigid);
  softness.massScale = 1;
  softness.impulseScale = 0;
  softness.compliance = 0;
  solveAll(t, rigid, 0, false, factor);
}

// Projects one tree, or the mechanism that it is part of, with the matrices that there are.
export function projectTree(t: JointTable, rigid: RigidTable, tree: i32): void {
  const number = t.mechanismCount > 0 ? mechanismOf(t, tree) : -1;
  if (number >= 0) return projectMechanism(t, rigid, mechanismAt(t, number));
  gatherTree(t, rigid, tree, 0, false);
  passTree(t, rigid, tree, false);
}

function projectMechanism(t: JointTable, rigid: RigidTable, mechanism: Mechanism): void {
  for (let i = 0; i < mechanism.trees; i++) gatherTree(t, rigid, treeOfMechanism(t, mechanism, i), 0, false);
  closeLoops(t, rigid, mechanism, 0, false, false);
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
  if (word(t.projected, tree) == t.projections) return;
  projectTree(t, rigid, tree);
  putWord(t.projected, tree, t.projections);
}

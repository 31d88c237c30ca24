// Two contacts of one body with what does not move, as at a vertex of a chain, whose normals hardly differ. Stopped one after
// the other they would take as many passes as
//
//   1 / (1 - c²)        c: cosine of the angle between the normals
//
// and what is thrown back before that has impulses at points that part already: energy that is gained. They are stopped at once.
import { get, put } from '../../memory/columns';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { Impact, impactAt, pointOf } from './impact';

// Pairs the impacts in t.struck. The fastest approach by row is no longer needed then, and its list is used for the indices.
export function pairStruck(t: RigidTable): void {
  for (let i = 0; i < t.struckCount; i++) put(t.fastest, moverOf(impactAt(t, word(t.struck, i))), 0);
  for (let i = 0; i < t.struckCount; i++) {
    const index = word(t.struck, i);
    const impact = impactAt(t, index);
    const mover = moverOf(impact);
    if (mover == 0) continue;
    const first = <i32>get(t.fastest, mover) - 1;
    if (first < 0 || impactAt(t, first).partner != 0) {
      put(t.fastest, mover, <real>(index + 1));
      continue;
    }
    impact.partner = first + 1;
    impactAt(t, first).partner = index + 1;
  }
}

// The row of the body of an impact with one point, if only one of the two is pushed, and no joint holds it; otherwise 0.
// @ts-ignore: decorator
@inline function moverOf(impact: Impact): i32 {
  if (impact.count != 1 || impact.treeA >= 0 || impact.treeB >= 0) return 0;
  if (impact.rowA == 0) return impact.rowB;
  return impact.rowB == 0 ? impact.rowA : 0;
}

// The speed that an impulse of 1 N s at the point of one of a pair gives that of the other, along its normal, 1/kg.
export function couplingBetween(impact: Impact, other: Impact): real {
  const isB = impact.rowA == 0;
  const isOtherB = other.rowA == 0;
  const leverP = isB ? pointOf(impact, 0).leverB : pointOf(impact, 0).leverA;
  const leverQ = isOtherB ? pointOf(other, 0).leverB : pointOf(other, 0).leverA;
  const x = (isB ? impact.massBx : impact.massAx) * impact.nx * other.nx;
  const y = (isB ? impact.massBy : impact.massAy) * impact.ny * other.ny;
  const turn = (isB ? impact.inertiaB : impact.inertiaA) * leverP * leverQ;
  return isB == isOtherB ? x + y + turn : -(x + y + turn);
}

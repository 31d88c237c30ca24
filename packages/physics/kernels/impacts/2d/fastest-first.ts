// Many impacts at bodies that joints hold. To pass an impulse on takes as long as its tree is large, so that passes over all of them are
// dear, and where a long beam falls flat, hundreds of contacts share few directions in which it moves: it takes some dozen passes. So the
// impact that is furthest from being stopped is, and again: of the same beam only a few have to bear.
// Source: Southwell, Relaxation Methods in Engineering Science (1940), chapter 2.
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { Impact, excessAt, impactAt, pointOf } from './impact';
import { passImpulse, startImpulse } from './impact-trees';
import { stop } from './stop-impact';

// Fewer are stopped in passes, which share the impulses more evenly.
const MANY: i32 = 32;

// Whether many are struck, and all of them at trees.
export function areManyOfTrees(t: RigidTable): bool {
  if (t.struckCount < MANY) return false;
  for (let i = 0; i < t.struckCount; i++) {
    const impact = impactAt(t, word(t.struck, i));
    if (impact.treeA < 0 && impact.treeB < 0) return false;
  }
  return true;
}

// Stops all that are struck, with as many impulses as `passes` would take, until none lacks more than `solved`, m/s.
export function solveFastestFirst(t: RigidTable, passes: i32, solved: real): void {
  t.pass += passes;
  for (let most = passes * t.struckCount; most > 0; most--) {
    const index = furthest(t, solved);
    if (index < 0) break;
    const impact = impactAt(t, index);
    startImpulse(t, impact);
    if (stop(t, impact) > 0) passImpulse(t, impact);
  }
}

// The index of the impact that lacks most, -1 if none lacks more than `solved`.
function furthest(t: RigidTable, solved: real): i32 {
  let most = solved;
  let index = -1;
  for (let i = 0; i < t.struckCount; i++) {
    const lack = lackOf(impactAt(t, word(t.struck, i)));
    if (!(lack > most)) continue;
    most = lack;
    index = word(t.struck, i);
  }
  return index;
}

// By how much the speed of a point is to change, m/s: what approaches is stopped, and what parts lets go of its impulse.
function lackOf(impact: Impact): real {
  if (impact.held != 0) return 0;
  let most: real = 0;
  for (let i = 0; i < impact.count; i++) {
    const point = pointOf(impact, i);
    const excess = excessAt(impact, point);
    most = max<real>(most, excess > 0 ? excess : min<real>(-excess, point.impulse / point.mass));
  }
  return most;
}

// Impacts in rounds: of all contacts that approach, those that are about as fast as the fastest of their bodies are stopped
// together, and then thrown back with e times the impulses that this took. So a row of balls passes a velocity on from one to
// the next, and what is symmetric stays so. A round loses no momentum, and gains no energy. What remains slower than
// the threshold of restitution is stopped at last.
// Source: Smith et al., Reflections on Simultaneous Impact (SIGGRAPH 2012), section 4.
import { get, put } from '../../memory/columns';
import { putWord, word } from '../../solver/2d/body';
import { isTouching, willMeet } from '../../solver/2d/contact-place';
import { RigidTable } from '../../solver/2d/rigid-table';
import { firstEdge, nextEdge, visit } from './contact-edges';
import { Impact, applyTangentImpulse, impactAt, pointOf, applyNormalImpulse, tangentSpeedAt, excessAt } from './impact';
import { areManyOfTrees, solveFastestFirst } from './fastest-first';
import { addImpact } from './impact-list';
import {
  hasLocks,
  lockJoints,
  memberOf,
  othersIn,
  passImpulse,
  projectImpacts,
  projectStruck,
  releaseLimits,
  startImpulse,
  weighTrees,
} from './impact-trees';
import { pairStruck } from './paired-impacts';
import { stop } from './stop-impact';

// Contacts that approach faster than this part of the fastest of the same bodies are thrown back with it.
const AS_FAST: real = 0.9;
// Rounds in a step: what still approaches after the last goes on in the next step.
const MAX_ROUNDS: i32 = 40;
// Passes over the contacts of a round, which end when no speed changes by more than this part of the threshold.
const MAX_PASSES: i32 = 50;
const SOLVED: real = 1e-3;
// The same for what does not bounce.
const LAST_PASSES: i32 = 8;
const LAST_SOLVED: real = 0.02;
// Passes of a round with friction, if more than one contact is struck: in heaps the normals alone are solved after them.
const COUPLED_PASSES: i32 = 4;
// Passes of friction over what was struck.
const FRICTION_PASSES: i32 = 2;

// Lets what approaches in the list of impacts faster than `slowest` bounce; and what closes because that moves.
export function bounceInRounds(t: RigidTable, slowest: real): void {
  t.approachingCount = 0;
  t.pass = 0;
  for (let i = 0; i < t.impactCount; i++) addApproaching(t, i);
  for (let round = 1; round <= MAX_ROUNDS; round++) {
    findFastest(t, slowest);
    if (t.approachingCount == 0) break;
    chooseStruck(t);
    solveStruck(t, MAX_PASSES, (t.isLanding != 0 ? LAST_SOLVED : SOLVED) * slowest);
    // What lands is not thrown back, and its trees have followed each impulse.
    if (t.isLanding == 0) {
      for (let most = MAX_ROUNDS; most > 0 && hasLocks && letGo(t); most--)
        solveStruck(t, MAX_PASSES, SOLVED * slowest);
      for (let i = 0; i < t.struckCount; i++) throwBack(impactAt(t, word(t.struck, i)));
      projectStruck(t);
    }
    for (let i = 0; i < t.struckCount; i++) {
      const impact = impactAt(t, word(t.struck, i));
      reachGroup(t, impact.rowA, impact.treeA, impact.groupA, round, slowest);
      reachGroup(t, impact.rowB, impact.treeB, impact.groupB, round, slowest);
    }
  }
  for (let pass = 0; pass < FRICTION_PASSES; pass++) {
    for (let i = 0; i < t.impactCount; i++) applyFriction(impactAt(t, i));
    projectImpacts(t);
  }
  stopTheRest(t, slowest);
}

// @ts-ignore: decorator
@inline function addApproaching(t: RigidTable, i: i32): void {
  impactAt(t, i).listed = 1;
  putWord(t.approaching, t.approachingCount++, i);
}

// Keeps those that approach faster than `slowest` in the list, and finds the fastest approach of each body.
function findFastest(t: RigidTable, slowest: real): void {
  let count = 0;
  for (let i = 0; i < t.approachingCount; i++) {
    const index = word(t.approaching, i);
    const impact = impactAt(t, index);
    put(t.fastest, impact.groupA, 0);
    put(t.fastest, impact.groupB, 0);
    impact.approach = approachOf(impact);
    if (impact.approach > slowest) putWord(t.approaching, count++, index);
    else impact.listed = 0;
  }
  t.approachingCount = count;
  for (let i = 0; i < count; i++) {
    const impact = impactAt(t, word(t.approaching, i));
    if (impact.approach > get(t.fastest, impact.groupA)) put(t.fastest, impact.groupA, impact.approach);
    if (impact.approach > get(t.fastest, impact.groupB)) put(t.fastest, impact.groupB, impact.approach);
  }
  // What contacts do not push has no fastest approach.
  put(t.fastest, 0, 0);
}

// The speed at which the points of a contact approach, at least 0, m/s.
function approachOf(impact: Impact): real {
  let fastest: real = 0;
  if (impact.held != 0) return 0;
  for (let i = 0; i < impact.count; i++) {
    const approach = excessAt(impact, pointOf(impact, i));
    if (approach > fastest) fastest = approach;
  }
  return fastest;
}

// Lists the contacts that approach about as fast as any of their bodies does.
function chooseStruck(t: RigidTable): void {
  t.struckCount = 0;
  for (let i = 0; i < t.approachingCount; i++) {
    const index = word(t.approaching, i);
    const impact = impactAt(t, index);
    const fastest = max<real>(get(t.fastest, impact.groupA), get(t.fastest, impact.groupB));
    if (impact.approach >= AS_FAST * fastest) strike(t, index);
  }
}

function strike(t: RigidTable, index: i32): void {
  const impact = impactAt(t, index);
  if (impact.isWeighed == 0) impact.held = weighTrees(t, impact) ? 0 : 1;
  for (let i = 0; i < impact.count; i++) {
    const point = pointOf(impact, i);
    point.impulse = 0;
    point.tangentBefore = point.tangentImpulse;
  }
  impact.partner = 0;
  putWord(t.struck, t.struckCount++, index);
}

// Stops all that are struck, and those again whose bodies others have changed.
function solveStruck(t: RigidTable, passes: i32, solved: real): void {
  if (t.struckCount > 1) pairStruck(t);
  if (areManyOfTrees(t)) return solveFastestFirst(t, passes, solved);
  const first = ++t.pass;
  for (let last = first + passes; t.pass < last; t.pass++) {
    let change: real = 0;
    for (let i = 0; i < t.struckCount; i++) {
      const impact = impactAt(t, word(t.struck, i));
      const pushed = max<i32>(word(t.pushes, impact.groupA), word(t.pushes, impact.groupB));
      if (t.pass > first && pushed < t.pass - 1) continue;
      startImpulse(t, impact);
      const changed = stop(t, impact);
      if ((t.struckCount == 1 || t.pass < first + COUPLED_PASSES) && couplesFriction(impact)) applyFriction(impact);
      if (changed > 0) passImpulse(t, impact);
      if (changed <= solved) continue;
      change = max<real>(change, changed);
      putWord(t.pushes, impact.groupA, t.pass);
      putWord(t.pushes, impact.groupB, t.pass);
    }
    putWord(t.pushes, 0, 0);
    if (change <= solved) break;
  }
}

// Whether friction acts together with the impulses along the normal, so that what is stopped and thrown back is the speed that is
// left of both: Newton's law then holds with friction. Impulses of friction are thrown back with the others, as Poisson has it, and
// so no energy is gained: Wang and Mason, Two-Dimensional Rigid-Body Collisions With Friction (J. Appl. Mech. 59, 1992). For what
// joints hold, or locks, friction follows the bounce, because the projections between would feed it.
// @ts-ignore: decorator
@inline function couplesFriction(impact: Impact): bool {
  if (impact.friction == 0 || impact.treeA >= 0 || impact.treeB >= 0) return false;
  return isFree(impact.massAx, impact.massAy, impact.inertiaA) && isFree(impact.massBx, impact.massBy, impact.inertiaB);
}

// @ts-ignore: decorator
@inline function isFree(massX: real, massY: real, inertia: real): bool {
  return massX == massY && (massX > 0 || inertia == 0);
}

// Lets limits go that had to pull when what is struck was stopped, and takes that back then. Returns whether there are any.
function letGo(t: RigidTable): bool {
  exertAgain(t, -1);
  let any = false;
  for (let i = 0; i < t.struckCount; i++) if (releaseLimits(t, impactAt(t, word(t.struck, i)))) any = true;
  if (!any) exertAgain(t, 1);
  for (let i = 0; any && i < t.struckCount; i++) resetRound(t, impactAt(t, word(t.struck, i)));
  return any;
}

// Applies the impulses of this round again, or takes them back.
function exertAgain(t: RigidTable, sign: real): void {
  for (let i = 0; i < t.struckCount; i++) {
    const impact = impactAt(t, word(t.struck, i));
    for (let k = 0; k < impact.count; k++) {
      const point = pointOf(impact, k);
      applyNormalImpulse(impact, point, sign * point.impulse);
      applyTangentImpulse(impact, point, sign * (point.tangentImpulse - point.tangentBefore));
    }
  }
  projectStruck(t);
}

// Makes an impact ready to be stopped again, after its impulses of this round were taken back.
function resetRound(t: RigidTable, impact: Impact): void {
  if (impact.isWeighed == 0) impact.held = weighTrees(t, impact) ? 0 : 1;
  for (let i = 0; i < impact.count; i++) {
    const point = pointOf(impact, i);
    point.given -= point.impulse;
    point.impulse = 0;
    point.tangentImpulse = point.tangentBefore;
  }
}

// A restitution above 1 adds energy once in a step, and counts as 1 in further rounds, which it would feed.
function throwBack(impact: Impact): void {
  for (let i = 0; i < impact.count; i++) {
    const point = pointOf(impact, i);
    const impulse = impact.restitution * point.impulse;
    const friction = impact.restitution * (point.tangentImpulse - point.tangentBefore);
    point.given += impulse;
    point.tangentImpulse += friction;
    applyNormalImpulse(impact, point, impulse);
    applyTangentImpulse(impact, point, friction);
  }
  if (couplesFriction(impact)) applyFriction(impact);
  impact.restitution = min<real>(1, impact.restitution);
}

// Lists the contacts of a body, and of all that bounces with it, that close faster than `slowest`.
function reachGroup(t: RigidTable, row: i32, tree: i32, group: i32, round: i32, slowest: real): void {
  if (!visit(t, group, round)) return;
  if (tree >= 0 && t.isLanding != 0) lockJoints(t, tree, slowest);
  for (let i = othersIn(t, tree); i >= 0; i--) reachBody(t, memberOf(t, row, tree, i), slowest);
}

// The same of one body.
export function reachBody(t: RigidTable, row: i32, slowest: real): void {
  if (row == 0) return;
  for (let edge = firstEdge(t, row); edge >= 0; edge = nextEdge(t, edge)) {
    const place = edge >> 1;
    const known = word(t.impactOf, place) - 1;
    const i = known < 0 && mayReach(t, place, slowest) ? addImpact(t, place) : known;
    if (i >= 0 && impactAt(t, i).listed == 0 && approachOf(impactAt(t, i)) > slowest) addApproaching(t, i);
  }
}

// An impact is passed on by what touches, and a landing, which is foreseen, by what will meet.
// @ts-ignore: decorator
@inline function mayReach(t: RigidTable, place: i32, slowest: real): bool {
  return t.isLanding != 0 ? willMeet(t, place, slowest) : isTouching(t, place);
}

// Coulomb friction of all that the rounds exerted.
function applyFriction(impact: Impact): void {
  for (let i = 0; i < impact.count; i++) {
    const point = pointOf(impact, i);
    const most = impact.friction * point.given;
    const old = point.tangentImpulse;
    const wanted = old - point.tangentMass * tangentSpeedAt(impact, point);
    point.tangentImpulse = wanted < most ? max<real>(-most, wanted) : most;
    applyTangentImpulse(impact, point, point.tangentImpulse - old);
  }
}

// Stops all that still approach, but for those that more rounds would let bounce.
function stopTheRest(t: RigidTable, slowest: real): void {
  t.struckCount = 0;
  for (let i = 0; i < t.impactCount; i++) if (impactAt(t, i).listed == 0) strike(t, i);
  solveStruck(t, LAST_PASSES, LAST_SOLVED * slowest);
}

// Bouncing, after the last sub-step.
//
// The sub-steps treat every impact without restitution. Where a point approached faster than the threshold and may bounce, the
// impulses of the impact are taken back: all beyond those with which the step began, which bear weight. So they are from all
// contacts that the impact ran on to within the step, along a row of balls or down into a pile that lands. The bodies
// then have the speeds at which they met, and bounce in rounds (impact-rounds.ts).
//
// What meets within a step is as fast as when it met: u² = u₀² + 2 a s, from the speed u₀ and the separation s before the step,
// with the mean acceleration a of the step.
import { pointOf as contactPointOf } from '../../collision/narrow-phase/2d/rigid-contact';
import { get } from '../../memory/columns';
import { LANES, splat } from '../../memory/lanes';
import { putWord, word } from '../../solver/2d/body';
import * as block from '../../solver/2d/contact-block';
import { contactOf, isFast, laneAt, pointAt } from '../../solver/2d/contact-place';
import { RigidTable } from '../../solver/2d/rigid-table';
import { firstEdge, linkContacts, nextEdge, visit } from './contact-edges';
import { halfKick } from './half-kick';
import {
  Impact,
  ImpactPoint,
  applyTangentImpulse,
  impactAt,
  pointOf,
  applyNormalImpulse,
  normalSpeedAt,
} from './impact';
import { addImpact, storeImpact } from './impact-list';
import { bounceInRounds } from './impact-rounds';
import {
  endTrees,
  hasLocks,
  memberOf,
  othersIn,
  projectImpact,
  projectImpacts,
  startTrees,
  weighTrees,
} from './impact-trees';
import { moveToEnd } from './move-to-end';
import { pairP, pairQ, solvePair } from './stop-impact';

// An impact runs on where it strikes by more than this part of the threshold.
const LEAST_PART: real = 0.1;

// Contacts that approach more slowly are at rest, m/s.
const AT_REST: real = 1e-3;

// The search for impacts is before all rounds.
const SEARCH: i32 = -1;

// Returns the number of contacts that bounced, or might have.
export function applyRestitution(table: usize): i32 {
  const t = changetype<RigidTable>(table);
  if (t.bouncyCount == 0) return 0;
  findImpacts(t);
  const count = t.impactCount;
  if (count > 0) bounceAll(t, count);
  if (hasLocks) endTrees(t);
  for (let i = 0; i < t.impactCount; i++) storeImpact(t, impactAt(t, i));
  return t.impactCount;
}

// The first `count` impacts are those that were found before the rounds.
function bounceAll(t: RigidTable, count: i32): void {
  for (let i = 0; i < count; i++) takeBack(t, impactAt(t, i));
  projectImpacts(t);
  for (let i = 0; i < count; i++) noteSpeeds(t, impactAt(t, i));
  for (let i = 0; i < count; i++) slowToImpact(t, impactAt(t, i), true);
  for (let i = 0; i < count; i++) slowToImpact(t, impactAt(t, i), false);
  for (let i = 0; i < count; i++) goOn(t, impactAt(t, i));
  halfKick(t, count, false);
  bounceInRounds(t, max<real>(<real>t.restitutionThreshold, AT_REST));
  halfKick(t, count, true);
}

// Lists the contacts of all impacts that may bounce, from those that were hit on.
function findImpacts(t: RigidTable): void {
  t.impactCount = 0;
  let linked = false;
  for (let i = 0; i < t.blockCount; i++) {
    const at = block.blockOf(t, i);
    const hit = v128.or(impactLanes(t, at + block.POINTS), impactLanes(t, at + block.POINTS + block.POINT));
    if (!v128.any_true(hit)) continue;
    if (!linked) {
      linkContacts(t);
      startTrees(t);
    }
    linked = true;
    for (let l = 0; l < LANES; l++) if (isHit(t, i * LANES + l)) findImpact(t, i * LANES + l);
  }
}

// The contacts of a block of which a point approached faster than the threshold when the step began, and met.
// @ts-ignore: decorator
@inline function impactLanes(t: RigidTable, p: usize): v128 {
  const fast = v128.le<real>(v128.load(p, block.NORMAL_SPEED), splat(-(<real>t.restitutionThreshold)));
  return v128.and(fast, v128.ne<real>(v128.load(p, block.TOTAL_IMPULSE), splat(0)));
}

function isHit(t: RigidTable, place: i32): bool {
  const l = laneAt(place);
  for (let i = 0; i < 2; i++) {
    const p = pointAt(t, place, i);
    if (isFast(t, p, l) && get(p + block.TOTAL_IMPULSE, l) != 0) return true;
  }
  return false;
}

// Lists the contacts that the impact at a contact reached, if some may bounce.
function findImpact(t: RigidTable, place: i32): void {
  const first = t.impactCount;
  let bounces = false;
  search(t, place);
  for (let i = first; i < t.impactCount; i++) {
    const impact = impactAt(t, i);
    if (impact.restitution != 0) bounces = true;
    searchGroup(t, impact.rowA, impact.treeA, impact.groupA);
    searchGroup(t, impact.rowB, impact.treeB, impact.groupB);
  }
  if (bounces) return;
  for (let i = first; i < t.impactCount; i++) putWord(t.impactOf, impactAt(t, i).place, -1);
  t.impactCount = first;
}

function search(t: RigidTable, place: i32): void {
  if (word(t.impactOf, place) == 0) addImpact(t, place);
}

// Searches the contacts of a body and of all that bounces with it.
function searchGroup(t: RigidTable, row: i32, tree: i32, group: i32): void {
  if (!visit(t, group, SEARCH)) return;
  for (let i = othersIn(t, tree); i >= 0; i--) searchBody(t, memberOf(t, row, tree, i));
}

function searchBody(t: RigidTable, row: i32): void {
  if (row == 0) return;
  for (let edge = firstEdge(t, row); edge >= 0; edge = nextEdge(t, edge)) {
    if (isHit(t, edge >> 1) || isStruck(t, edge >> 1)) search(t, edge >> 1);
  }
}

// Number of sub-steps. With the impulse of a point when the step began: what it exerts in a step if nothing changes.
// @ts-ignore: decorator
@inline function substeps(t: RigidTable): real {
  return <real>(t.dt / t.h);
}

// Whether a contact was struck, and by more than the weight that it bears.
function isStruck(t: RigidTable, place: i32): bool {
  const l = laneAt(place);
  const speed = LEAST_PART * <real>t.restitutionThreshold;
  for (let i = 0; i < 2; i++) {
    const p = pointAt(t, place, i);
    const total = get(p + block.TOTAL_IMPULSE, l);
    const least = speed * get(p + block.NORMAL_MASS, l);
    if (total <= least) continue;
    const borne = substeps(t) * contactPointOf(contactOf(t, place), i).normalImpulse;
    if (total - borne > max<real>(borne, least)) return true;
  }
  return false;
}

// Friction, too: it balances the torque of the others on what is light.
function takeBack(t: RigidTable, impact: Impact): void {
  const l = laneAt(impact.place);
  const contact = contactOf(t, impact.place);
  for (let i = 0; i < impact.count; i++) {
    const p = pointAt(t, impact.place, i);
    const point = pointOf(impact, i);
    const began = contactPointOf(contact, i);
    point.taken = beyond(get(p + block.TOTAL_IMPULSE, l), substeps(t) * began.normalImpulse);
    applyNormalImpulse(impact, point, -point.taken);
    applyTangentImpulse(
      impact,
      point,
      -beyond(get(p + block.TOTAL_TANGENT_IMPULSE, l), substeps(t) * began.tangentImpulse),
    );
  }
}

// Moves levers to where impulses keep angular momentum. An impulse P at levers of the start makes some if the bodies have slid by d since
// they met, in the middle of the step on average: d × P/2 is lost when it is taken back, and what then acts 1 + e times has to make up
// for that:
//
//   -1/2 + (1 + e)(1 - part) = 0
function goOn(t: RigidTable, impact: Impact): void {
  moveToEnd(t, impact, 1 - <real>0.5 / (1 + impact.restitution));
  impact.held = weighTrees(t, impact) ? 0 : 1;
}

// What an impulse is beyond the one that was to be expected, as far as they have the same sense.
function beyond(total: real, expected: real): real {
  if (total >= 0) return total - max<real>(0, min<real>(total, expected));
  return total - min<real>(0, max<real>(total, expected));
}

// Notes the speeds at which points met, of all before any is slowed to it, or the second point of a box that lands flat would seem to have
// met more slowly than the first.
function noteSpeeds(t: RigidTable, impact: Impact): void {
  const l = laneAt(impact.place);
  const contact = contactOf(t, impact.place);
  for (let i = 0; i < impact.count; i++) {
    const p = pointAt(t, impact.place, i);
    const point = pointOf(impact, i);
    const start = min<real>(0, get(p + block.NORMAL_SPEED, l));
    const way = isFast(t, p, l) ? max<real>(0, contactPointOf(contact, i).separation) : <real>0;
    const gained = (<real>2 * way * max<real>(0, start - normalSpeedAt(impact, point))) / <real>t.dt;
    point.met = -sqrt<real>(start * start + gained);
  }
}

// Slows the points that met fast to the speed of their impact, or the others, that touched before, to what they had.
function slowToImpact(t: RigidTable, impact: Impact, fast: bool): void {
  const l = laneAt(impact.place);
  const first = isFast(t, pointAt(t, impact.place, 0), l) == fast;
  const second = impact.count > 1 && isFast(t, pointAt(t, impact.place, 1), l) == fast;
  if (first && second && slowBoth(t, impact)) return;
  if (first) slow(t, impact, pointOf(impact, 0));
  if (second) slow(t, impact, pointOf(impact, 1));
}

// How much faster a point is than it met, m/s.
// @ts-ignore: decorator
@inline function surplusAt(impact: Impact, point: ImpactPoint): real {
  return point.met - normalSpeedAt(impact, point);
}

// Both at once: one after the other would turn a box that lands flat. Returns false where one of them would have to pull.
function slowBoth(t: RigidTable, impact: Impact): bool {
  const p = pointOf(impact, 0);
  const q = pointOf(impact, 1);
  const pp = <real>1 / p.mass;
  const qq = <real>1 / q.mass;
  if (!solvePair(pp, impact.coupling, qq, surplusAt(impact, p), surplusAt(impact, q))) return false;
  push(impact, p, pairP);
  push(impact, q, pairQ);
  projectImpact(t, impact);
  return true;
}

function slow(t: RigidTable, impact: Impact, point: ImpactPoint): void {
  const surplus = surplusAt(impact, point);
  if (!(surplus > 0)) return;
  push(impact, point, surplus * point.mass);
  projectImpact(t, impact);
}

// @ts-ignore: decorator
@inline function push(impact: Impact, point: ImpactPoint, impulse: real): void {
  point.taken -= impulse;
  applyNormalImpulse(impact, point, impulse);
}

// The list of impacts, filled from the blocks of contacts and emptied into them.
import { IS_DEEP, pointOf as contactPointOf } from '../../collision/narrow-phase/2d/rigid-contact';
import { get, put } from '../../memory/columns';
import { flagsOf, isPushed, putWord, word } from '../../solver/2d/body';
import * as block from '../../solver/2d/contact-block';
import { blockAt, contactOf, laneAt, pointAt, separationAt } from '../../solver/2d/contact-place';
import { RigidTable } from '../../solver/2d/rigid-table';
import { Impact, impactAt, pointOf, setCoupling } from './impact';
import { lockLimits, memberOf, treeOf, weighTrees } from './impact-trees';
import { moveToEnd } from './move-to-end';

// In t.impactOf: joints keep the points of the contact from moving apart.
const HELD: i32 = -2;

// From step to step the impulses of a contact that an impact reached grow at most to this many times what they were, and by a speed,
// m/s, times the effective mass.
const GROWTH: real = 2;
const LEAST_GROWTH: real = 0.01;

// Adds the impact at a contact to the list. Returns its index, or -1 if the list is full, or joints hold both bodies together.
export function addImpact(t: RigidTable, place: i32): i32 {
  const i = t.impactCount;
  if (i == t.impactCapacity || word(t.impactOf, place) == HELD) return -1;
  readImpact(t, impactAt(t, i), place);
  // What bounces does so after the last sub-step.
  if (t.isLanding != 0 && impactAt(t, i).restitution != 0) return -1;
  if (t.isLanding == 0) {
    lockLimits(t, impactAt(t, i).treeA);
    lockLimits(t, impactAt(t, i).treeB);
  }
  if (!weighTrees(t, impactAt(t, i))) {
    putWord(t.impactOf, place, HELD);
    return -1;
  }
  putWord(t.impactOf, place, i + 1);
  t.impactCount = i + 1;
  return i;
}

// Takes what is needed of a contact from its block.
function readImpact(t: RigidTable, impact: Impact, place: i32): void {
  const at = blockAt(t, place);
  const l = laneAt(place);
  const contact = contactOf(t, place);
  impact.stateA = <usize>word(at + block.A, l);
  impact.stateB = <usize>word(at + block.B, l);
  impact.rowA = isPushed(flagsOf(t, contact.bodyA)) ? contact.bodyA : 0;
  impact.rowB = isPushed(flagsOf(t, contact.bodyB)) ? contact.bodyB : 0;
  impact.treeA = treeOf(t, impact.rowA);
  impact.treeB = treeOf(t, impact.rowB);
  impact.groupA = memberOf(t, impact.rowA, impact.treeA, 0);
  impact.groupB = memberOf(t, impact.rowB, impact.treeB, 0);
  impact.place = place;
  impact.listed = 0;
  impact.held = 0;
  impact.partner = 0;
  impact.count = contact.count;
  impact.nx = get(at + block.NX, l);
  impact.ny = get(at + block.NY, l);
  impact.massAx = get(at + block.MASS_AX, l);
  impact.massAy = get(at + block.MASS_AY, l);
  impact.inertiaA = get(at + block.INERTIA_A, l);
  impact.massBx = get(at + block.MASS_BX, l);
  impact.massBy = get(at + block.MASS_BY, l);
  impact.inertiaB = get(at + block.INERTIA_B, l);
  // Bodies that were put into each other are pushed apart without bouncing.
  impact.restitution = (contact.flags & IS_DEEP) != 0 ? <real>0 : contact.restitution;
  impact.friction = get(at + block.FRICTION, l);
  impact.tangentSpeed = get(at + block.TANGENT_SPEED, l);
  for (let i = 0; i < contact.count; i++) {
    const p = pointAt(t, place, i);
    const point = pointOf(impact, i);
    point.leverA = get(p + block.NORMAL_LEVER_A, l);
    point.leverB = get(p + block.NORMAL_LEVER_B, l);
    point.mass = get(p + block.NORMAL_MASS, l);
    point.ownMass = point.mass;
    point.tangentLeverA = get(p + block.TANGENT_LEVER_A, l);
    point.tangentLeverB = get(p + block.TANGENT_LEVER_B, l);
    point.tangentMass = get(p + block.TANGENT_MASS, l);
    point.impulse = 0;
    point.given = 0;
    point.tangentImpulse = 0;
    point.taken = 0;
    point.room = t.isLanding != 0 ? max<real>(0, separationAt(at, p, l)) / <real>t.dt : <real>0;
  }
  setCoupling(impact);
  // What acted at levers that followed did so on average in the middle of the step.
  if (t.isLanding == 0 && get(at + block.REACH, l) > 0) moveToEnd(t, impact, 0.5);
}

// Changes the impulses of the contact by those of the rounds. The next step begins with the impulses of the last sub-step, because
// they bear weight; but an impact in it is no weight, and so they become larger only by and by.
export function storeImpact(t: RigidTable, impact: Impact): void {
  const at = blockAt(t, impact.place);
  const l = laneAt(impact.place);
  const contact = contactOf(t, impact.place);
  let part: real = 1;
  for (let i = 0; i < impact.count; i++) {
    const point = pointOf(impact, i);
    const change = point.given - point.taken;
    if (change == 0) continue;
    const p = pointAt(t, impact.place, i);
    put(p + block.TOTAL_IMPULSE, l, get(p + block.TOTAL_IMPULSE, l) + change);
    put(p + block.TOTAL_TANGENT_IMPULSE, l, get(p + block.TOTAL_TANGENT_IMPULSE, l) + point.tangentImpulse);
    const most = GROWTH * contactPointOf(contact, i).normalImpulse + LEAST_GROWTH * point.mass;
    const impulse = get(p + block.NORMAL_IMPULSE, l);
    if (impulse > most) part = min<real>(part, most / impulse);
  }
  scale(at + block.ROLLING_IMPULSE, l, part);
  for (let i = 0; i < impact.count; i++) {
    const p = pointAt(t, impact.place, i);
    scale(p + block.NORMAL_IMPULSE, l, part);
    scale(p + block.TANGENT_IMPULSE, l, part);
  }
}

function scale(numbers: usize, l: i32, factor: real): void {
  put(numbers, l, factor * get(numbers, l));
}

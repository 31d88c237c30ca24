// The list of joints, made when joints or bodies have come or gone.
import { ASLEEP, WAKES, flagsOf, putFlags, putWord, word } from '../../solver/2d/body';
import { forgetBox } from '../../solver/2d/gather-bodies';
import { RigidTable } from '../../solver/2d/rigid-table';
import { areJoined, firstOf, secondOf } from '../../collision/broad-phase/2d/pair-filter';
import { keyAt, sortKeys } from '../../collision/broad-phase/2d/sort-keys';
import { JointTable } from './joint-table';

// Lists the joints of which a body was removed, and the pairs that do not collide. Called before a step if joints or
// bodies were added or removed, or `collide` changed.
export function listJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  const before = t.pairCount;
  // This list is in use only while trees are put in order.
  memory.copy(t.next, t.pairs, (<usize>before) << 3);
  wakeReleased(t, rigid);
  t.orphanCount = 0;
  t.pairCount = 0;
  for (let i = 0; i < t.count; i++) {
    const id = word(t.ids, i);
    const a = word(t.a, id);
    const b = word(t.b, id);
    followEnds(t, rigid, id);
    putWord(t.listed, id, listedOf(t, id));
    const hasA = a == 0 || hasGeneration(rigid, a, word(t.aGeneration, id));
    if (!hasA || !hasGeneration(rigid, b, word(t.bGeneration, id))) {
      putWord(t.orphans, t.orphanCount++, id);
      continue;
    }
    if (a == 0 || word(t.collide, id) != 0) continue;
    const key = ((<u64>min<i32>(a, b)) << 32) | <u64>max<i32>(a, b);
    store<u64>(t.pairs + ((<usize>t.pairCount) << 3), key);
    t.pairCount++;
  }
  sortKeys(t.pairs, t.spare, t.pairCount);
  rigid.jointPairs = t.pairs;
  rigid.jointPairCount = t.pairCount;
  rigid.isUnsettled = 1;
  releasePairs(t, rigid, before);
}

// Whether `collide`, the kind or a body of a joint has changed since the joints were listed; then its bodies wake.
export function hasNewCollisions(table: usize): bool {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  let any = false;
  for (let i = 0; i < t.count; i++) {
    const id = word(t.ids, i);
    if (listedOf(t, id) == word(t.listed, id)) continue;
    any = true;
    wakeLater(rigid, word(t.a, id));
    wakeLater(rigid, word(t.b, id));
  }
  return any;
}

// What decides which bodies a joint keeps from colliding, and whether it holds them at all: a number of its two bodies, and below it the
// kind and `collide`.
// @ts-ignore: decorator
@inline function listedOf(t: JointTable, id: i32): i32 {
  const ends = word(t.a, id) * ROWS_APART + word(t.b, id);
  return (ends << ENDS) | (word(t.kind, id) << 1) | (word(t.collide, id) & 1);
}

const ENDS: i32 = 5;

// An odd number: a pair of bodies near each other among the rows and another of this kind have different numbers.
const ROWS_APART: i32 = 0x1e3779b1;

// A joint that got another body since it was listed means the one that is there now.
function followEnds(t: JointTable, rigid: RigidTable, id: i32): void {
  if (word(t.started, id) == 0 || listedOf(t, id) >> ENDS == word(t.listed, id) >> ENDS) return;
  putWord(t.aGeneration, id, word(rigid.generations, word(t.a, id)));
  putWord(t.bGeneration, id, word(rigid.generations, word(t.b, id)));
}

// Bodies that sleep wake when a joint of theirs is gone.
function wakeReleased(t: JointTable, rigid: RigidTable): void {
  for (let i = 0; i < rigid.linkCount; i++) {
    const id = word(t.linkIds, i);
    const a = word(t.links, 2 * i);
    const b = word(t.links, 2 * i + 1);
    const isThere = (<u32>word(rigid.members, id) & t.jointBit) != 0;
    if (isThere && word(t.a, id) == a && word(t.b, id) == b) continue;
    wakeLater(rigid, a);
    wakeLater(rigid, b);
  }
}

// @ts-ignore: decorator
@inline function wakeLater(rigid: RigidTable, row: i32): void {
  if ((flagsOf(rigid, row) & ASLEEP) != 0) putFlags(rigid, row, flagsOf(rigid, row) | WAKES);
}

// Bodies that joints no longer keep from colliding look for each other again. They must be awake for that: what sleeps is given
// no box, and nothing would meet it.
function releasePairs(t: JointTable, rigid: RigidTable, count: i32): void {
  for (let i = 0; i < count; i++) {
    const key = keyAt(t.next, i);
    const a = firstOf(key);
    const b = secondOf(key);
    if (areJoined(rigid, a, b)) continue;
    forgetBox(rigid, a);
    forgetBox(rigid, b);
    wakeLater(rigid, a);
    wakeLater(rigid, b);
  }
}

// @ts-ignore: decorator
@inline function hasGeneration(rigid: RigidTable, row: i32, generation: i32): bool {
  return row > 0 && word(rigid.generations, row) == generation && (word(rigid.members, row) & 1) != 0;
}

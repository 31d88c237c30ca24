// Bodies that sleep wake with what they are joined to, and when their joint is changed.
import { get } from '../../memory/columns';
import { ASLEEP, JOINED, flagsOf, isActive, putFlags, putWord, word } from '../../solver/2d/body';
import { listAwake } from '../../solver/2d/gather-bodies';
import { wakeIsland } from '../../solver/2d/islands';
import { RigidTable } from '../../solver/2d/rigid-table';
import { FILTER, JointTable, impulsesOf } from './joint-table';

// Wakes what is joined to something that moves, and what hangs from a joint that was changed, and notes the pairs of bodies.
export function wakeJoined(t: JointTable, rigid: RigidTable): void {
  let any = false;
  for (let i = 0; i < t.count; i++) {
    const id = word(t.ids, i);
    // A filter joint holds nothing together.
    const holds = <u32>word(t.kind, id) != FILTER;
    const a = holds ? word(t.a, id) : 0;
    const b = holds ? word(t.b, id) : 0;
    putWord(t.linkIds, i, id);
    putWord(t.links, 2 * i, a);
    putWord(t.links, 2 * i + 1, b);
    if (a > 0) putFlags(rigid, a, flagsOf(rigid, a) | JOINED);
    if (b > 0) putFlags(rigid, b, flagsOf(rigid, b) | JOINED);
    const flagsA = flagsOf(rigid, a);
    const flagsB = flagsOf(rigid, b);
    if (((flagsA | flagsB) & ASLEEP) == 0) continue;
    if (!isActive(flagsA) && !isActive(flagsB) && impulsesOf(t, id).settings == settingsOf(t, id)) continue;
    if ((flagsA & ASLEEP) != 0) wakeIsland(rigid, a);
    if ((flagsOf(rigid, b) & ASLEEP) != 0) wakeIsland(rigid, b);
    any = true;
  }
  rigid.linkCount = t.count;
  if (any) listAwake(rigid);
}

// Ends a step: notes the settings of joints whose bodies have just fallen asleep.
export function noteSettings(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  for (let i = 0; i < t.activeCount; i++) {
    const id = word(t.active, i);
    if (((flagsOf(rigid, word(t.a, id)) | flagsOf(rigid, word(t.b, id))) & ASLEEP) == 0) continue;
    impulsesOf(t, id).settings = settingsOf(t, id);
  }
}

// A hash of what users set, in which every bit counts: FNV-1a, in words of 64 bits.
function settingsOf(t: JointTable, id: i32): u32 {
  let hash: u64 = 0xcbf29ce484222325;
  hash = mix(mix(mix(mix(hash, t.ax, id), t.ay, id), t.bx, id), t.by, id);
  hash = mix(mix(mix(mix(hash, t.angle, id), t.axis, id), t.length, id), t.ratio, id);
  hash = mix(mix(mix(mix(hash, t.pulleyAx, id), t.pulleyAy, id), t.pulleyBx, id), t.pulleyBy, id);
  hash = mix(mix(mix(mix(hash, t.lower, id), t.upper, id), t.hertz, id), t.dampingRatio, id);
  hash = mix(mix(mix(mix(hash, t.maxForce, id), t.maxCompression, id), t.motorSpeed, id), t.maxMotor, id);
  hash = mixWord(mixWord(mixWord(hash, t.kind, id), t.a, id), t.b, id);
  hash = mixWord(mixWord(hash, t.isRack, id), t.hasLimits, id);
  hash = mix(mix(hash, t.breakForce, id), t.breakTorque, id);
  return <u32>(hash ^ (hash >> 32));
}

const FNV_PRIME: u64 = 0x100000001b3;

// @ts-ignore: decorator
@inline function mix(hash: u64, column: usize, id: i32): u64 {
  return (hash ^ reinterpret<u64>(<f64>get(column, id))) * FNV_PRIME;
}

// @ts-ignore: decorator
@inline function mixWord(hash: u64, column: usize, id: i32): u64 {
  return (hash ^ <u64>word(column, id)) * FNV_PRIME;
}

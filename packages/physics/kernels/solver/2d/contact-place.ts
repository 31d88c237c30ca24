// A contact by its place: the lane of a block, counted from the first one.
import { TARGET } from '../../collision/narrow-phase/2d/collide-ahead';
import { RigidContact, contactAt } from '../../collision/narrow-phase/2d/rigid-contact';
import { get } from '../../memory/columns';
import { LANES } from '../../memory/lanes';
import { BodyState, word } from './body';
import * as block from './contact-block';
import { RigidTable } from './rigid-table';

// @ts-ignore: decorator
@inline export function blockAt(t: RigidTable, place: i32): usize {
  return block.blockOf(t, place / LANES);
}

// @ts-ignore: decorator
@inline export function laneAt(place: i32): i32 {
  return place & (LANES - 1);
}

// @ts-ignore: decorator
@inline export function contactOf(t: RigidTable, place: i32): RigidContact {
  return contactAt(t, word(blockAt(t, place) + block.SLOT, laneAt(place)));
}

// The address of one of its points.
// @ts-ignore: decorator
@inline export function pointAt(t: RigidTable, place: i32, i: i32): usize {
  return blockAt(t, place) + block.POINTS + <usize>i * block.POINT;
}

// Whether a point approached faster than the threshold when the step began.
// @ts-ignore: decorator
@inline export function isFast(t: RigidTable, p: usize, l: i32): bool {
  return get(p + block.NORMAL_SPEED, l) <= -(<real>t.restitutionThreshold);
}

// Whether the surfaces touch: an impulse passed in this step, or they are no farther apart than the slop.
export function isTouching(t: RigidTable, place: i32): bool {
  const at = blockAt(t, place);
  const l = laneAt(place);
  for (let p = at + block.POINTS; p < at + block.CONTACT_BLOCK; p += block.POINT) {
    if (get(p + block.NORMAL_MASS, l) == 0) continue;
    if (get(p + block.TOTAL_IMPULSE, l) != 0 || separationAt(at, p, l) <= TARGET) return true;
  }
  return false;
}

// Whether a point approaches faster than `slowest` now, and meets within the step.
export function willMeet(t: RigidTable, place: i32, slowest: real): bool {
  const at = blockAt(t, place);
  const l = laneAt(place);
  for (let p = at + block.POINTS; p < at + block.CONTACT_BLOCK; p += block.POINT) {
    if (get(p + block.NORMAL_MASS, l) == 0) continue;
    const speed = speedAt(at, p, l);
    if (speed < -slowest && separationAt(at, p, l) + <real>t.dt * speed < 0) return true;
  }
  return false;
}

// The speed at which the surfaces part at a point, m/s.
function speedAt(at: usize, p: usize, l: i32): real {
  const a = changetype<BodyState>(<usize>word(at + block.A, l));
  const b = changetype<BodyState>(<usize>word(at + block.B, l));
  const turning = b.w * get(p + block.NORMAL_LEVER_B, l) - a.w * get(p + block.NORMAL_LEVER_A, l);
  return get(at + block.NX, l) * (b.vx - a.vx) + get(at + block.NY, l) * (b.vy - a.vy) + turning;
}

// How far the surfaces are apart at a point now, m.
export function separationAt(at: usize, p: usize, l: i32): real {
  const a = changetype<BodyState>(<usize>word(at + block.A, l));
  const b = changetype<BodyState>(<usize>word(at + block.B, l));
  const moved = get(at + block.NX, l) * (b.dx - a.dx) + get(at + block.NY, l) * (b.dy - a.dy);
  const alongA = a.dc * get(p + block.ALONG_A, l) + a.ds * get(p + block.NORMAL_LEVER_A, l);
  const alongB = b.dc * get(p + block.ALONG_B, l) + b.ds * get(p + block.NORMAL_LEVER_B, l);
  return get(p + block.SEPARATION, l) + (moved + (alongB - alongA));
}

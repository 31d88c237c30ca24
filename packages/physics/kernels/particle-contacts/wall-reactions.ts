// Wall reactions: a body supported by a wall can move only along it.
//
// The wall with normal m cancels the component of an impulse along n into the wall: the direction becomes n - (n.m) m,
// and the inverse mass along n is scaled by 1 - (n.m)^2. This solves both contacts together exactly; solved in turn, a
// heavy ball on a light ball on the floor would need as many iterations as the ratio of their masses.
import { Columns, get, put } from '../memory/columns';
import { Body, body } from './body';
import { ContactTable, putWord, word } from './table';

// Results of `constrainToWall`: the constrained direction, the remaining fraction of the inverse mass, the wall contact
// (-1 if none) and the cosine between direction and wall normal.
@unmanaged
class Reaction {
  x: real;
  y: real;
  z: real;
  massFraction: real;
  cosine: real;
  wall: i32;
}

// The result of the last call.
export const reaction = changetype<Reaction>(memory.data(offsetof<Reaction>(), 8));

// Stores for each body the wall contact that supports it most, and for each wall contact the slot of its body (-1 if
// the body has no other contact) and the allowed approach speed. That speed closes the gap by the end of the next step;
// a higher present speed is allowed, because the next step's impact handles it.
export function linkWalls(t: ContactTable, dt: real): void {
  for (let k = 0; k < t.wallCount; k++) {
    const slot = word(t.rowWords, word(t.wallBody, k)) - 1;
    putWord(t.wallSlot, k, slot);
    if (slot < 0) continue;
    const b = body(t, slot);
    const gap = get(t.wallGap, k);
    if (gap > 0) {
      const speed = b.vx * get(t.wallNx, k) + b.vy * get(t.wallNy, k) + b.vz * get(t.wallNz, k);
      put(t.wallGap, k, max<real>(gap / dt, -speed));
    }
    if (b.wall == 0 || get(t.wallAccumulatedImpulse, k) > get(t.wallAccumulatedImpulse, b.wall - 1)) b.wall = k + 1;
  }
}

// Leaves to the impact of the next step what is no support of a pile: walls of bodies without a mark in the row words,
// and the speed at which an impact of this step pushed a body to a wall that it does not rest on, or from which it
// rebounds without loss. Were it stopped here, a restitution of 1 would lose energy, and only where something else rests.
export function releaseWalls(c: Columns, t: ContactTable): void {
  for (let k = 0; k < t.wallCount; k++) {
    const slot = word(t.wallSlot, k);
    if (slot < 0) continue;
    if (word(t.rowWords, slot) == 0) {
      putWord(t.wallSlot, k, -1);
      continue;
    }
    if (get(t.wallAccumulatedImpulse, k) > 0 && get(c.restitution, word(t.wallBody, k)) < 1) continue;
    const b = body(t, slot);
    const speed = b.vx * get(t.wallNx, k) + b.vy * get(t.wallNy, k) + b.vz * get(t.wallNz, k);
    put(t.wallGap, k, max<real>(get(t.wallGap, k), -speed));
  }
}

// Projects the direction (x, y, z) onto the wall that supports the body. The body is supported if it approaches the
// wall at the allowed speed to within `speedTolerance`.
export function constrainToWall(t: ContactTable, b: Body, x: real, y: real, z: real, speedTolerance: real): void {
  reaction.x = x;
  reaction.y = y;
  reaction.z = z;
  reaction.massFraction = 1;
  const wall = b.wall - 1;
  reaction.wall = wall;
  if (wall < 0) return;
  const mx = get(t.wallNx, wall);
  const my = get(t.wallNy, wall);
  const mz = get(t.wallNz, wall);
  const cosine = x * mx + y * my + z * mz;
  const speedAway = b.vx * mx + b.vy * my + b.vz * mz;
  if (!(cosine < 0) || speedAway + get(t.wallGap, wall) > speedTolerance) {
    reaction.wall = -1;
    return;
  }
  reaction.x = x - cosine * mx;
  reaction.y = y - cosine * my;
  reaction.z = z - cosine * mz;
  reaction.massFraction = max<real>(0, <real>1 - cosine * cosine);
  reaction.cosine = cosine;
}

// Adds to the impulse of a wall.
// @ts-ignore: decorator
@inline export function addWallImpulse(t: ContactTable, k: i32, impulse: real): void {
  put(t.wallAccumulatedImpulse, k, get(t.wallAccumulatedImpulse, k) + impulse);
  put(t.wallImpulse, k, get(t.wallImpulse, k) + impulse);
}

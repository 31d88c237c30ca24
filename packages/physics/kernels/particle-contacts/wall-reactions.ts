// Bodies that lie on walls give way only along them.
//
// An impulse along n on a body that a wall with normal m holds is answered by the wall, at once and in full: what is
// left is the part along the wall, n - (n.m) m, and the body's inverse mass along n shrinks to w (1 - (n.m)^2). Solving
// the two together is exact and costs nothing; solved in turns, a heavy ball on a light one on the floor would take as
// many sweeps as the ratio of their masses.
import { get, put } from '../memory/columns';
import { Body, body } from './body';
import { ContactTable, putWord, word } from './table';

// What is left of the direction given to `leave`, the share of the inverse mass, and the wall (-1 without one) with the
// cosine it answers by.
@unmanaged
class Reaction {
  x: real;
  y: real;
  z: real;
  share: real;
  cosine: real;
  wall: i32;
}

// The result of the last `leave`.
export const reaction = changetype<Reaction>(memory.data(offsetof<Reaction>(), 8));

// Notes for each body with contacts which contact with a wall holds it most, and for each contact with a wall where its
// body is, -1 where no other body touches that one, and how fast the body may come: as fast as closes the gap by the end
// of the next step, or as it does already, for that is a matter of the next step's impact.
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
    if (b.wall == 0 || get(t.wallHolding, k) > get(t.wallHolding, b.wall - 1)) b.wall = k + 1;
  }
}

// How far a body can follow a push in direction (x, y, z). It lies on its wall when it comes as fast as it may; `slow`
// is a speed that makes no difference.
export function leave(t: ContactTable, b: Body, x: real, y: real, z: real, slow: real): void {
  reaction.x = x;
  reaction.y = y;
  reaction.z = z;
  reaction.share = 1;
  const wall = b.wall - 1;
  reaction.wall = wall;
  if (wall < 0) return;
  const mx = get(t.wallNx, wall);
  const my = get(t.wallNy, wall);
  const mz = get(t.wallNz, wall);
  const cosine = x * mx + y * my + z * mz;
  const off = b.vx * mx + b.vy * my + b.vz * mz;
  if (!(cosine < 0) || off + get(t.wallGap, wall) > slow) {
    reaction.wall = -1;
    return;
  }
  reaction.x = x - cosine * mx;
  reaction.y = y - cosine * my;
  reaction.z = z - cosine * mz;
  reaction.share = max<real>(0, <real>1 - cosine * cosine);
  reaction.cosine = cosine;
}

// Adds to what a wall bears.
// @ts-ignore: decorator
@inline export function bear(t: ContactTable, k: i32, impulse: real): void {
  put(t.wallHolding, k, get(t.wallHolding, k) + impulse);
  put(t.wallImpulse, k, get(t.wallImpulse, k) + impulse);
}

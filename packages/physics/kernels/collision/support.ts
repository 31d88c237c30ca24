// Bodies that lie on walls give way only along them.
//
// An impulse along n on a body that a wall with normal m holds is answered by the wall, at once and in full: what is
// left is the part along the wall, n - (n.m) m, and the body's inverse mass along n shrinks to w (1 - (n.m)^2). Solving
// the two together is exact and costs nothing; solved in turns, a heavy ball on a light one on the floor would take as
// many sweeps as the ratio of their masses.
import { Columns, get, put } from '../columns';
import { ContactTable, putWord, word } from './table';

// What is left of the direction given to `leave`, the share of the inverse mass, and the wall (-1 without one) with the
// cosine it answers by.
export let leftX: real = 0;
export let leftY: real = 0;
export let leftZ: real = 0;
export let share: real = 1;
export let wall: i32 = -1;
export let cosine: real = 0;

// Notes for each body which contact with a wall holds it most: rowWords holds its index + 1.
export function linkWalls(t: ContactTable, lastId: i32): void {
  memory.fill(t.rowWords, 0, (<usize>(lastId + 1)) << 2);
  for (let k = 0; k < t.wallCount; k++) {
    const body = word(t.wallBody, k);
    const known = word(t.rowWords, body) - 1;
    if (known < 0 || get(t.wallHolding, k) > get(t.wallHolding, known)) putWord(t.rowWords, body, k + 1);
  }
}

// How far `row` can follow a push in direction (x, y, z). A body lies on its wall when it comes no slower than it takes
// to close the gap to it by the end of the next step; `slow` is a speed that makes no difference.
export function leave(c: Columns, t: ContactTable, row: i32, x: real, y: real, z: real, dt: real, slow: real): void {
  leftX = x;
  leftY = y;
  leftZ = z;
  share = 1;
  wall = word(t.rowWords, row) - 1;
  if (wall < 0) return;
  const mx = get(t.wallNx, wall);
  const my = get(t.wallNy, wall);
  const mz = get(t.wallNz, wall);
  cosine = x * mx + y * my + z * mz;
  const off = get(c.velocityX, row) * mx + get(c.velocityY, row) * my + get(c.velocityZ, row) * mz;
  if (!(cosine < 0) || off + get(t.wallGap, wall) / dt > slow) {
    wall = -1;
    return;
  }
  leftX = x - cosine * mx;
  leftY = y - cosine * my;
  leftZ = z - cosine * mz;
  share = max<real>(0, <real>1 - cosine * cosine);
}

// Adds to what a wall bears.
// @ts-ignore: decorator
@inline export function bear(t: ContactTable, k: i32, impulse: real): void {
  put(t.wallHolding, k, get(t.wallHolding, k) + impulse);
  put(t.wallImpulse, k, get(t.wallImpulse, k) + impulse);
}

// How an impulse acts on a body inside a step.
import { Columns, get, put } from '../columns';
import { ContactTable } from './table';

// Changes the velocity of a row by (dx, dy, dz), and its position by what that amounts to in `time`, the time since. The
// start velocity moves along: an impulse is no acceleration, and whoever asks for the step's acceleration must not see
// it as one.
// @ts-ignore: decorator
@inline export function kick(
  c: Columns,
  t: ContactTable,
  row: i32,
  dx: real,
  dy: real,
  dz: real,
  time: real,
): void {
  put(c.velocityX, row, get(c.velocityX, row) + dx);
  put(c.velocityY, row, get(c.velocityY, row) + dy);
  put(c.velocityZ, row, get(c.velocityZ, row) + dz);
  follow(c, t, row, dx, dy, dz, time);
}

// What `kick` does besides the velocity, for a change that is made already.
// @ts-ignore: decorator
@inline export function follow(
  c: Columns,
  t: ContactTable,
  row: i32,
  dx: real,
  dy: real,
  dz: real,
  time: real,
): void {
  put(c.positionX, row, get(c.positionX, row) + dx * time);
  put(c.positionY, row, get(c.positionY, row) + dy * time);
  put(c.positionZ, row, get(c.positionZ, row) + dz * time);
  put(t.startX, row, get(t.startX, row) + dx);
  put(t.startY, row, get(t.startY, row) + dy);
  put(t.startZ, row, get(t.startZ, row) + dz);
}

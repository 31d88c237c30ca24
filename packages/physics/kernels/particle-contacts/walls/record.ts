// Contacts with walls, written down for those who read them and for the bodies that lie on bodies that lie on walls.
// Nothing is written in a world without contacts.
import { put } from '../../memory/columns';
import { ContactTable, contactTable, putWord } from '../table';

// A body touched a wall. `impulse` is along the normal (nx, ny, nz) out of the wall, N s; `holding` the part of it that
// holds a body at rest, 0 for a rebound; `friction` the coefficient that friction was reckoned with.
export function recordWallContact(
  body: i32,
  wall: i32,
  nx: real,
  ny: real,
  nz: real,
  friction: real,
  impulse: real,
  holding: real,
): void {
  record(body, wall, nx, ny, nz, friction, impulse, holding, 0);
}

// A body is near a wall: it may be pushed against it before the step ends.
export function recordNearWall(body: i32, wall: i32, nx: real, ny: real, nz: real, friction: real, gap: real): void {
  record(body, wall, nx, ny, nz, friction, 0, 0, max<real>(0, gap));
}

function record(
  body: i32,
  wall: i32,
  nx: real,
  ny: real,
  nz: real,
  friction: real,
  impulse: real,
  holding: real,
  gap: real,
): void {
  const t = contactTable();
  if (changetype<usize>(t) == 0) return;
  const i = t.wallCount;
  if (i >= t.wallCapacity) {
    t.wallLost++;
    return;
  }
  t.wallCount = i + 1;
  putWord(t.wallBody, i, body);
  putWord(t.wallId, i, wall);
  put(t.wallNx, i, nx);
  put(t.wallNy, i, ny);
  put(t.wallNz, i, nz);
  put(t.wallImpulse, i, impulse);
  put(t.wallHolding, i, holding);
  put(t.wallGap, i, gap);
  put(t.wallFriction, i, friction);
  put(t.wallRubbed, i, impulse);
  memory.fill(t.wallRubbing + <usize>i * 12, 0, 12);
}

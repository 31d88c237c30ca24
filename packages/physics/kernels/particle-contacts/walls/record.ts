// Records wall contacts for events and for the resting-contact solver. A world without contacts records nothing.
import { columns, get, put } from '../../memory/columns';
import { ContactTable, contactTable, putWord } from '../table';

// Records that a body touched a wall. `speed` (m/s) is its speed into the wall at the impact, or before the step if it
// was there already; `impulse` (N s) is along the normal (nx, ny, nz) out of the wall; `restingImpulse` is the part of it
// that supports a resting body, 0 for a rebound; `friction` is the coefficient that was applied.
export function recordWallContact(
  body: i32,
  wall: i32,
  nx: real,
  ny: real,
  nz: real,
  friction: real,
  speed: real,
  impulse: real,
  restingImpulse: real,
): void {
  record(body, wall, nx, ny, nz, friction, speed, impulse, restingImpulse, 0);
}

// Records that a body is near a wall, because contacts may press it against the wall before the step ends.
export function recordNearWall(body: i32, wall: i32, nx: real, ny: real, nz: real, friction: real, gap: real): void {
  const c = columns();
  const away = get(c.velocityX, body) * nx + get(c.velocityY, body) * ny + get(c.velocityZ, body) * nz;
  record(body, wall, nx, ny, nz, friction, -away, 0, 0, max<real>(0, gap));
}

function record(
  body: i32,
  wall: i32,
  nx: real,
  ny: real,
  nz: real,
  friction: real,
  speed: real,
  impulse: real,
  restingImpulse: real,
  gap: real,
): void {
  const t = contactTable();
  if (changetype<usize>(t) == 0) return;
  const i = t.wallCount;
  if (i >= t.wallCapacity) {
    t.wallDroppedCount++;
    return;
  }
  t.wallCount = i + 1;
  putWord(t.wallBody, i, body);
  putWord(t.wallId, i, wall);
  put(t.wallNx, i, nx);
  put(t.wallNy, i, ny);
  put(t.wallNz, i, nz);
  put(t.wallSpeed, i, speed);
  put(t.wallImpulse, i, impulse);
  put(t.wallAccumulatedImpulse, i, restingImpulse);
  put(t.wallGap, i, gap);
  put(t.wallFriction, i, friction);
  put(t.wallFrictionApplied, i, impulse);
  memory.fill(t.wallTangentImpulse + <usize>i * 12, 0, 12);
}

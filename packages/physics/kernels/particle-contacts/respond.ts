// Collision response for the contacts that the broad phase found and sorted.
import { columns, get, put } from '../memory/columns';
import { approach, readSeparation } from './approach';
import { body, gatherBodies, scatterBodies } from './body';
import { resolveImpacts } from './impacts';
import { joinPrevious } from './order';
import { solveRestingContacts } from './resting-contacts';
import { correctPositions } from './position-correction';
import { linkWalls } from './wall-reactions';
import { ContactTable, contactTable, putWord, word } from './table';

// Gathers the bodies and solves impacts. `lag` is the time by which the integrator's velocities lag its positions,
// `lastId` the highest entity id.
export function respondToImpacts(dt: real, lag: real, lastId: i32): void {
  const c = columns();
  const t = contactTable();
  const scale: real = t.previousDt > 0 ? <real>(<f64>dt / t.previousDt) : 0;
  t.previousDt = <f64>dt;
  if (t.count == 0) {
    t.bodyCount = 0;
    return;
  }
  joinPrevious(scale);
  gatherBodies(c, dt, lastId);
  linkWalls(t, dt);
  resolveImpacts(c, t, dt, lag);
}

// Solves resting contacts and overlaps, then removes the contacts that did not touch. With `savePositions` the positions
// before the response are saved for `clampToSegments`.
export function settleContacts(dt: real, lag: real, savePositions: bool): void {
  const c = columns();
  const t = contactTable();
  if (t.count > 0) {
    solveRestingContacts(c, t, dt, lag);
    correctPositions(c, t, dt);
    compactContacts(t);
    scatterBodies(c, t, savePositions);
  }
  compactWallContacts(t);
}

// Removes the contacts that were near but did not touch, and computes the contact points of the others.
function compactContacts(t: ContactTable): void {
  let kept = 0;
  for (let i = 0; i < t.count; i++) {
    const a = body(t, word(t.slotA, i));
    const b = body(t, word(t.slotB, i));
    readSeparation(a, b);
    const overlap = a.radius + b.radius - approach.distance;
    const impulse = get(t.impulse, i);
    if (!(impulse > 0 || overlap > 0)) continue;
    const nx = get(t.nx, i);
    const ny = get(t.ny, i);
    const nz = get(t.nz, i);
    putWord(t.a, kept, word(t.a, i));
    putWord(t.b, kept, word(t.b, i));
    put(t.nx, kept, nx);
    put(t.ny, kept, ny);
    put(t.nz, kept, nz);
    put(t.speed, kept, get(t.speed, i));
    put(t.impulse, kept, impulse);
    put(t.accumulatedImpulse, kept, get(t.accumulatedImpulse, i));
    const arm = a.radius - <real>0.5 * overlap;
    put(t.x, kept, a.x + nx * arm);
    put(t.y, kept, a.y + ny * arm);
    // In 2D z shares the zero column of nz.
    if (t.z != t.nz) put(t.z, kept, a.z + nz * arm);
    kept++;
  }
  t.count = kept;
}

function compactWallContacts(t: ContactTable): void {
  let kept = 0;
  for (let k = 0; k < t.wallCount; k++) {
    const impulse = get(t.wallImpulse, k);
    if (!(impulse > 0)) continue;
    putWord(t.wallBody, kept, word(t.wallBody, k));
    putWord(t.wallId, kept, word(t.wallId, k));
    put(t.wallNx, kept, get(t.wallNx, k));
    put(t.wallNy, kept, get(t.wallNy, k));
    put(t.wallNz, kept, get(t.wallNz, k));
    put(t.wallSpeed, kept, get(t.wallSpeed, k));
    put(t.wallImpulse, kept, impulse);
    kept++;
  }
  t.wallCount = kept;
}

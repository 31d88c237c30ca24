// The response to the contacts of a step, after the broad phase found and ordered them.
import { Columns, columns, get, put } from '../columns';
import { resolveImpacts } from './impacts';
import { joinPrevious } from './order';
import { holdResting } from './rest';
import { separate } from './separate';
import { linkWalls } from './support';
import { ContactTable, contactTable, putWord, word } from './table';

// Impacts, resting contacts, overlaps; then only those contacts stay in the list that touched. `lag` is the time by
// which the integrator's velocities lag its positions, `lastId` the highest id.
export function respond(dt: real, lag: real, lastId: i32): void {
  const c = columns();
  const t = contactTable();
  const scale: real = t.previousDt > 0 ? <real>(<f64>dt / t.previousDt) : 0;
  t.previousDt = <f64>dt;
  if (t.count > 0) {
    joinPrevious(scale);
    resolveImpacts(c, t, dt, lag);
    holdResting(c, t, dt, lag, lastId);
    linkWalls(t, lastId);
    separate(c, t, dt);
    keepTouching(c, t);
  }
  keepTouchingWalls(t);
}

function keepTouchingWalls(t: ContactTable): void {
  let kept = 0;
  for (let k = 0; k < t.wallCount; k++) {
    const impulse = get(t.wallImpulse, k);
    if (!(impulse > 0)) continue;
    putWord(t.wallBody, kept, word(t.wallBody, k));
    putWord(t.wallId, kept, word(t.wallId, k));
    put(t.wallNx, kept, get(t.wallNx, k));
    put(t.wallNy, kept, get(t.wallNy, k));
    put(t.wallNz, kept, get(t.wallNz, k));
    put(t.wallImpulse, kept, impulse);
    kept++;
  }
  t.wallCount = kept;
}

function keepTouching(c: Columns, t: ContactTable): void {
  let kept = 0;
  for (let i = 0; i < t.count; i++) {
    const a = word(t.a, i);
    const b = word(t.b, i);
    const dx = get(c.positionX, b) - get(c.positionX, a);
    const dy = get(c.positionY, b) - get(c.positionY, a);
    const dz = get(c.positionZ, b) - get(c.positionZ, a);
    const ra = get(c.radius, a);
    const overlap = ra + get(c.radius, b) - sqrt<real>(dx * dx + dy * dy + dz * dz);
    const impulse = get(t.impulse, i);
    if (!(impulse > 0 || overlap > 0)) continue;
    const nx = get(t.nx, i);
    const ny = get(t.ny, i);
    const nz = get(t.nz, i);
    putWord(t.a, kept, a);
    putWord(t.b, kept, b);
    put(t.nx, kept, nx);
    put(t.ny, kept, ny);
    put(t.nz, kept, nz);
    put(t.impulse, kept, impulse);
    put(t.holding, kept, get(t.holding, i));
    const arm = ra - <real>0.5 * overlap;
    put(t.x, kept, get(c.positionX, a) + nx * arm);
    put(t.y, kept, get(c.positionY, a) + ny * arm);
    if (t.z != t.nz) put(t.z, kept, get(c.positionZ, a) + nz * arm);
    kept++;
  }
  t.count = kept;
}

// Remembers where the bodies with contacts are, before contacts move them.
export function rememberPositions(): void {
  const c = columns();
  const t = contactTable();
  for (let i = 0; i < t.count; i++) {
    remember(c, t, word(t.a, i));
    remember(c, t, word(t.b, i));
  }
}

// @ts-ignore: decorator
@inline function remember(c: Columns, t: ContactTable, row: i32): void {
  put(t.fromX, row, get(c.positionX, row));
  put(t.fromY, row, get(c.positionY, row));
  put(t.fromZ, row, get(c.positionZ, row));
}

// Round bodies against half-spaces that are solid where n.x < offset (2D and 3D). The formulas are in impact.ts.
import { Columns, columns, get, put } from '../../memory/columns';
import { applyWallFriction, timeOfImpulse } from '../friction';
import { MAX_DEPTH, RESTS, noteImpact, noteVector } from '../impact-list';
import { WALL_MARGIN, contactTable, word } from '../table';
import { LANES, add, at, mul, splat, sub } from '../../memory/lanes';
import { computeReboundDistance, computeImpactSpeed, computeTimeSinceImpact } from './impact';
import { recordNearWall, recordWallContact } from './record';

// Addresses of the columns of the planes, written by src/particle-contacts/plane-walls.ts.
@unmanaged
export class PlaneColumns {
  nx: usize;
  ny: usize;
  nz: usize;
  offset: usize;
  restitution: usize;
  friction: usize;
  // Velocities at the start of the step.
  startX: usize;
  startY: usize;
  startZ: usize;
}

// Bodies are tested against the planes repeatedly, so that they do not leave a wedge of planes.
const MAX_ITERATIONS: i32 = 4;

// Bounces rows [first, last) off the planes `ids` (ascending).
export function planeWalls(planes: usize, ids: usize, count: i32, dt: real, lag: real, first: i32, last: i32): void {
  const p = changetype<PlaneColumns>(planes);
  const c = columns();
  for (let row = first; row < last; row += LANES) {
    for (let sweep = 0; sweep < MAX_ITERATIONS; sweep++) {
      let any = false;
      for (let k = 0; k < count; k++) {
        const id = word(ids, k);
        if (!comesNear(p, c, row, id, 1)) continue;
        for (let body = row; body < row + LANES; body++) {
          any = bounce(p, c, body, id, dt, lag) || any;
        }
      }
      if (!any) break;
    }
    if (c.contacts != 0) recordNearWalls(p, c, row, ids, count);
  }
}

// Records the bodies of the vector at `row` that are near a plane but not beyond it.
function recordNearWalls(p: PlaneColumns, c: Columns, row: i32, ids: usize, count: i32): void {
  for (let k = 0; k < count; k++) {
    const id = word(ids, k);
    if (!comesNear(p, c, row, id, WALL_MARGIN)) continue;
    const nx = get(p.nx, id);
    const ny = get(p.ny, id);
    const nz = get(p.nz, id);
    for (let body = row; body < row + LANES; body++) {
      const radius = get(c.radius, body);
      const height = get(c.positionX, body) * nx + get(c.positionY, body) * ny + get(c.positionZ, body) * nz;
      const gap = height - get(p.offset, id) - radius;
      if (!(gap < (WALL_MARGIN - <real>1) * radius && get(c.mass, body) > 0)) continue;
      recordNearWall(body, id, nx, ny, nz, sqrt<real>(get(c.friction, body) * get(p.friction, id)), gap);
    }
  }
}

// Returns whether any body of the vector at `row` intersects the plane, with its radius scaled by `reach`.
// @ts-ignore: decorator
@inline function comesNear(p: PlaneColumns, c: Columns, row: i32, id: i32, reach: real): bool {
  const o = at(row);
  const height = add(
    add(mul(v128.load(c.positionX + o), splat(get(p.nx, id))), mul(v128.load(c.positionY + o), splat(get(p.ny, id)))),
    mul(v128.load(c.positionZ + o), splat(get(p.nz, id))),
  );
  const radius = v128.load(c.radius + o);
  const behind = v128.lt<real>(sub(height, mul(radius, splat(reach))), splat(get(p.offset, id)));
  const solid = v128.and(v128.gt<real>(radius, splat(0)), v128.gt<real>(v128.load(c.mass + o), splat(0)));
  return v128.any_true(v128.and(behind, solid));
}

// @ts-ignore: decorator
@inline function isUneven(c: Columns): bool {
  return c.contacts != 0 && contactTable().isUneven != 0;
}

function bounce(p: PlaneColumns, c: Columns, row: i32, id: i32, dt: real, lag: real): bool {
  const radius = get(c.radius, row);
  const mass = get(c.mass, row);
  const nx = get(p.nx, id);
  const ny = get(p.ny, id);
  const nz = get(p.nz, id);
  const height = get(c.positionX, row) * nx + get(c.positionY, row) * ny + get(c.positionZ, row) * nz;
  const depth = get(p.offset, id) + radius - height;
  if (!(depth > 0 && radius > 0 && mass > 0)) return false;
  const vx = get(c.velocityX, row);
  const vy = get(c.velocityY, row);
  const vz = get(c.velocityZ, row);
  const intoWall = -(vx * nx + vy * ny + vz * nz);
  const startSpeed = get(p.startX, row) * nx + get(p.startY, row) * ny + get(p.startZ, row) * nz;
  const acceleration = (startSpeed + intoWall) / dt;
  const speed = intoWall + acceleration * lag;
  if (!(speed > 0)) {
    // A body that contacts pushed behind the plane and that returns within the step is left alone.
    if (depth <= -intoWall * dt) return false;
    shift(c, row, nx, ny, nz, depth);
    return true;
  }
  const timeSinceImpact = computeTimeSinceImpact<real>(depth, speed, acceleration, dt);
  const impact = computeImpactSpeed<real>(speed, acceleration, timeSinceImpact);
  const restitution = max<real>(get(c.restitution, row), get(p.restitution, id));
  const reboundSpeed = restitution * impact;
  const reboundDistance = computeReboundDistance<real>(reboundSpeed, acceleration, timeSinceImpact, 0.5);
  const rebounds = reboundDistance > 0 && impact > 0;
  const e = rebounds ? restitution : RESTS;
  // As in impacts.ts: under forces that depend on position or velocity an elastic impact acts at the end of the step.
  const isLate = e >= 1 && depth <= MAX_DEPTH * radius && isUneven(c);
  const outgoing = isLate ? e * speed + acceleration * lag : reboundSpeed - acceleration * (timeSinceImpact - lag);
  const change = rebounds ? outgoing + intoWall : max<real>(0, intoWall);
  const out = isLate ? <real>0 : rebounds ? depth + reboundDistance : depth;
  shift(c, row, nx, ny, nz, out);
  const startChange = rebounds ? change : -startSpeed;
  put(p.startX, row, get(p.startX, row) + startChange * nx);
  put(p.startY, row, get(p.startY, row) + startChange * ny);
  put(p.startZ, row, get(p.startZ, row) + startChange * nz);
  put(c.velocityX, row, vx + change * nx);
  put(c.velocityY, row, vy + change * ny);
  put(c.velocityZ, row, vz + change * nz);
  const friction = sqrt<real>(get(c.friction, row) * get(p.friction, id));
  const note = c.contacts == 0 ? <usize>0 : noteImpact(contactTable(), row, id, e, timeSinceImpact);
  const moved = applyWallFriction(c, row, nx, ny, nz, friction, change * mass, timeOfImpulse(out, change, dt));
  shift(c, row, moved.x, moved.y, moved.z, 1);
  if (note != 0) {
    const bx = get(c.velocityX, row) - vx - change * nx;
    const by = get(c.velocityY, row) - vy - change * ny;
    const bz = get(c.velocityZ, row) - vz - change * nz;
    const sx = get(p.startX, row) - startChange * nx;
    const sy = get(p.startY, row) - startChange * ny;
    const sz = get(p.startZ, row) - startChange * nz;
    store<real>(noteVector(noteVector(noteVector(note, bx, by, bz), nx, ny, nz), sx, sy, sz), height + depth);
  }
  recordWallContact(row, id, nx, ny, nz, friction, impact, change * mass, rebounds ? <real>0 : change * mass);
  return true;
}

// @ts-ignore: decorator
@inline function shift(c: Columns, row: i32, nx: real, ny: real, nz: real, by: real): void {
  put(c.positionX, row, get(c.positionX, row) + by * nx);
  put(c.positionY, row, get(c.positionY, row) + by * ny);
  put(c.positionZ, row, get(c.positionZ, row) + by * nz);
}

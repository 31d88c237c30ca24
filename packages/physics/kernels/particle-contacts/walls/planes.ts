// Round bodies against half-spaces: solid where n.x < offset (2D and 3D). kernels/particle-contacts/walls/impact.ts has the formula.
import { Columns, columns, get, put } from '../../memory/columns';
import { rubWall } from '../friction';
import { WALL_REACH, word } from '../table';
import { LANES, add, at, mul, splat, sub } from '../../memory/lanes';
import { distanceOut, impactSpeed, timeSince } from './impact';
import { recordNearWall, recordWallContact } from './record';

// Where the planes' columns are; src/particle-contacts/plane-walls.ts fills it.
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

// Bodies are put against the planes this often, so that a wedge of planes lets none through.
const MOST_SWEEPS: i32 = 4;

// Bounces rows [first, last) off the planes `ids`, ascending.
export function planeWalls(planes: usize, ids: usize, count: i32, dt: real, lag: real, first: i32, last: i32): void {
  const p = changetype<PlaneColumns>(planes);
  const c = columns();
  for (let row = first; row < last; row += LANES) {
    for (let sweep = 0; sweep < MOST_SWEEPS; sweep++) {
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
    if (c.contacts != 0) noteNear(p, c, row, ids, count);
  }
}

// Records the bodies from `row` that are near a plane without being beyond it.
function noteNear(p: PlaneColumns, c: Columns, row: i32, ids: usize, count: i32): void {
  for (let k = 0; k < count; k++) {
    const id = word(ids, k);
    if (!comesNear(p, c, row, id, WALL_REACH)) continue;
    const nx = get(p.nx, id);
    const ny = get(p.ny, id);
    const nz = get(p.nz, id);
    for (let body = row; body < row + LANES; body++) {
      const radius = get(c.radius, body);
      const height = get(c.positionX, body) * nx + get(c.positionY, body) * ny + get(c.positionZ, body) * nz;
      const gap = height - get(p.offset, id) - radius;
      if (!(gap < (WALL_REACH - <real>1) * radius && get(c.mass, body) > 0)) continue;
      recordNearWall(body, id, nx, ny, nz, sqrt<real>(get(c.friction, body) * get(p.friction, id)), gap);
    }
  }
}

// Whether any of the bodies from `row`, `reach` times as large, reaches behind the plane.
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
  const into = -(vx * nx + vy * ny + vz * nz);
  const began = get(p.startX, row) * nx + get(p.startY, row) * ny + get(p.startZ, row) * nz;
  const pull = (began + into) / dt;
  const speed = into + pull * lag;
  if (!(speed > 0)) {
    // What contacts pushed behind the plane and is on its way back within the step needs no help.
    if (depth <= -into * dt) return false;
    shift(c, row, nx, ny, nz, depth);
    return true;
  }
  const since = timeSince<real>(depth, speed, pull, dt);
  const impact = impactSpeed<real>(speed, pull, since);
  const leave = max<real>(get(c.restitution, row), get(p.restitution, id)) * impact;
  const out = distanceOut<real>(leave, pull, since, 0.5);
  const flies = out > 0 && impact > 0;
  const change = flies ? leave - pull * (since - lag) + into : max<real>(0, into);
  shift(c, row, nx, ny, nz, flies ? depth + out : depth);
  const start = flies ? change : -began;
  put(p.startX, row, get(p.startX, row) + start * nx);
  put(p.startY, row, get(p.startY, row) + start * ny);
  put(p.startZ, row, get(p.startZ, row) + start * nz);
  put(c.velocityX, row, vx + change * nx);
  put(c.velocityY, row, vy + change * ny);
  put(c.velocityZ, row, vz + change * nz);
  const friction = sqrt<real>(get(c.friction, row) * get(p.friction, id));
  rubWall(c, row, nx, ny, nz, friction, change * mass);
  recordWallContact(row, id, nx, ny, nz, friction, change * mass, flies ? <real>0 : change * mass);
  return true;
}

// @ts-ignore: decorator
@inline function shift(c: Columns, row: i32, nx: real, ny: real, nz: real, by: real): void {
  put(c.positionX, row, get(c.positionX, row) + by * nx);
  put(c.positionY, row, get(c.positionY, row) + by * ny);
  put(c.positionZ, row, get(c.positionZ, row) + by * nz);
}

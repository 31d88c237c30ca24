// Quad strips of a sheet: n quads between two rows of consecutive nodes, top t, t + 1, ... and bottom b, b + 1, ...
// First come the upper triangles (t + i, b + i, t + i + 1), then as many lower ones (t + i + 1, b + i, b + i + 1).
// Both triangles of a quad are processed together, so each node is read and written only once per side of the strip.
import { columns } from '../memory/columns';
import { LANES, add, at, splat, sub } from '../memory/lanes';
import { computeWindForce, windState } from './wind-force';
import { corner } from './faces';
import { word } from '../xpbd/table';

// Tests whether all nodes of a strip still live.
export function isStripAlive(faces: usize, count: i32, first: i32, last: i32, generations: usize): bool {
  const quads = (last - first) >> 1;
  const expectedGenerations = faces + ((<usize>count * 3) << 2);
  for (let k = 0; k < 2; k++) {
    const row = expectedGenerations + ((<usize>(k * count + first)) << 2);
    if (!areEqual(row, generations + ((<usize>corner(faces, count, first, k)) << 2), quads)) return false;
  }
  return (
    isThirdAlive(faces, count, first + quads - 1, generations) && isThirdAlive(faces, count, last - 1, generations)
  );
}

function areEqual(words: usize, others: usize, count: i32): bool {
  let i = 0;
  for (; i + 4 <= count; i += 4) {
    const o = (<usize>i) << 2;
    if (v128.any_true(v128.xor(v128.load(words + o), v128.load(others + o)))) return false;
  }
  for (; i < count; i++) if (word(words, i) != word(others, i)) return false;
  return true;
}

// Tests whether the third corner of a face still lives.
// @ts-ignore: decorator
@inline function isThirdAlive(faces: usize, count: i32, face: i32, generations: usize): bool {
  return word(generations, corner(faces, count, face, 2)) == corner(faces, count, face, 5);
}

// Returns the mask of the lanes that are below `count`, and thus belong to the strip.
// @ts-ignore: decorator
@inline function laneMask(count: i32): v128 {
  if (sizeof<real>() == 8) return i64x2.gt_s(i64x2.splat(count), i64x2(0, 1));
  return i32x4.gt_s(i32x4.splat(count), i32x4(0, 1, 2, 3));
}

// Shifts values by one quad: the last of the previous vector, then all but the last of the current one.
// @ts-ignore: decorator
@inline function shiftByOne(previous: v128, current: v128): v128 {
  if (sizeof<real>() == 8) return v128.shuffle<i64>(previous, current, 1, 2);
  return v128.shuffle<i32>(previous, current, 3, 4, 5, 6);
}

// Adds the forces of the quads on both sides of the nodes.
// @ts-ignore: decorator
@inline function addForces(force: usize, a: v128, b: v128): void {
  v128.store(force, add(v128.load(force), add(a, b)));
}

// Adds one axis of the forces on the quads to the nodes on both sides of the strip. `upper` and `under` are the forces
// on the two triangles of the current quads; `both` and `lower` are, of the previous quads, the sum of both triangles
// and the force on the lower triangle.
// @ts-ignore: decorator
@inline function addForcesAxis(top: usize, bottom: usize, upper: v128, under: v128, both: v128, lower: v128): void {
  const sum = add(upper, under);
  addForces(top, upper, shiftByOne(both, sum));
  addForces(bottom, sum, shiftByOne(lower, under));
}

// Computes the wind force on triangles with corners p, q and r; v is the sum of the velocities of the corners.
// @ts-ignore: decorator
@inline function computeTriangleWindForce(
  px: v128,
  py: v128,
  pz: v128,
  qx: v128,
  qy: v128,
  qz: v128,
  rx: v128,
  ry: v128,
  rz: v128,
  vx: v128,
  vy: v128,
  vz: v128,
): void {
  computeWindForce(sub(qx, px), sub(qy, py), sub(qz, pz), sub(rx, px), sub(ry, py), sub(rz, pz), vx, vy, vz);
}

// Adds the wind forces on a strip to its nodes.
export function addWindToStrip(faces: usize, count: i32, first: i32, last: i32, fx: usize, fy: usize, fz: usize): void {
  const quads = (last - first) >> 1;
  let t = at(corner(faces, count, first, 0));
  let b = at(corner(faces, count, first, 1));
  const c = columns();
  const one = sizeof<real>();
  const x = c.positionX;
  const y = c.positionY;
  const z = c.positionZ;
  const vx = c.velocityX;
  const vy = c.velocityY;
  const vz = c.velocityZ;
  // The forces of the previous quads: of both triangles, and of the lower one.
  let bothX = splat(0);
  let bothY = splat(0);
  let bothZ = splat(0);
  let lowerX = splat(0);
  let lowerY = splat(0);
  let lowerZ = splat(0);
  // There is one node more than quads.
  for (let rest = quads; rest >= 0; rest -= LANES) {
    const mask = laneMask(rest);
    const qx = v128.load(x + t + one);
    const qy = v128.load(y + t + one);
    const qz = v128.load(z + t + one);
    const px = v128.load(x + t);
    const py = v128.load(y + t);
    const pz = v128.load(z + t);
    const rx = v128.load(x + b);
    const ry = v128.load(y + b);
    const rz = v128.load(z + b);
    // Velocities of the edge that both triangles share.
    const ux = add(v128.load(vx + t + one), v128.load(vx + b));
    const uy = add(v128.load(vy + t + one), v128.load(vy + b));
    const uz = add(v128.load(vz + t + one), v128.load(vz + b));
    const ax = add(ux, v128.load(vx + t));
    const ay = add(uy, v128.load(vy + t));
    const az = add(uz, v128.load(vz + t));
    computeTriangleWindForce(px, py, pz, rx, ry, rz, qx, qy, qz, ax, ay, az);
    const upperX = v128.and(windState.fx, mask);
    const upperY = v128.and(windState.fy, mask);
    const upperZ = v128.and(windState.fz, mask);
    const sx = v128.load(x + b + one);
    const sy = v128.load(y + b + one);
    const sz = v128.load(z + b + one);
    const bx = add(ux, v128.load(vx + b + one));
    const by = add(uy, v128.load(vy + b + one));
    const bz = add(uz, v128.load(vz + b + one));
    computeTriangleWindForce(qx, qy, qz, rx, ry, rz, sx, sy, sz, bx, by, bz);
    const underX = v128.and(windState.fx, mask);
    const underY = v128.and(windState.fy, mask);
    const underZ = v128.and(windState.fz, mask);
    addForcesAxis(fx + t, fx + b, upperX, underX, bothX, lowerX);
    addForcesAxis(fy + t, fy + b, upperY, underY, bothY, lowerY);
    addForcesAxis(fz + t, fz + b, upperZ, underZ, bothZ, lowerZ);
    bothX = add(upperX, underX);
    bothY = add(upperY, underY);
    bothZ = add(upperZ, underZ);
    lowerX = underX;
    lowerY = underY;
    lowerZ = underZ;
    t += 16;
    b += 16;
  }
}

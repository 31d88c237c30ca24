// Strips of a sheet: n meshes between two rows of nodes that follow each other, top t, t + 1, ... and bottom b, b + 1, ...
// First come their upper triangles (t + i, b + i, t + i + 1), then as many lower ones (t + i + 1, b + i, b + i + 1). Both
// of a mesh are looked at together: each node is read and pushed once for its side of the strip.
import { columns } from '../memory/columns';
import { LANES, add, at, splat, sub } from '../memory/lanes';
import { blow, breeze } from './blow';
import { corner } from './faces';
import { word } from '../xpbd/table';

// Whether all nodes of a strip still live.
export function isWholeStrip(faces: usize, count: i32, first: i32, last: i32, generations: usize): bool {
  const meshes = (last - first) >> 1;
  const lives = faces + ((<usize>count * 3) << 2);
  for (let k = 0; k < 2; k++) {
    const row = lives + ((<usize>(k * count + first)) << 2);
    if (!areAlike(row, generations + ((<usize>corner(faces, count, first, k)) << 2), meshes)) return false;
  }
  return isSame(faces, count, first + meshes - 1, generations) && isSame(faces, count, last - 1, generations);
}

function areAlike(words: usize, others: usize, count: i32): bool {
  let i = 0;
  for (; i + 4 <= count; i += 4) {
    const o = (<usize>i) << 2;
    if (v128.any_true(v128.xor(v128.load(words + o), v128.load(others + o)))) return false;
  }
  for (; i < count; i++) if (word(words, i) != word(others, i)) return false;
  return true;
}

// Whether the last corner of a face still lives.
// @ts-ignore: decorator
@inline function isSame(faces: usize, count: i32, face: i32, generations: usize): bool {
  return word(generations, corner(faces, count, face, 2)) == corner(faces, count, face, 5);
}

// Lanes whose mesh is one of the strip.
// @ts-ignore: decorator
@inline function lanesBelow(count: i32): v128 {
  if (sizeof<real>() == 8) return i64x2.gt_s(i64x2.splat(count), i64x2(0, 1));
  return i32x4.gt_s(i32x4.splat(count), i32x4(0, 1, 2, 3));
}

// The values of the meshes to the left: the last one before, and all but the last of these.
// @ts-ignore: decorator
@inline function left(earlier: v128, these: v128): v128 {
  if (sizeof<real>() == 8) return v128.shuffle<i64>(earlier, these, 1, 2);
  return v128.shuffle<i32>(earlier, these, 3, 4, 5, 6);
}

// Adds what the meshes to the right and to the left of nodes do to them.
// @ts-ignore: decorator
@inline function push(force: usize, a: v128, b: v128): void {
  v128.store(force, add(v128.load(force), add(a, b)));
}

// One axis of the forces of meshes on the nodes of both sides of the strip. The forces on the upper and on the lower
// triangle; of the meshes before, those on both together and on the lower one.
// @ts-ignore: decorator
@inline function pushAxis(top: usize, bottom: usize, upper: v128, under: v128, both: v128, lower: v128): void {
  const sum = add(upper, under);
  push(top, upper, left(both, sum));
  push(bottom, sum, left(lower, under));
}

// The wind on triangles with the corners p, q and r, and the sum v of their velocities.
// @ts-ignore: decorator
@inline function blowTriangle(
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
  blow(sub(qx, px), sub(qy, py), sub(qz, pz), sub(rx, px), sub(ry, py), sub(rz, pz), vx, vy, vz);
}

// The wind on a strip, added to the forces on its nodes.
export function blowStrip(faces: usize, count: i32, first: i32, last: i32, fx: usize, fy: usize, fz: usize): void {
  const meshes = (last - first) >> 1;
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
  // Of the meshes before: both triangles together, and the lower one.
  let bothX = splat(0);
  let bothY = splat(0);
  let bothZ = splat(0);
  let lowerX = splat(0);
  let lowerY = splat(0);
  let lowerZ = splat(0);
  // There is one node more than meshes.
  for (let rest = meshes; rest >= 0; rest -= LANES) {
    const is = lanesBelow(rest);
    const qx = v128.load(x + t + one);
    const qy = v128.load(y + t + one);
    const qz = v128.load(z + t + one);
    const px = v128.load(x + t);
    const py = v128.load(y + t);
    const pz = v128.load(z + t);
    const rx = v128.load(x + b);
    const ry = v128.load(y + b);
    const rz = v128.load(z + b);
    // Of the edge that both triangles share.
    const ux = add(v128.load(vx + t + one), v128.load(vx + b));
    const uy = add(v128.load(vy + t + one), v128.load(vy + b));
    const uz = add(v128.load(vz + t + one), v128.load(vz + b));
    const ax = add(ux, v128.load(vx + t));
    const ay = add(uy, v128.load(vy + t));
    const az = add(uz, v128.load(vz + t));
    blowTriangle(px, py, pz, rx, ry, rz, qx, qy, qz, ax, ay, az);
    const upperX = v128.and(breeze.fx, is);
    const upperY = v128.and(breeze.fy, is);
    const upperZ = v128.and(breeze.fz, is);
    const sx = v128.load(x + b + one);
    const sy = v128.load(y + b + one);
    const sz = v128.load(z + b + one);
    const bx = add(ux, v128.load(vx + b + one));
    const by = add(uy, v128.load(vy + b + one));
    const bz = add(uz, v128.load(vz + b + one));
    blowTriangle(qx, qy, qz, rx, ry, rz, sx, sy, sz, bx, by, bz);
    const underX = v128.and(breeze.fx, is);
    const underY = v128.and(breeze.fy, is);
    const underZ = v128.and(breeze.fz, is);
    pushAxis(fx + t, fx + b, upperX, underX, bothX, lowerX);
    pushAxis(fy + t, fy + b, upperY, underY, bothY, lowerY);
    pushAxis(fz + t, fz + b, upperZ, underZ, bothZ, lowerZ);
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

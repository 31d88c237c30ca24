// Parts of compound bodies: entities with a shape and an attachment, which move rigidly with their body. A part has a row of
// its own with box, pose and flags, so that the broad and the narrow phase treat it as any shape; masses, velocities, sleep
// and joints are those of its body.
//
//   x = X + R(Θ) x'      θ = Θ + θ'      x', θ': pose in the frame of the body, whose pose is X, Θ
import { Columns, columns, get, put } from '../../memory/columns';
import { computeSineCosine, cosine, sine, sineCosine } from '../../math/elementary';
import { shapeOf } from '../../collision/shapes/2d/shape-pool';
import { SHAPE_BYTES, Shape } from '../../collision/shapes/2d/shape';
import {
  ASLEEP,
  COLLIDES,
  COMPOUND,
  FAST,
  MAY_MOVE,
  MOVES,
  PART,
  ROUND,
  SHIFTED,
  STANDS,
  STATIC,
  flagsOf,
  poseOf,
  putFlags,
  putWord,
  word,
} from './body';
import { colliderFlags } from './collider-flags';
import { RigidTable } from './rigid-table';

const spare = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));

// The body that a shape belongs to: that of a part, or the row itself.
// @ts-ignore: decorator
@inline export function bodyOf(t: RigidTable, row: i32): i32 {
  const owner = word(t.owners, row);
  return owner == 0 ? row : owner;
}

// Lists the parts of each body, in ascending order, and marks their bodies.
export function linkParts(t: RigidTable): void {
  memory.fill(t.firstParts, 0, (<usize>t.rows) << 2);
  for (let i = t.partCount - 1; i >= 0; i--) {
    const row = word(t.partIds, i);
    const body = word(t.attachmentBody, row);
    if (!hasBody(t, row, body)) continue;
    putWord(t.nextParts, row, word(t.firstParts, body));
    putWord(t.firstParts, body, row);
    putFlags(t, body, flagsOf(t, body) | COMPOUND);
  }
}

// @ts-ignore: decorator
@inline function hasBody(t: RigidTable, row: i32, body: i32): bool {
  if (body <= 0 || body >= t.rows || (<u32>word(t.members, body) & t.attachmentBit) != 0) return false;
  return word(t.generations, body) == word(t.attachmentGeneration, row) && (flagsOf(t, body) & (MOVES | STATIC)) != 0;
}

// What a part is in this step: of the kind of its body, or 0 without a body or a shape.
export function kindOfPart(t: RigidTable, row: i32): u32 {
  const body = word(t.attachmentBody, row);
  const bits = <u32>word(t.members, row);
  if ((bits & 1) == 0 || (bits & t.colliderBit) == 0 || !hasBody(t, row, body)) return 0;
  return (flagsOf(t, body) & (MOVES | STATIC | MAY_MOVE)) | COLLIDES | PART | colliderFlags(t, row);
}

// Poses of the parts of bodies that are awake, and the extents of these bodies as far as their parts reach.
export function placeParts(t: RigidTable): void {
  for (let i = 0; i < t.partCount; i++) {
    const row = word(t.partIds, i);
    const flags = flagsOf(t, row);
    if ((flags & PART) == 0) continue;
    const body = word(t.owners, row);
    const kept = flagsOf(t, body) & (ASLEEP | FAST | SHIFTED | STANDS);
    putFlags(t, row, (flags & ~(ASLEEP | FAST)) | kept);
    if ((kept & ASLEEP) == 0) placePart(t, row, body);
  }
}

export function placePart(t: RigidTable, row: i32, body: i32): void {
  const owner = poseOf(t, body);
  const pose = poseOf(t, row);
  const x = get(t.attachmentX, row);
  const y = get(t.attachmentY, row);
  turnTo(<f64>get(t.attachmentAngle, row));
  const c = <real>sineCosine.cosine;
  const s = <real>sineCosine.sine;
  pose.x = owner.x + (owner.c * x - owner.s * y);
  pose.y = owner.y + (owner.s * x + owner.c * y);
  pose.c = owner.c * c - owner.s * s;
  pose.s = owner.s * c + owner.c * s;
  pose.inverseMass = 0;
  pose.inverseInertia = 0;
  const shape = shapeOf(row, spare);
  pose.extent = shape.extent;
  pose.minExtent = shape.minExtent;
  owner.extent = max<real>(owner.extent, sqrt<real>(x * x + y * y) + shape.extent);
  owner.minExtent = min<real>(owner.minExtent, shape.minExtent);
  putFlags(t, body, flagsOf(t, body) & ~ROUND);
}

// Sine and cosine of any angle.
// @ts-ignore: decorator
@inline export function turnTo(angle: f64): void {
  if (angle == 0) {
    sineCosine.cosine = 1;
    sineCosine.sine = angle;
    return;
  }
  if (abs<f64>(angle) < 1e6) return computeSineCosine(angle);
  sineCosine.cosine = cosine(angle);
  sineCosine.sine = sine(angle);
}

// Writes the poses of parts to their columns, for renderers and queries, from the columns of their bodies. With `all` 0 the
// parts of bodies that sleep are left out.
export function writeParts(table: usize, all: i32): void {
  const t = changetype<RigidTable>(table);
  const c = columns();
  for (let i = 0; i < t.partCount; i++) {
    const row = word(t.partIds, i);
    if (all == 0 && (flagsOf(t, row) & (PART | ASLEEP)) != PART) continue;
    writePart(c, t, row, word(t.attachmentBody, row));
  }
}

// @ts-ignore: decorator
@inline function writePart(c: Columns, t: RigidTable, row: i32, body: i32): void {
  const angle = get(t.angle, body);
  turnTo(<f64>angle);
  const cosine = <real>sineCosine.cosine;
  const sine = <real>sineCosine.sine;
  const x = get(t.attachmentX, row);
  const y = get(t.attachmentY, row);
  put(c.positionX, row, get(c.positionX, body) + (cosine * x - sine * y));
  put(c.positionY, row, get(c.positionY, body) + (sine * x + cosine * y));
  put(t.angle, row, angle + get(t.attachmentAngle, row));
}

// A compound is a bullet when one of its parts is.
export function isBullet(t: RigidTable, row: i32): bool {
  if (word(t.bullet, row) != 0) return true;
  for (let part = word(t.firstParts, row); part != 0; part = word(t.nextParts, part)) {
    if (word(t.bullet, part) != 0) return true;
  }
  return false;
}

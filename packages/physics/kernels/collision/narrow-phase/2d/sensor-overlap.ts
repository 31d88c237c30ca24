// Whether a sensor and another shape overlap. Nothing else happens between them.
import { WALL, flagsOf, poseOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { shapeAt } from '../../../solver/2d/walls';
import { SHAPE_BYTES, Shape } from '../../shapes/2d/shape';
import { Distance, closestPoints } from './distance';
import { RelativePose, setRelative } from './relative-pose';
import { DID_OVERLAP, FOUND, OVERLAPS, RigidContact, SENSES, SENSOR_IS_B } from './rigid-contact';

const nearest = changetype<Distance>(memory.data(offsetof<Distance>() + 8, 8));
const bInA = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));
const spareA = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const spareB = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));

// `isActive` is false when neither has moved.
export function updateSensor(t: RigidTable, contact: RigidContact, isActive: bool): void {
  const did = (contact.flags & OVERLAPS) != 0;
  const isKnown = !isActive && (contact.flags & FOUND) != 0;
  const overlaps = !isKnown ? shapesOverlap(t, contact.a, contact.b) : did;
  const kept = contact.flags & (SENSES | SENSOR_IS_B);
  contact.flags = kept | FOUND | (overlaps ? OVERLAPS : 0) | (did ? DID_OVERLAP : 0);
}

function shapesOverlap(t: RigidTable, first: i32, second: i32): bool {
  // A wall comes first.
  const isWall = (flagsOf(t, second) & WALL) != 0;
  const rowA = isWall ? second : first;
  const rowB = isWall ? first : second;
  const b = poseOf(t, rowB);
  setRelative(bInA, poseOf(t, rowA), b.x, b.y, b.c, b.s);
  const shapeA = shapeAt(t, rowA, spareA);
  const shapeB = shapeAt(t, rowB, spareB);
  closestPoints(nearest, shapeA, shapeB, bInA);
  return nearest.distance <= shapeA.radius + shapeB.radius;
}

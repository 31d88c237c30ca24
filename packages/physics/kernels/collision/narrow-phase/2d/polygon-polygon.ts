// Contact of two outlines with edges: polygons, capsules and segments in any combination. A capsule and a segment are
// outlines of two edges, back to back; two boxes have a faster test for their separation.
import { Shape } from '../../shapes/2d/shape';
import { clipEdges } from './clip-edges';
import { Manifold, toWorld } from './manifold';
import { RelativePose, invert, poseOfB } from './relative-pose';
import { greatestBoxSeparation, greatestSeparation, separatingEdge, separation } from './separating-axis';

const bInA = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));
const aInB = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

export function collidePolygons(m: Manifold, a: Shape, b: Shape): void {
  poseOfB(bInA, m);
  invert(aInB, bInA);
  const limit = a.radius + b.radius + m.speculative;
  const areBoxes = (a.isBox & b.isBox) != 0;
  if (areBoxes) greatestBoxSeparation(a, b, bInA);
  else greatestSeparation(a, b, bInA, limit);
  const fromA = separation;
  const edgeA = separatingEdge;
  if (fromA > limit) return;
  if (areBoxes) greatestBoxSeparation(b, a, aInB);
  else greatestSeparation(b, a, aInB, limit);
  const fromB = separation;
  if (fromB > limit) return;
  const isFlipped = fromB > fromA;
  if (isFlipped) clipEdges(m, b, a, separatingEdge, fromB, aInB, true);
  else clipEdges(m, a, b, edgeA, fromA, bInA, false);
  toWorld(m, isFlipped);
}

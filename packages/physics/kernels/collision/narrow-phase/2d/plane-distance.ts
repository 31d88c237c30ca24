// The distance of a half-plane from an outline without its rounding, for the time of impact.
import { Shape, vertexX, vertexY } from '../../shapes/2d/shape';
import { Distance } from './distance';
import { distanceOf, lowestVertex } from './plane-outline';
import { RelativePose, pointX, pointY } from './relative-pose';

// As `closestPoints`, with the half-plane as the first shape.
export function planeDistance(result: Distance, plane: Shape, outline: Shape, pose: RelativePose): void {
  const i = lowestVertex(plane, outline, pose);
  const distance = distanceOf(plane, outline, pose, i);
  const isApart = distance > 0;
  result.vertexA = 0;
  result.vertexB = i;
  result.distance = isApart ? distance : <real>0;
  result.nx = isApart ? plane.nx0 : <real>0;
  result.ny = isApart ? plane.ny0 : <real>0;
  result.bx = pointX(pose, vertexX(outline, i), vertexY(outline, i));
  result.by = pointY(pose, vertexX(outline, i), vertexY(outline, i));
  result.ax = result.bx - distance * plane.nx0;
  result.ay = result.by - distance * plane.ny0;
}

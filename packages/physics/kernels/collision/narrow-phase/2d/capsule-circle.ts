// Contact of a capsule or a segment with a disc, in the frame of the former: (x, y) is the centre of the disc. A centre
// on the axis is pushed out sideways.
import { Shape, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { Manifold, addRoundedPoint, setNormal } from './manifold';

export function collideCapsuleCircle(m: Manifold, capsule: Shape, circle: Shape, x: real, y: real): void {
  const startX = vertexX(capsule, 0);
  const startY = vertexY(capsule, 0);
  const edgeX = vertexX(capsule, 1) - startX;
  const edgeY = vertexY(capsule, 1) - startY;
  const along = (x - startX) * edgeX + (y - startY) * edgeY;
  const fraction = min<real>(max<real>(along / (edgeX * edgeX + edgeY * edgeY), 0), 1);
  const nearX = startX + fraction * edgeX;
  const nearY = startY + fraction * edgeY;
  const dx = x - nearX;
  const dy = y - nearY;
  const distance = sqrt<real>(dx * dx + dy * dy);
  if (distance > 0) setNormal(m, dx / distance, dy / distance);
  else setNormal(m, normalX(capsule, 0), normalY(capsule, 0));
  addRoundedPoint(m, nearX, nearY, distance, capsule, circle, 0);
}

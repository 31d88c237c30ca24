// Contact of a polygon with a disc, in the frame of the polygon: (x, y) is the centre of the disc. A centre inside is
// pushed out through the nearest edge.
import { Shape, nextVertex, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { Manifold, addRoundedPoint, setNormal } from './manifold';

export function collidePolygonCircle(m: Manifold, polygon: Shape, circle: Shape, x: real, y: real): void {
  const limit = polygon.radius + circle.radius + m.speculative;
  let separation = -(<real>Infinity);
  let edge = 0;
  for (let i = 0; i < polygon.count; i++) {
    const nx = normalX(polygon, i);
    const ny = normalY(polygon, i);
    const distance = nx * (x - vertexX(polygon, i)) + ny * (y - vertexY(polygon, i));
    if (distance > limit) return;
    if (distance > separation) {
      separation = distance;
      edge = i;
    }
  }
  const end = nextVertex(polygon, edge);
  if (separation > 0) {
    // Beyond the ends of the edge the nearest point is a corner.
    const edgeX = vertexX(polygon, end) - vertexX(polygon, edge);
    const edgeY = vertexY(polygon, end) - vertexY(polygon, edge);
    const fromStart = (x - vertexX(polygon, edge)) * edgeX + (y - vertexY(polygon, edge)) * edgeY;
    const fromEnd = (x - vertexX(polygon, end)) * edgeX + (y - vertexY(polygon, end)) * edgeY;
    if (fromStart < 0 || fromEnd > 0) {
      meetCorner(m, polygon, circle, fromStart < 0 ? edge : end, x, y);
      return;
    }
  }
  const nx = normalX(polygon, edge);
  const ny = normalY(polygon, edge);
  setNormal(m, nx, ny);
  addRoundedPoint(m, x - separation * nx, y - separation * ny, separation, polygon, circle, 0);
}

function meetCorner(m: Manifold, polygon: Shape, circle: Shape, corner: i32, x: real, y: real): void {
  const cornerX = vertexX(polygon, corner);
  const cornerY = vertexY(polygon, corner);
  const dx = x - cornerX;
  const dy = y - cornerY;
  const distance = sqrt<real>(dx * dx + dy * dy);
  setNormal(m, dx / distance, dy / distance);
  addRoundedPoint(m, cornerX, cornerY, distance, polygon, circle, 0);
}

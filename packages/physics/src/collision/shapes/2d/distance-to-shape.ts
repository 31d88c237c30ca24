import { lengthOf, type Shape } from './shape.ts';

/** Distance of a point, given in the frame of a shape, from the shape, m; 0 inside. */
export function distanceToShape({ vertices, normals, radius }: Shape, x: number, y: number): number {
  let nearest = Infinity;
  let isInside = vertices.length > 4;
  for (let i = 0; i < vertices.length; i += 2) {
    const next = (i + 2) % vertices.length;
    const [fromX, fromY] = [x - vertices[i], y - vertices[i + 1]];
    const [edgeX, edgeY] = [vertices[next] - vertices[i], vertices[next + 1] - vertices[i + 1]];
    const square = edgeX * edgeX + edgeY * edgeY;
    const along = square > 0 ? Math.min(1, Math.max(0, (fromX * edgeX + fromY * edgeY) / square)) : 0;
    nearest = Math.min(nearest, lengthOf(fromX - along * edgeX, fromY - along * edgeY));
    isInside &&= fromX * normals[i] + fromY * normals[i + 1] <= 0;
  }
  return isInside ? 0 : Math.max(0, nearest - radius);
}

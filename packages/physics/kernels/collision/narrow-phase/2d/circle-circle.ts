// Contact of two discs, in the frame of the first: (x, y) is the centre of the second. Two discs with one centre get the
// normal (0, 1).
import { Shape } from '../../shapes/2d/shape';
import { Manifold, addRoundedPoint, setNormal } from './manifold';

// @ts-ignore: decorator
@inline export function collideCircles(m: Manifold, a: Shape, b: Shape, x: real, y: real): void {
  const distance = sqrt<real>(x * x + y * y);
  const isApart = distance > 0;
  setNormal(m, isApart ? x / distance : <real>0, isApart ? y / distance : <real>1);
  addRoundedPoint(m, 0, 0, distance, a, b, 0);
}

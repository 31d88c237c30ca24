import { expect, it } from 'vitest';
import { cross, cubeEdges, dot, globeLines, normOf, point, product, rotate, rotationAbout } from './space.ts';

const [X, Y, Z] = [point(1, 0, 0), point(0, 1, 0), point(0, 0, 1)];

it('rotates by quaternions as by angle and axis', () => {
  const turned = rotate(rotationAbout(point(0, 0, 2), Math.PI / 2), X);
  for (const axis of ['x', 'y', 'z'] as const) expect(turned[axis]).toBeCloseTo(Y[axis], 15);
  // First about x, then about y: z goes to -y and stays there.
  const both = product(rotationAbout(Y, Math.PI / 2), rotationAbout(X, Math.PI / 2));
  expect(rotate(both, Z).y).toBeCloseTo(-1, 15);
  expect(normOf(both)).toBeCloseTo(1, 15);
});

it('has a cross product at right angles to both', () => {
  expect(cross(X, Y)).toEqual(Z);
  const [a, b] = [point(1, 2, 3), point(-2, 5, 0.5)];
  expect(dot(cross(a, b), a)).toBeCloseTo(0, 14);
  expect(dot(cross(a, b), b)).toBeCloseTo(0, 14);
});

it('draws a cube of twelve edges, and a globe', () => {
  expect(cubeEdges(1, (p) => p, 0)).toHaveLength(12);
  expect(globeLines(1, (p) => p, 0)).toHaveLength(24 + 6 * 12);
});

import { expect, it } from 'vitest';
import { apply, determinant, difference, multiply, orthogonalityError, rotationMatrix } from './matrix.ts';
import { point, rotate, rotationAbout } from './space.ts';

it('rotates as quaternions do', () => {
  const v = point(0.3, -1.2, 2);
  const axes = { x: point(1, 0, 0), y: point(0, 1, 0), z: point(0, 0, 1) };
  for (const axis of ['x', 'y', 'z'] as const) {
    const [a, b] = [apply(rotationMatrix(axis, 0.7), v), rotate(rotationAbout(axes[axis], 0.7), v)];
    for (const part of ['x', 'y', 'z'] as const) expect(a[part]).toBeCloseTo(b[part], 14);
  }
});

it('has inverses, and products that depend on the order', () => {
  const [a, b] = [rotationMatrix('x', 1), rotationMatrix('y', 2)];
  expect(determinant(multiply(a, b))).toBeCloseTo(1, 14);
  expect(orthogonalityError(multiply(a, b))).toBeLessThan(1e-14);
  expect(difference(multiply(a, b), multiply(b, a))).toBeGreaterThan(0.5);
});

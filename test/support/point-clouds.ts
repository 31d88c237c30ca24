// Clouds of bodies of known shapes, and the direct sum as a reference for forces.
import { createRandom } from '../../packages/physics/src/math/random.ts';

export interface Cloud {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  readonly mass: Float64Array;
}

export type Shape = 'uniform' | 'plummer' | 'disc' | 'two clusters' | 'line' | 'one place';

export const SHAPES: readonly Shape[] = ['uniform', 'plummer', 'disc', 'two clusters', 'line', 'one place'];

/** `count` bodies of masses from 0.5 to 1.5, within a few metres of the origin. */
export function cloud(shape: Shape, count: number, dimensions: 2 | 3, seed = 1): Cloud {
  const random = createRandom(seed);
  const column = () => new Float64Array(count);
  const made = { x: column(), y: column(), z: column(), mass: column() };
  for (let i = 0; i < count; i++) {
    const p = pointOf(shape, i, random, dimensions);
    made.x[i] = p.x;
    made.y[i] = p.y;
    made.z[i] = dimensions === 3 ? p.z : 0;
    made.mass[i] = random.uniform(0.5, 1.5);
  }
  return made;
}

function pointOf(shape: Shape, i: number, random: ReturnType<typeof createRandom>, dimensions: 2 | 3) {
  const side = () => random.uniform(-1, 1);
  switch (shape) {
    case 'uniform':
      return { x: side(), y: side(), z: side() };
    case 'plummer':
      return plummerPoint(random, dimensions);
    case 'disc': {
      const p = random.onCircle(Math.sqrt(random.uniform()));
      return { ...p, z: 0.02 * side() };
    }
    case 'two clusters': {
      const p = plummerPoint(random, dimensions);
      const [x, y] = i % 2 === 0 ? [-2, 0] : [2, 1];
      return { x: x + 0.1 * p.x, y: y + 0.1 * p.y, z: 0.1 * p.z };
    }
    case 'line':
      return { x: side(), y: 0, z: 0 };
    case 'one place':
      return { x: 0.3, y: -0.7, z: 0.2 };
  }
}

/** Plummer, MNRAS 71, 460 (1911): the radius that holds a share m of the mass is 1/√(m^(-2/3) - 1). */
function plummerPoint(random: ReturnType<typeof createRandom>, dimensions: 2 | 3) {
  const share = random.uniform(1e-6, 0.97);
  const radius = 1 / Math.sqrt(share ** (-2 / 3) - 1);
  return dimensions === 3 ? random.onSphere(radius) : random.onCircle(radius);
}

/** The field at body `i`: Σ m d/(d² + ε²)^(3/2), or Σ m d/(d² + ε²) for `power` 1. */
export function fieldAt(
  { x, y, z, mass }: Cloud,
  i: number,
  power: 1 | 2 = 2,
  softening = 0,
): [number, number, number] {
  const [px, py, pz] = [x[i] as number, y[i] as number, z[i] as number];
  const sum: [number, number, number] = [0, 0, 0];
  for (let j = 0; j < x.length; j++) {
    const dx = (x[j] as number) - px;
    const dy = (y[j] as number) - py;
    const dz = (z[j] as number) - pz;
    const d2 = dx * dx + dy * dy + dz * dz;
    if (d2 === 0) continue;
    const u = d2 + softening * softening;
    const k = (mass[j] as number) / (power === 2 ? u * Math.sqrt(u) : u);
    sum[0] += k * dx;
    sum[1] += k * dy;
    sum[2] += k * dz;
  }
  return sum;
}

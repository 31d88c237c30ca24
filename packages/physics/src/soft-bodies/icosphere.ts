import { checkWhole } from '../errors/validate.ts';

/** Points on the unit sphere, three numbers each, and triangles seen counter-clockwise from outside. */
export interface Sphere {
  readonly points: number[];
  readonly faces: number[];
}

const GOLDEN = (1 + Math.sqrt(5)) / 2;

const CORNERS = [
  [-1, GOLDEN, 0],
  [1, GOLDEN, 0],
  [-1, -GOLDEN, 0],
  [1, -GOLDEN, 0],
  [0, -1, GOLDEN],
  [0, 1, GOLDEN],
  [0, -1, -GOLDEN],
  [0, 1, -GOLDEN],
  [GOLDEN, 0, -1],
  [GOLDEN, 0, 1],
  [-GOLDEN, 0, -1],
  [-GOLDEN, 0, 1],
];

const FACES = [
  0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3, 9, 4, 3, 4, 2, 3,
  2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1,
];

/** Returns an icosahedron whose edges are halved `divisions` times: 10·4^n + 2 points. @throws PhysicsError E_RANGE */
export function icosphere(divisions: number): Sphere {
  checkWhole(divisions, 'icosphere', 0, 6);
  const points: number[] = [];
  for (const [x, y, z] of CORNERS) addPoint(points, x, y, z);
  let faces = [...FACES];
  for (let n = 0; n < divisions; n++) faces = divide(points, faces);
  return { points, faces };
}

function addPoint(points: number[], x: number, y: number, z: number): number {
  const norm = Math.sqrt(x * x + y * y + z * z);
  return points.push(x / norm, y / norm, z / norm) / 3 - 1;
}

function divide(points: number[], faces: readonly number[]): number[] {
  const midpoints = new Map<string, number>();
  const midpointOf = (a: number, b: number) => {
    const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
    let found = midpoints.get(key);
    if (found === undefined) {
      const [x, y, z] = [0, 1, 2].map((axis) => points[3 * a + axis] + points[3 * b + axis]);
      found = addPoint(points, x, y, z);
      midpoints.set(key, found);
    }
    return found;
  };
  const divided: number[] = [];
  for (let f = 0; f < faces.length; f += 3) {
    const [a, b, c] = faces.slice(f, f + 3);
    const [ab, bc, ca] = [midpointOf(a, b), midpointOf(b, c), midpointOf(c, a)];
    divided.push(a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca);
  }
  return divided;
}

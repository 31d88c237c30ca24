/** Vectors of three numbers, for the few bodies of which this game computes more than the physics does. */

export interface Vector {
  x: number;
  y: number;
  z: number;
}

export const vector = (x = 0, y = 0, z = 0): Vector => ({ x, y, z });

export const difference = (a: Vector, b: Vector): Vector => vector(a.x - b.x, a.y - b.y, a.z - b.z);

export const dot = (a: Vector, b: Vector): number => a.x * b.x + a.y * b.y + a.z * b.z;

export const lengthOf = (a: Vector): number => Math.sqrt(dot(a, a));

export const cross = (a: Vector, b: Vector): Vector =>
  vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);

export const scaled = (a: Vector, factor: number): Vector => vector(factor * a.x, factor * a.y, factor * a.z);

/** a + factor b. */
export const sum = (a: Vector, b: Vector, factor = 1): Vector =>
  vector(a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z);

/** A vector of length one; zero for a vector without length. */
export const unit = (a: Vector): Vector => scaled(a, 1 / (lengthOf(a) || 1));

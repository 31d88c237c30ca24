// Mass and moment of inertia of the shapes of colliders: solid and of uniform density. Source: Feynman, Lectures on
// Physics I, table 19-1.
import { checkNumber, checkVector, type Vector, type VectorInput } from '../errors/validate.ts';

const POSITIVE = { above: 0, max: 1e38 };
const RADIUS = { above: 0, max: 1e12 };

/**
 * Moment of inertia of a disc about its axis, m r²/2, kg m².
 * @param mass kg
 * @param radius m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function discInertia(mass: number, radius: number): number {
  const r = checkNumber(radius, 'radius', RADIUS);
  return 0.5 * checkNumber(mass, 'mass', POSITIVE) * r * r;
}

/**
 * Moment of inertia of a ball about its centre, 2 m r²/5, kg m².
 * @param mass kg
 * @param radius m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function ballInertia(mass: number, radius: number): number {
  const r = checkNumber(radius, 'radius', RADIUS);
  return 0.4 * checkNumber(mass, 'mass', POSITIVE) * r * r;
}

/**
 * Mass of a disc, π r² density, kg.
 * @param density mass by area, kg/m²
 * @param radius m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function discMass(density: number, radius: number): number {
  const r = checkNumber(radius, 'radius', RADIUS);
  return Math.PI * r * r * checkNumber(density, 'density', POSITIVE);
}

/**
 * Mass of a ball, 4π r³/3 density, kg.
 * @param density mass by volume, kg/m³
 * @param radius m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function ballMass(density: number, radius: number): number {
  const r = checkNumber(radius, 'radius', RADIUS);
  return (4 / 3) * Math.PI * r * r * r * checkNumber(density, 'density', POSITIVE);
}

/**
 * Principal moments of inertia of a box about its centre, m (y² + z²)/12 about x and so on, kg m²: an InertiaTensor.
 * @param mass kg
 * @param size edges along the body's axes, m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function boxInertia(mass: number, size: VectorInput): Vector {
  const m = checkNumber(mass, 'mass', POSITIVE) / 12;
  const { x, y, z } = checkVector(size, 'size', { min: 0, max: 1e12 });
  return { x: m * (y * y + z * z), y: m * (x * x + z * z), z: m * (x * x + y * y) };
}

/**
 * Principal moments of inertia of a cylinder whose axis is z, about its centre, kg m²: m r²/2 about the axis,
 * m (3 r² + l²)/12 across it. A length of 0 makes a disc.
 * @param mass kg
 * @param radius m
 * @param length m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function cylinderInertia(mass: number, radius: number, length: number): Vector {
  const m = checkNumber(mass, 'mass', POSITIVE);
  const r = checkNumber(radius, 'radius', RADIUS);
  const l = checkNumber(length, 'length', { min: 0, max: 1e12 });
  const across = (m * (3 * r * r + l * l)) / 12;
  return { x: across, y: across, z: 0.5 * m * r * r };
}

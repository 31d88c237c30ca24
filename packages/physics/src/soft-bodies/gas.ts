// An ideal gas at constant temperature, enclosed by a closed surface of springs: it pushes every face outwards.
//
//   p = G / V        F_i = (p - p_a) ∂V/∂x_i        potential  U = -G ln(V / V_0) + p_a (V - V_0)
//
//   G = n R T  amount of gas times temperature, J    V  volume, m³; in 2D area times one metre of depth
//   p_a  pressure outside, Pa
//
// Boyle and Mariotte's law; the gas is in equilibrium throughout and has no mass. On a closed surface the forces are
// the exact gradient of the volume, so their sum and their torque are zero. A surface that is inverted (V <= 0) or
// lost a node exerts no force; the gas of one that lost all of them leaves world.forces. Explicit: steps must resolve
// the springs of the skin (ω_s, see springs), the body that breathes and the skin that wrinkles, and no step warns:
//
//   dt < 2/√(ω_s² + ω_b² + ω_w²)        ω_b² = p A²/(m V)        ω_w² = (p - p_a) s/m_1
//
//   A  surface, m²    m  mass of the body, kg    m_1  mass of a node, kg    s  length of an edge, m; in 2D 1 m, the depth
//
// A skin so soft that the gas swells it to some times its size swings back faster than that. Source: Matyka, Ollila:
// Pressure model of soft body simulation (2003). Cost: a few operations per face, twice per evaluation.

import { checkKeys, checkNumber, checkWhole } from '../errors/validate.ts';
import { log } from '../math/elementary.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { areGone, facesOf, stateOfFaces } from './faces.ts';
import { softBodyKernels } from './kernels.ts';

/** Options of `enclosedGas`. */
export interface GasOptions {
  /**
   * Entity ids of the corners of the faces: two per edge in 2D, three per triangle in 3D. The outside is to the
   * right of an edge or in front of a triangle.
   */
  readonly faces: ArrayLike<number>;
  /** 2: edges of a ring. 3: triangles of a surface. */
  readonly corners: 2 | 3;
  /** G = n R T, J. */
  readonly amount: number;
  /** Pressure outside, Pa; default 0. */
  readonly ambient?: number;
  /** Volume at which the potential is zero, m³; default 1. */
  readonly reference?: number;
}

/**
 * An ideal gas at constant temperature within a closed surface of springs, which pushes every face outwards: F = (G/V
 * - p_a) ∂V/∂x, N.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function enclosedGas(options: GasOptions): Force {
  checkKeys(options, 'enclosedGas', ['faces', 'corners', 'amount', 'ambient', 'reference']);
  const corners = checkWhole(options.corners, 'enclosedGas.corners', 2, 3) as 2 | 3;
  const amount = checkNumber(options.amount, 'enclosedGas.amount', { min: 0, max: 1e30 });
  const ambient = checkNumber(options.ambient ?? 0, 'enclosedGas.ambient', { min: 0, max: 1e30 });
  const reference = checkNumber(options.reference ?? 1, 'enclosedGas.reference', { above: 0 });
  const faces = facesOf(options.faces, corners, 'enclosedGas.faces');
  const volume = (world: PhysicsWorld) => {
    const { at, count } = faces.of(world);
    return softBodyKernels(world).enclosed(at, count, corners, world.internal.generations.byteOffset);
  };
  const gas: Force = {
    name: 'enclosed gas',
    equation: 'F = (G/V - p_a) ∂V/∂x',
    parameters: {
      amount: { unit: 'J', value: amount },
      ambient: { unit: 'Pa', value: ambient },
    },
    reads: ['Position'],
    local: false,
    readsOfOthers: [],
    prepare(world) {
      if (areGone(world, faces.of(world), corners)) world.internal.edits.deferred.push(() => removeForce(world, gas));
    },
    releaseMemory: faces.release,
    memory: stateOfFaces(faces, corners),
    accumulate(world) {
      const { at, count } = faces.of(world);
      const generations = world.internal.generations.byteOffset;
      const enclosedVolume = volume(world);
      if (!(enclosedVolume > 0)) return;
      const pressure = amount / enclosedVolume - ambient;
      const { x, y, z } = world.scratch.at.force;
      const kernels = softBodyKernels(world);
      if (corners === 2) kernels.inflateEdges(at, count, x, y, pressure);
      else kernels.inflateTriangles(at, count, generations, x, y, z, pressure);
    },
    potential(world) {
      const enclosedVolume = volume(world);
      return enclosedVolume > 0 ? ambient * (enclosedVolume - reference) - amount * log(enclosedVolume / reference) : 0;
    },
  };
  return gas;
}

/** Removes a force from the world, whose next step lets it give its memory back. */
function removeForce({ forces }: PhysicsWorld, force: Force): void {
  const index = forces.indexOf(force);
  if (index >= 0) forces.splice(index, 1);
}

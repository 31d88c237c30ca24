import { rotationKernels } from '../dynamics/rotation-kernels.ts';
import { assertUsable } from '../ecs/guards.ts';
import { checkVector, isRecord, mustBe, type Vector, type VectorInput } from '../errors/validate.ts';
import { AXES } from '../memory/axes.ts';
import type { AxisAddresses } from '../memory/columns.ts';
import type { GlobalSystem, PhysicsWorld } from '../world/types.ts';

/** Energies, J. */
export interface Energy {
  readonly kinetic: number;
  /** Sum over every force with a potential, and the springs of joints. */
  readonly potential: number;
  readonly total: number;
}

/** The same type, writable. */
type Writable<T> = { -readonly [Key in keyof T]: T[Key] };

/**
 * Returns the kinetic energy of translation and rotation, and the potential energy of every conservative force and of the
 * springs of joints: ½ k s² for the stiffness k = m (2π f)² of the reduced mass, or inertia, m, and beyond `maxForce` that times
 * the way. Sums run in f64 over ascending ids. Bodies without mass do not contribute, nor do `motorJoint` and `mouseJoint`,
 * which drive a body and have no potential.
 * @param out written and returned: a reusable object, for calls in every frame
 * @throws PhysicsError E_DESTROYED
 */
export function energy(world: PhysicsWorld, out: Writable<Energy> = { kinetic: 0, potential: 0, total: 0 }): Energy {
  assertUsable(world);
  if (!isRecord(out) || Object.isFrozen(out)) throw mustBe('an object that can be written to', out, 'energy: out');
  const { forces } = world;
  out.kinetic = kineticEnergy(world);
  out.potential = 0;
  for (let f = 0; f < forces.length; f++) out.potential += forces[f].potential?.(world) ?? 0;
  for (const system of world.phases.finish) out.potential += (system as GlobalSystem).potential?.(world) ?? 0;
  out.total = out.kinetic + out.potential;
  return out;
}

function kineticEnergy(world: PhysicsWorld): number {
  const { kernels, addresses } = world;
  const { Mass, Velocity, Inertia, AngularVelocity } = addresses;
  const rows = world.lastId + 1;
  let sum = 0;
  for (let a = 0; a < 3; a++) {
    const axis = AXES[3][a];
    sum += kernels.kineticAxis(Mass.value, Velocity[axis], 0, rows);
    if (!hasTensors(world)) sum += kernels.kineticAxis(Inertia.value, AngularVelocity[axis], 0, rows);
  }
  return hasTensors(world) ? sum + rotationKernels(world).spinEnergy(0, rows) : sum;
}

/** Bodies with an InertiaTensor take a slower sum, which other worlds are spared. */
function hasTensors({ internal }: PhysicsWorld): boolean {
  return internal.counts.InertiaTensor > 0;
}

/** Total momentum, kg m/s. @throws PhysicsError E_DESTROYED */
export function momentum(world: PhysicsWorld): Vector {
  assertUsable(world);
  return massTimes(world, world.addresses.Velocity);
}

/** The sum of m u over the bodies, for a vector u per body. */
function massTimes({ kernels, addresses, lastId }: PhysicsWorld, u: AxisAddresses): Vector {
  const along = (axis: 'x' | 'y' | 'z') => kernels.dotColumns(addresses.Mass.value, u[axis], 0, lastId + 1);
  return { x: along('x'), y: along('y'), z: along('z') };
}

/** Total mass, kg. @throws PhysicsError E_DESTROYED */
export function totalMass(world: PhysicsWorld): number {
  assertUsable(world);
  return world.kernels.sumColumn(world.addresses.Mass.value, 0, world.lastId + 1);
}

/** Centre of mass, m; the origin if no body has mass. @throws PhysicsError E_DESTROYED */
export function centreOfMass(world: PhysicsWorld): Vector {
  const mass = totalMass(world);
  if (mass === 0) return { x: 0, y: 0, z: 0 };
  const { x, y, z } = massTimes(world, world.addresses.Position);
  return { x: x / mass, y: y / mass, z: z / mass };
}

/**
 * Total angular momentum about a point, orbital and spin, kg m²/s. In 2D only `z` is non-zero.
 * @param about metres; default the origin
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_DESTROYED
 */
export function angularMomentum(world: PhysicsWorld, about: VectorInput = {}): Vector {
  assertUsable(world);
  const { kernels, addresses } = world;
  const { Inertia, AngularVelocity: w } = addresses;
  const { x, y, z } = checkVector(about, 'angularMomentum: about');
  const rows = world.lastId + 1;
  const spin = (axis: 0 | 1 | 2) =>
    hasTensors(world)
      ? rotationKernels(world).spinMomentum(axis, 0, rows)
      : kernels.dotColumns(Inertia.value, w[AXES[3][axis]], 0, rows);
  return {
    x: kernels.angularMomentumAxis(0, y, z, 0, rows) + spin(0),
    y: kernels.angularMomentumAxis(1, z, x, 0, rows) + spin(1),
    z: kernels.angularMomentumAxis(2, x, y, 0, rows) + spin(2),
  };
}

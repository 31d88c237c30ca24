// What the laws of a fixed centre have in common: the centre, the coupling to mass or charge, and how they are called.
import { checkVector, type Vector, type VectorInput } from '../faults/validate';
import type { PhysicsWorld } from '../world';
import { PLACES, SPEEDS } from './bounds';
import type { Force, ForceParameter } from './force';
import { lawKernels } from './law-kernels';

/** Numbers of the laws, kernels/forces/central.ts. */
export const LAW = {
  uniformSphere: 0,
  powerLaw: 1,
  paczynskiWiita: 2,
  yukawa: 3,
  lennardJones: 4,
  vortex: 5,
  enclosedMass: 6,
} as const;

/** Where a centre is. */
export interface CentreOptions {
  /** Position at time 0, m; default the origin. */
  readonly centre?: VectorInput;
  /** Its velocity, m/s; default none. The field of a moving centre is not conservative. */
  readonly centreVelocity?: VectorInput;
}

export const CENTRE_KEYS = ['centre', 'centreVelocity'] as const;

/** Three numbers that say all about a law. */
export type LawParameters = readonly [p: number, q: number, s: number];

interface CentralLaw {
  readonly name: string;
  readonly equation: string;
  readonly law: number;
  readonly couplesTo: 'Mass' | 'Charge';
  readonly parameters: Readonly<Record<string, ForceParameter>>;
  values(world: PhysicsWorld): LawParameters;
}

/** The force of a law about a centre. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN for the centre */
export function centralForce(spec: CentralLaw, options: CentreOptions, caller: string): Force {
  const centre = checkVector(options.centre ?? {}, `${caller}.centre`, PLACES);
  const velocity = checkVector(options.centreVelocity ?? {}, `${caller}.centreVelocity`, SPEEDS);
  const { name, equation, law, couplesTo, values } = spec;
  const moves = velocity.x !== 0 || velocity.y !== 0 || velocity.z !== 0;
  const force: Force = {
    name,
    equation,
    parameters: spec.parameters,
    reads: ['Position', couplesTo],
    local: true,
    timeless: !moves,
    accumulate(world, first, last, time) {
      const [p, q, s] = values(world);
      const { x, y, z } = world.scratch.at.force;
      const coupling = world.addresses[couplesTo].value;
      const cx = centre.x + velocity.x * time;
      const cy = centre.y + velocity.y * time;
      const cz = depth(world, centre, velocity, time);
      lawKernels(world).centralForce(law, coupling, x, y, z, cx, cy, cz, p, q, s, first, last);
    },
  };
  if (moves) return force;
  return {
    ...force,
    potential(world) {
      const [p, q, s] = values(world);
      const cz = depth(world, centre, velocity, 0);
      const coupling = world.addresses[couplesTo].value;
      return lawKernels(world).centralPotential(law, coupling, centre.x, centre.y, cz, p, q, s, world.lastId + 1);
    },
  };
}

/** In the plane a centre has no depth. */
function depth(world: PhysicsWorld, centre: Vector, velocity: Vector, time: number): number {
  return world.dimensions === 3 ? centre.z + velocity.z * time : 0;
}

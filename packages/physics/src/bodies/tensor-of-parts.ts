// Mass properties of a solid that is put together from parts.
//
//   m = Σ mᵢ        c = Σ mᵢ rᵢ / m        I = Σ (Iᵢ + mᵢ (|dᵢ|² 1 - dᵢ dᵢᵀ)),  dᵢ = rᵢ - c
//
// Source: Goldstein, Classical Mechanics, section 5.3 (the parallel-axis theorem). Parts that overlap count twice there.
import { checkKeys, checkList, checkNumber, checkVector, type Vector, type VectorInput } from '../errors/validate.ts';
import type { TensorInput } from './principal-axes.ts';

/** A solid that is part of a body. */
export interface Solid {
  /** kg */
  readonly mass: number;
  /** Its centre of mass, m. Default: the origin. */
  readonly position?: VectorInput;
  /**
   * Moments of inertia about its own centre, in axes parallel to those of the body, kg m², as `boxInertia` returns
   * them. Default: that of a point, 0.
   */
  readonly inertia?: VectorInput;
}

/** Mass, centre of mass, and the tensor of inertia about it, which `principalAxes` takes. */
export interface SolidMass {
  readonly mass: number;
  readonly centre: Vector;
  readonly tensor: Required<TensorInput>;
}

const MOMENT = { min: 0, max: 1e38 };

/**
 * Mass, centre and tensor of inertia of parts together, by the parallel-axis theorem.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function tensorOfParts(parts: readonly Solid[]): SolidMass {
  checkList(parts ?? null, 'tensorOfParts: parts');
  const checked = parts.map((part, i) => {
    checkKeys(part, `parts[${i}]`, ['mass', 'position', 'inertia']);
    const { mass, position = {}, inertia = {} } = part;
    return {
      mass: checkNumber(mass, `parts[${i}].mass`, { above: 0, max: 1e38 }),
      at: checkVector(position, `parts[${i}].position`, { min: -1e12, max: 1e12 }),
      own: checkVector(inertia, `parts[${i}].inertia`, MOMENT),
    };
  });
  const mass = checkNumber(
    checked.reduce((sum, part) => sum + part.mass, 0),
    'tensorOfParts: the mass of all parts',
    { above: 0, max: 1e38 },
  );
  const mean = (axis: keyof Vector) => checked.reduce((sum, part) => sum + part.mass * part.at[axis], 0) / mass;
  const centre = { x: mean('x'), y: mean('y'), z: mean('z') };
  const tensor = { xx: 0, yy: 0, zz: 0, xy: 0, xz: 0, yz: 0 };
  for (const { mass: m, at, own } of checked) {
    const [x, y, z] = [at.x - centre.x, at.y - centre.y, at.z - centre.z];
    tensor.xx += own.x + m * (y * y + z * z);
    tensor.yy += own.y + m * (x * x + z * z);
    tensor.zz += own.z + m * (x * x + y * y);
    tensor.xy -= m * x * y;
    tensor.xz -= m * x * z;
    tensor.yz -= m * y * z;
  }
  return { mass, centre, tensor };
}

// A slope, floor or runway that bodies stand, slide and roll on: normal force and dry friction, without contacts.
//
//   normal   N = -F·n where that presses
//   sticking  f = (D + m u/dt)/(1 + m r²/I) against the driving force D and the slip u, as long as f ≤ μ_s N
//   slipping  f = μ_k N against u, and never more than stops it within the step
//
//   F  force of all laws listed before this one, N    n  unit normal out of the plane    D = F + N n  along the plane, N
//   u = v_t - r ω × n  slip of the point of contact when the step began, m/s    r  radius of the collider, m    I  moment of inertia, kg m²
//
// It answers the forces before it: list it last. N is what the other forces leave, so a lifting wing is lighter on the
// runway. A body with Inertia and AngularVelocity rolls, a (solid) ball down a slope with g sinθ/(1 + 2/5); one without
// is a block, 1/I = 0. Friction turns at rest into what holds: with μ_s = tanθ to the last digit it does not move.
// A body is on the plane when its surface is within `gap`, and leaves when the forces lift it. What arrives with a speed
// into the plane is not stopped: that is an impact, and the work of a wall.
// Coulomb (1785); Goldstein, Classical Mechanics, section 2.4 for rolling. Cost: one to three square roots a body.
import { bitOf } from '../components/all';
import { checkKeys, checkNumber, checkVector, type VectorInput } from '../faults/validate';
import { allocate } from '../store/arena';
import { resource } from '../store/resource';
import { PLACES } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { unit } from './lift';

export interface PlaneSupportOptions {
  /** A point of the plane, m; default the origin. */
  readonly point?: VectorInput;
  /** Normal out of it, of any length; default +y. */
  readonly normal?: VectorInput;
  /** μ_s; default the kinetic one. */
  readonly staticFriction?: number;
  /** μ_k; default 0. */
  readonly kineticFriction?: number;
  /** How far from the plane a body is still on it, m; default 10⁻³. */
  readonly gap?: number;
  /** Slip below which a body sticks, m/s; default 10⁻⁶. */
  readonly stickSpeed?: number;
}

const TURNS = bitOf('AngularVelocity');
const KEYS = ['point', 'normal', 'staticFriction', 'kineticFriction', 'gap', 'stickSpeed'] as const;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function planeSupport(options: PlaneSupportOptions = {}): Force {
  checkKeys(options, 'planeSupport', KEYS);
  const p = checkVector(options.point ?? {}, 'planeSupport.point', PLACES);
  const n = unit(checkVector(options.normal ?? { y: 1 }, 'planeSupport.normal', PLACES), 'planeSupport.normal');
  const coefficient = (key: 'staticFriction' | 'kineticFriction', byDefault: number) =>
    checkNumber(options[key] ?? byDefault, `planeSupport.${key}`, { min: 0, max: 100 });
  const kinetic = coefficient('kineticFriction', 0);
  const still = coefficient('staticFriction', kinetic);
  const gap = checkNumber(options.gap ?? 1e-3, 'planeSupport.gap', { min: 0, max: 1e12 });
  const stick = checkNumber(options.stickSpeed ?? 1e-6, 'planeSupport.stickSpeed', { min: 0, max: 1e6 });
  const values = [p.x, p.y, p.z, n.x, n.y, n.z, still, kinetic, gap, stick];
  const planeAt = resource((world) => {
    const at = allocate(world.internal.arena, 8 * values.length, 'a plane');
    new Float64Array(world.memory.buffer, at, values.length).set(values);
    return at;
  });
  let length = 1;
  return {
    name: 'plane support',
    equation: 'N = -F·n, |f| ≤ μ N',
    parameters: { staticFriction: { unit: '', value: still }, kineticFriction: { unit: '', value: kinetic } },
    reads: ['Position', 'Velocity', 'Mass', 'Collider', 'Inertia', 'AngularVelocity'],
    local: true,
    timeless: true,
    turns: true,
    prepare(_world, dt) {
      length = dt;
    },
    accumulate(world, first, last) {
      const { force: f, torque: t } = world.scratch.at;
      const inertia = world.addresses.Inertia.value;
      const { x, y, z } = world.scratch.at.startVelocity;
      const kernels = lawKernels(world);
      const plane = planeAt(world);
      kernels.supportForce(plane, inertia, TURNS, f.x, f.y, f.z, t.x, t.y, t.z, x, y, z, length, first, last);
    },
  };
}

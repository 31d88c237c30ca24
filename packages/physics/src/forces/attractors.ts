// Fixed centres of Newtonian attraction: every entity with Attractor and Position pulls all bodies with mass.
//
//   F = -m μ r / (r² + ε²)^(3/2)        potential  U = -m μ / √(r² + ε²)
//
//   m  mass, kg     μ = G M  gravitational parameter, m³/s²     r  from the centre to the body, m     ε  softening, m
//
// With a speed of light c every centre is a black hole with the horizon r_s = 2 μ/c², as in `paczynskiWiita`:
//
//   F = -m μ r / (s (s - r_s)²)        potential  U = -m μ/(s - r_s)        s = √(r² + ε²), both zero for s ≤ r_s
//
// Newton (1687); Plummer's softening (1911), as in Dehnen and Read, Eur. Phys. J. Plus 126, 55 (2011), section 2.2;
// Paczyński and Wiita, Astronomy and Astrophysics 88, 23 (1980). Valid outside the attracting sphere, or anywhere if
// ε is of its size. At the centre itself (r = 0) the force is zero, with or without softening, and never NaN. No
// force acts on a centre, neither from other centres nor from itself. A moving centre is extrapolated with its
// velocity during the step, so that the force reads only its own body and the table of centres. Cost: a square root,
// a division and about 20 more operations per body and centre; with a speed of light two divisions and about 25.
import { bitOf } from '../components/membership.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { reportFault } from '../errors/report-fault.ts';
import { checkKeys } from '../errors/validate.ts';
import type { BodySymbols } from '../laws/body-symbols.ts';
import { constant, type Scalar, type Vector, vec3 } from '../laws/expression.ts';
import { scalar, suppliedScalar } from '../laws/parameter.ts';
import { table } from '../laws/table.ts';
import { CENTRE_BYTES, CENTRE_FIELDS } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { inverseWhere } from './support/central-force.ts';

/** A speed of light below 1 mm/s would make horizons as large as worlds. */
const LIGHT_SPEEDS = { min: 1e-3, max: 1e12 };

/** A centre at the start of the step: kernels/forces/attractors.ts. */
type Centre = Readonly<Record<(typeof CENTRE_FIELDS)[number], Scalar>>;

const centresOf = namedResource('attractor centres', emptyEntityList);

/** Options of `attractors`. */
export interface AttractorsOptions {
  /** Speed of light c, m/s, which makes the centres black holes. By default the attraction is Newtonian. */
  readonly lightSpeed?: number;
}

const parameters = {
  centres: table(CENTRE_FIELDS, centresAtStart),
  /** Time of the positions in the table, s. */
  gathered: suppliedScalar((world) => world.time),
};

const newton = /* @__PURE__ */ defineLaw({
  name: 'attractors',
  formula: 'F = -m μ r / (r² + ε²)^(3/2)',
  source: 'Dehnen and Read, Eur. Phys. J. Plus 126, 55 (2011), section 2.2.',
  parameters,
  acceleration: (body, { centres, gathered }) =>
    centres.sum((centre) => {
      const { r, s, isOther } = vectorTo(centre, body, gathered);
      const inverse = inverseWhere(isOther.and(s.greater(0)), s);
      return r.mul(inverse).mul(centre.mu.mul(inverse).mul(inverse));
    }),
  potential: (body, { centres, gathered }) =>
    centres
      .sum((centre) => {
        const { s, isOther } = vectorTo(centre, body, gathered);
        return centre.mu.mul(inverseWhere(isOther.and(s.greater(0)), s));
      })
      .mul(body.mass)
      .negate(),
  prepare: (world) => void gather(world),
});

const blackHoles = /* @__PURE__ */ defineLaw({
  name: 'attractors',
  formula: 'F = -m μ r / (s (s - r_s)²)',
  source: 'Paczyński and Wiita, Astronomy and Astrophysics 88, 23 (1980).',
  parameters: { lightSpeed: scalar('m/s', LIGHT_SPEEDS), ...parameters },
  acceleration: (body, { centres, gathered, lightSpeed }) =>
    centres.sum((centre) => {
      const { r, s, isOther } = vectorTo(centre, body, gathered);
      const gap = s.sub(horizonOf(centre, lightSpeed));
      const isOutside = isOther.and(gap.greater(0));
      const steep = inverseWhere(isOutside, gap);
      return r.mul(inverseWhere(isOutside, s)).mul(centre.mu.mul(steep).mul(steep));
    }),
  potential: (body, { centres, gathered, lightSpeed }) =>
    centres
      .sum((centre) => {
        const { s, isOther } = vectorTo(centre, body, gathered);
        const gap = s.sub(horizonOf(centre, lightSpeed));
        return centre.mu.mul(inverseWhere(isOther.and(gap.greater(0)), gap));
      })
      .mul(body.mass)
      .negate(),
  prepare: (world) => void gather(world),
});

/** Attraction by all entities with `Attractor`. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function attractors(options: AttractorsOptions = {}): Force {
  checkKeys(options, 'attractors', ['lightSpeed']);
  const { lightSpeed } = options;
  return lightSpeed === undefined ? newton() : blackHoles({ lightSpeed });
}

/** Returns the vector to a centre, its softened length, and whether the centre is another body. */
function vectorTo({ x, y, z, vx, vy, vz, softeningSquared, entity }: Centre, body: BodySymbols, gathered: Scalar) {
  const elapsed = body.time.sub(gathered);
  const at = vec3(x.add(vx.mul(elapsed)), y.add(vy.mul(elapsed)), z.add(vz.mul(elapsed)));
  const r: Vector = at.sub(body.position);
  return { r, s: r.lengthSquared().add(softeningSquared).sqrt(), isOther: body.entity.equals(entity).not() };
}

/** Returns the horizon 2 μ/c², m; zero for a repelling centre. */
function horizonOf({ mu }: Centre, lightSpeed: Scalar): Scalar {
  return mu.mul(constant(2).div(lightSpeed.square())).max(0);
}

/** Returns the centres at the start of the step; outside a step the current ones. */
function centresAtStart(world: PhysicsWorld): EntityList {
  return world.state === 'stepping' ? centresOf(world) : gather(world);
}

/** Lists the centres if entities changed, and copies their current state. */
function gather(world: PhysicsWorld): EntityList {
  const centres = centresOf(world);
  refreshEntityList(world, centres, 'Attractor', CENTRE_BYTES, bitOf('Attractor') | bitOf('Position'));
  const { ids, at, count } = centres;
  const { mu, softening } = world.addresses.Attractor;
  const invalidCount = world.kernels.gatherAttractors(ids, count, mu, softening, at);
  if (invalidCount > 0) repair(world, centres);
  return centres;
}

/** Sets non-finite coefficients to 0 and reports a fault; poses are validated when the step begins. */
function repair(world: PhysicsWorld, { ids, count }: EntityList): void {
  const { Attractor } = world.components;
  for (const entity of new Uint32Array(world.memory.buffer, ids, count)) {
    for (const field of ['mu', 'softening'] as const) {
      const value = Attractor[field][entity];
      if (Number.isFinite(value)) continue;
      Attractor[field][entity] = 0;
      reportFault(world, { code: 'E_NONFINITE', entity, field: `Attractor.${field}`, value, phase: 'begin' });
    }
  }
}

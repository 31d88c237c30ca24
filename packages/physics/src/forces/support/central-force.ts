// The common part of laws about a centre: its position and velocity, and the coupling to mass or charge.
import { Charge } from '../../components/charge.ts';
import { defineLaw } from '../../dynamics/define-law.ts';
import type { VectorInput } from '../../errors/validate.ts';
import type { BodySymbols } from '../../laws/body-symbols.ts';
import { type Condition, constant, type Scalar, select, type Vector } from '../../laws/expression.ts';
import type { LawSymbols } from '../../laws/law.ts';
import { type ParameterInput, type Parameters, vector } from '../../laws/parameter.ts';
import type { Force, PhysicsWorld } from '../../world/types.ts';
import { POSITION_BOUNDS, VELOCITY_BOUNDS } from './bounds.ts';

/** The position of a centre over time. */
export interface CentreOptions {
  /** Position at time 0, m; default the origin. */
  readonly centre?: VectorInput;
  /** Velocity, m/s; default zero. The field of a moving centre is not conservative. */
  readonly centreVelocity?: VectorInput;
}

export const CENTRE_KEYS = ['centre', 'centreVelocity'] as const;

const CENTRE = {
  centre: vector('m', { default: {}, ...POSITION_BOUNDS }),
  centreVelocity: vector('m/s', { default: {}, ...VELOCITY_BOUNDS }),
};

/** A field about a centre. */
export interface CentralLaw<P> {
  readonly name: string;
  readonly formula: string;
  readonly source?: string;
  readonly parameters: P;
  /** Force, N/kg or N/C, at `r` from the centre, m; zero at r = 0. */
  field(r: Vector, parameters: LawSymbols<P>): Vector;
  /** Potential energy, J/kg or J/C, at `r`. */
  energy(r: Vector, parameters: LawSymbols<P>): Scalar;
  readonly prepare?: (world: PhysicsWorld) => void;
  readonly releaseMemory?: (world: PhysicsWorld) => void;
}

/**
 * Creates the force of a law about a centre.
 * @param options the position of the centre, and the parameters of the law
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function centralForce<P extends Parameters>(
  law: CentralLaw<P>,
  couplesTo: 'Mass' | 'Charge',
  options: CentreOptions & ParameterInput<P>,
): Force {
  const { name, formula, source = '', prepare, releaseMemory } = law;
  const symbols = (given: object) => given as LawSymbols<P> & LawSymbols<typeof CENTRE>;
  const from = ({ position, time }: BodySymbols, given: object) => {
    const { centre, centreVelocity } = symbols(given);
    return position.sub(centre.add(centreVelocity.mul(time)));
  };
  type Body = BodySymbols & { readonly charge: Scalar };
  const field = (body: Body, given: object) => law.field(from(body, given), symbols(given));
  const energy = (body: Body, given: object) => law.energy(from(body, given), symbols(given));
  const couplesToMass = couplesTo === 'Mass';
  const make = defineLaw({
    name,
    formula,
    source,
    parameters: { ...law.parameters, ...CENTRE } as Parameters,
    reads: { charge: Charge },
    ...(couplesToMass
      ? { acceleration: field }
      : { force: (body: Body, given) => field(body, given).mul(body.charge) }),
    ...(!isMoving(options) && {
      potential: (body: Body, given) => energy(body, given).mul(couplesToMass ? body.mass : body.charge),
    }),
    ...(prepare && { prepare }),
    ...(releaseMemory && { releaseMemory }),
  });
  return make(options as never);
}

/** Tests whether the centre has a velocity, which the law itself validates. */
function isMoving(options: CentreOptions): boolean {
  const { x = 0, y = 0, z = 0 } = options?.centreVelocity ?? {};
  return x !== 0 || y !== 0 || z !== 0;
}

/** Returns 1/r if the condition holds, else 0; it must not hold at r = 0. */
export function inverseWhere(condition: Condition, r: Scalar): Scalar {
  return select(condition, constant(1).div(r), 0);
}

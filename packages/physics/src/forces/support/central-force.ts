// What the laws of a fixed centre have in common: the centre, the coupling to mass or charge, and how they are made.
import { Charge } from '../../components/charge.ts';
import { defineLaw } from '../../dynamics/define-law.ts';
import type { VectorInput } from '../../errors/validate.ts';
import type { BodySymbols } from '../../laws/body-symbols.ts';
import { type Condition, constant, type Scalar, select, type Vector } from '../../laws/expression.ts';
import type { LawSymbols } from '../../laws/law.ts';
import { type ParameterInput, type Parameters, vector } from '../../laws/parameter.ts';
import type { Force, PhysicsWorld } from '../../world/types.ts';
import { PLACES, SPEEDS } from './bounds.ts';

/** Where a centre is. */
export interface CentreOptions {
  /** Position at time 0, m; default the origin. */
  readonly centre?: VectorInput;
  /** Its velocity, m/s; default none. The field of a moving centre is not conservative. */
  readonly centreVelocity?: VectorInput;
}

export const CENTRE_KEYS = ['centre', 'centreVelocity'] as const;

const CENTRE = {
  centre: vector('m', { default: {}, ...PLACES }),
  centreVelocity: vector('m/s', { default: {}, ...SPEEDS }),
};

/** A field about a centre. */
export interface CentralLaw<P> {
  readonly name: string;
  readonly formula: string;
  readonly source?: string;
  readonly parameters: P;
  /** N/kg or N/C at `r` from the centre, m; zero at r = 0. */
  field(r: Vector, parameters: LawSymbols<P>): Vector;
  /** J/kg or J/C there. */
  energy(r: Vector, parameters: LawSymbols<P>): Scalar;
  readonly prepare?: (world: PhysicsWorld) => void;
}

/**
 * The force of a law about a centre.
 * @param options where the centre is, and the parameters of the law
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function centralForce<P extends Parameters>(
  law: CentralLaw<P>,
  couplesTo: 'Mass' | 'Charge',
  options: CentreOptions & ParameterInput<P>,
): Force {
  const { name, formula, source = '', prepare } = law;
  const symbols = (given: object) => given as LawSymbols<P> & LawSymbols<typeof CENTRE>;
  const from = ({ position, time }: BodySymbols, given: object) => {
    const { centre, centreVelocity } = symbols(given);
    return position.sub(centre.add(centreVelocity.mul(time)));
  };
  type Body = BodySymbols & { readonly charge: Scalar };
  const field = (body: Body, given: object) => law.field(from(body, given), symbols(given));
  const energy = (body: Body, given: object) => law.energy(from(body, given), symbols(given));
  const isOfMass = couplesTo === 'Mass';
  const make = defineLaw({
    name,
    formula,
    source,
    parameters: { ...law.parameters, ...CENTRE } as Parameters,
    reads: { charge: Charge },
    ...(isOfMass ? { acceleration: field } : { force: (body: Body, given) => field(body, given).mul(body.charge) }),
    ...(!moves(options) && {
      potential: (body: Body, given) => energy(body, given).mul(isOfMass ? body.mass : body.charge),
    }),
    ...(prepare && { prepare }),
  });
  return make(options as never);
}

/** Whether the centre has a velocity; the law itself says what is wrong with one. */
function moves(options: CentreOptions): boolean {
  const { x = 0, y = 0, z = 0 } = options?.centreVelocity ?? {};
  return x !== 0 || y !== 0 || z !== 0;
}

/** 1/r where the condition holds, and 0 elsewhere: it must not hold at r = 0. */
export function inverseWhere(condition: Condition, r: Scalar): Scalar {
  return select(condition, constant(1).div(r), 0);
}

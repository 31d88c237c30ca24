// Laws defined by a potential: the force F = -∇U is derived from the expression of the energy.
import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, mustBe } from '../errors/validate.ts';
import type { BodySymbols, ReadSymbols, Reads } from '../laws/body-symbols.ts';
import { gradientOf } from '../laws/differentiate.ts';
import { constant, type Expression, Scalar } from '../laws/expression.ts';
import type { LawOptions, LawSymbols } from '../laws/law.ts';
import type { Parameters } from '../laws/parameter.ts';
import { defineCheckedLaw, type LawFactory } from './define-law.ts';

/** Options of a law that has only a potential. */
export interface PotentialOptions<R extends Reads, P extends Parameters>
  extends Pick<LawOptions<R, P>, 'name' | 'formula' | 'source' | 'reads' | 'parameters' | 'dimensions' | 'prepare'> {
  /** Potential energy of the body, J. */
  readonly potential: (body: BodySymbols & ReadSymbols<R>, parameters: LawSymbols<P>) => Scalar;
}

const KEYS = ['name', 'formula', 'source', 'reads', 'parameters', 'dimensions', 'prepare', 'potential'];

/** State on which a potential energy must not depend. */
const MOTION = new Set(['velocity', 'startVelocity', 'angularVelocity', 'force', 'acceleration', 'dt', 'noise']);

/**
 * Defines the law of a potential: its force is F = -∇U with respect to position, with everything else that U reads held
 * constant. No torque is derived, so U must not depend on orientation.
 * @returns a function that creates the force, like `defineLaw`
 * @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN, naming the law
 */
export function lawFromPotential<
  const R extends Reads = Record<never, never>,
  const P extends Parameters = Record<never, never>,
>(options: PotentialOptions<R, P>): LawFactory<P> {
  checkKeys(options, 'lawFromPotential', KEYS);
  const { potential } = options;
  return defineCheckedLaw<R, P>({
    ...options,
    force: (body, parameters) => {
      const energy: unknown = potential(body, parameters);
      if (!(energy instanceof Scalar)) throw mustBe('a function that returns a scalar', energy, 'potential');
      checkEnergy(energy);
      return gradientOf(energy, constant(-1));
    },
  });
}

/**
 * @throws PhysicsError E_TYPE for an energy that depends on motion or does not depend on position
 */
function checkEnergy(energy: Scalar): void {
  const seen = new Set<Expression>();
  const visit = (expression: Expression) => {
    if (seen.has(expression)) return;
    seen.add(expression);
    const { op, args } = expression;
    if (MOTION.has(op)) throw new PhysicsError('E_TYPE', `a potential cannot depend on ${op}.`, { field: op });
    args.forEach(visit);
  };
  visit(energy);
  if (![...seen].some(({ op }) => op === 'position')) {
    throw new PhysicsError('E_TYPE', 'the potential does not depend on position, so it has no force.', {
      field: 'potential',
    });
  }
}

// Every integrator by name, with the facts for choosing one. docs/integrators.md is generated from this.

import type { Integrator } from '../../world/types.ts';
import { boris } from '../boris.ts';
import { dormandPrince } from '../dormand-prince.ts';
import { driftKickDrift } from '../drift-kick-drift.ts';
import { explicitEuler } from '../explicit-euler.ts';
import { gaussRadau } from '../gauss-radau.ts';
import { heun } from '../heun.ts';
import { implicitEuler } from '../implicit-euler.ts';
import { leapfrog } from '../leapfrog.ts';
import { midpoint } from '../midpoint.ts';
import { positionFirstEuler } from '../position-first-euler.ts';
import { positionVerlet } from '../position-verlet.ts';
import { rungeKutta4 } from '../runge-kutta-4.ts';
import { semiImplicitEuler } from '../semi-implicit-euler.ts';
import { velocityVerlet } from '../velocity-verlet.ts';
import { wisdomHolman } from '../wisdom-holman.ts';
import { yoshida4 } from '../yoshida4.ts';
import { yoshida6 } from '../yoshida6.ts';

/** Facts about a scheme. */
export interface IntegratorRecord {
  /** The expression in code: `semiImplicitEuler`, `gaussRadau()`. */
  readonly code: string;
  /** The display name. */
  readonly name: string;
  /** Order of the global error in dt, for forces that depend only on position. */
  readonly order: number;
  /** Order for forces that depend on velocity; for Boris, for non-magnetic ones. */
  readonly orderWithVelocity: number;
  /** Whether the energy of a conservative system stays bounded for ever. */
  readonly symplectic: boolean;
  /** Whether a run with reversed velocities returns to its start up to rounding. */
  readonly reversible: boolean;
  /** Force evaluations per step; for adaptive schemes in smooth motion. */
  readonly evaluations: string;
  readonly chooseWhen: string;
  /** Creates it with default options; a magnetic field is zero. */
  create(): Integrator;
}

type Facts = Omit<IntegratorRecord, 'name' | 'order' | 'symplectic' | 'evaluations' | 'create'> & {
  readonly evaluations?: string;
};

function record(create: () => Integrator, facts: Facts): IntegratorRecord {
  const { name, order, symplectic, evaluations } = create();
  return { name, order, symplectic, evaluations: String(evaluations), ...facts, create };
}

/** Every integrator, from the simplest to the most accurate. */
export const INTEGRATORS = {
  explicitEuler: record(() => explicitEuler, {
    code: 'explicitEuler',
    orderWithVelocity: 1,
    reversible: false,
    chooseWhen: 'never, except to demonstrate growing energy: the baseline of the others',
  }),
  implicitEuler: record(() => implicitEuler(), {
    code: 'implicitEuler()',
    orderWithVelocity: 1,
    reversible: false,
    evaluations: '5 to 100',
    chooseWhen: 'springs are too stiff for explicit schemes and fast motion may be damped',
  }),
  semiImplicitEuler: record(() => semiImplicitEuler, {
    code: 'semiImplicitEuler',
    orderWithVelocity: 1,
    reversible: false,
    chooseWhen: 'there are contacts, or millions of bodies: the cheapest stable scheme',
  }),
  positionFirstEuler: record(() => positionFirstEuler, {
    code: 'positionFirstEuler',
    orderWithVelocity: 1,
    reversible: false,
    chooseWhen: 'comparing with programs that update positions before velocities',
  }),
  midpoint: record(() => midpoint, {
    code: 'midpoint',
    orderWithVelocity: 2,
    reversible: false,
    chooseWhen: 'drag or other velocity-dependent forces dominate and second order suffices',
  }),
  heun: record(() => heun, {
    code: 'heun',
    orderWithVelocity: 2,
    reversible: false,
    chooseWhen: 'as midpoint, for forces best evaluated at the ends of a step',
  }),
  positionVerlet: record(() => positionVerlet, {
    code: 'positionVerlet',
    orderWithVelocity: 2,
    reversible: false,
    chooseWhen: 'forces are expensive, steps are equal and bodies are not moved between steps',
  }),
  velocityVerlet: record(() => velocityVerlet, {
    code: 'velocityVerlet',
    orderWithVelocity: 2,
    reversible: true,
    chooseWhen: 'you have no reason to choose another: the default',
  }),
  leapfrog: record(() => leapfrog, {
    code: 'leapfrog',
    orderWithVelocity: 1,
    reversible: true,
    chooseWhen: 'you want kick-drift-kick leapfrog, for forces that depend only on position',
  }),
  driftKickDrift: record(() => driftKickDrift, {
    code: 'driftKickDrift',
    orderWithVelocity: 1,
    reversible: true,
    chooseWhen: 'forces are expensive and depend only on position: second order for one evaluation',
  }),
  rungeKutta4: record(() => rungeKutta4, {
    code: 'rungeKutta4',
    orderWithVelocity: 4,
    reversible: false,
    chooseWhen: 'smooth motion over few periods, with any force',
  }),
  yoshida4: record(() => yoshida4, {
    code: 'yoshida4',
    orderWithVelocity: 1,
    reversible: true,
    chooseWhen: 'orbits over very many periods, at moderate accuracy',
  }),
  yoshida6: record(() => yoshida6, {
    code: 'yoshida6',
    orderWithVelocity: 1,
    reversible: true,
    chooseWhen: 'orbits over very many periods, at high accuracy',
  }),
  boris: record(() => boris({ field: {} }), {
    code: 'boris({ field })',
    orderWithVelocity: 1,
    reversible: true,
    chooseWhen: 'charges gyrate in a magnetic field',
  }),
  dormandPrince: record(() => dormandPrince(), {
    code: 'dormandPrince()',
    orderWithVelocity: 5,
    reversible: false,
    evaluations: '6 per sub-step',
    chooseWhen: 'time scales vary, or you want to specify an error instead of a step',
  }),
  wisdomHolman: record(() => wisdomHolman(), {
    code: 'wisdomHolman()',
    orderWithVelocity: 1,
    reversible: true,
    chooseWhen: 'planets orbit a star for millions of years without close encounters',
  }),
  gaussRadau: record(() => gaussRadau(), {
    code: 'gaussRadau()',
    orderWithVelocity: 15,
    reversible: false,
    evaluations: '15 to 22 per sub-step',
    chooseWhen: 'you need reference accuracy: ephemerides, close encounters, tests of other schemes',
  }),
} as const satisfies Record<string, IntegratorRecord>;

/** The names of all integrators. */
export type IntegratorName = keyof typeof INTEGRATORS;

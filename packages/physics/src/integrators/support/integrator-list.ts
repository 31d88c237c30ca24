// Every integrator by name, and what is worth knowing before choosing one. docs/integrators.md is made of this.

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

/** What is worth knowing about a scheme. */
export interface IntegratorRecord {
  /** As it is written in code: `semiImplicitEuler`, `gaussRadau()`. */
  readonly code: string;
  /** As it is called. */
  readonly name: string;
  /** Order of the global error in dt, for forces of position alone. */
  readonly order: number;
  /** Order when forces depend on velocity; of Boris, when others than the magnetic do. */
  readonly orderWithVelocity: number;
  /** Keeps the energy of a conservative system bounded for ever. */
  readonly symplectic: boolean;
  /** A run with velocities turned round comes back to its start, but for rounding. */
  readonly reversible: boolean;
  /** Force evaluations a step; where the scheme decides, what it takes in smooth motion. */
  readonly evaluations: string;
  readonly chooseWhen: string;
  /** One with its default options; those of a magnetic field are no field. */
  create(): Integrator;
}

type Facts = Omit<IntegratorRecord, 'name' | 'order' | 'symplectic' | 'evaluations' | 'create'> & {
  readonly evaluations?: string;
};

function record(create: () => Integrator, facts: Facts): IntegratorRecord {
  const { name, order, symplectic, evaluations } = create();
  return { name, order, symplectic, evaluations: String(evaluations), ...facts, create };
}

/** Every integrator, from the plainest to the most exact. */
export const INTEGRATORS = {
  explicitEuler: record(() => explicitEuler, {
    code: 'explicitEuler',
    orderWithVelocity: 1,
    reversible: false,
    chooseWhen: 'never, but to see energy grow: it is what the others improve on',
  }),
  implicitEuler: record(() => implicitEuler(), {
    code: 'implicitEuler()',
    orderWithVelocity: 1,
    reversible: false,
    evaluations: '5 to 100',
    chooseWhen: 'springs are too stiff for any explicit step and fast motion may die away',
  }),
  semiImplicitEuler: record(() => semiImplicitEuler, {
    code: 'semiImplicitEuler',
    orderWithVelocity: 1,
    reversible: false,
    chooseWhen: 'bodies touch, or there are millions: the cheapest that is stable',
  }),
  positionFirstEuler: record(() => positionFirstEuler, {
    code: 'positionFirstEuler',
    orderWithVelocity: 1,
    reversible: false,
    chooseWhen: 'comparing with programs that move first and push afterwards',
  }),
  midpoint: record(() => midpoint, {
    code: 'midpoint',
    orderWithVelocity: 2,
    reversible: false,
    chooseWhen: 'drag or other forces of velocity rule and second order will do',
  }),
  heun: record(() => heun, {
    code: 'heun',
    orderWithVelocity: 2,
    reversible: false,
    chooseWhen: 'as midpoint, for forces best known at the ends of a step',
  }),
  positionVerlet: record(() => positionVerlet, {
    code: 'positionVerlet',
    orderWithVelocity: 2,
    reversible: false,
    chooseWhen: 'forces are dear, steps are equal and nobody moves the bodies meanwhile',
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
    chooseWhen: 'velocity Verlet in its textbook form is wanted, for forces of position alone',
  }),
  driftKickDrift: record(() => driftKickDrift, {
    code: 'driftKickDrift',
    orderWithVelocity: 1,
    reversible: true,
    chooseWhen: 'forces are dear and depend on position alone: second order for one evaluation',
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
    evaluations: '6 a sub-step',
    chooseWhen: 'forces change their pace, or you want to name an error rather than a step',
  }),
  wisdomHolman: record(() => wisdomHolman(), {
    code: 'wisdomHolman()',
    orderWithVelocity: 1,
    reversible: true,
    chooseWhen: 'planets circle a star for millions of years and do not meet',
  }),
  gaussRadau: record(() => gaussRadau(), {
    code: 'gaussRadau()',
    orderWithVelocity: 15,
    reversible: false,
    evaluations: '15 to 22 a sub-step',
    chooseWhen: 'you need the true answer: ephemerides, close encounters, a reference for the others',
  }),
} as const satisfies Record<string, IntegratorRecord>;

/** The names of all integrators. */
export type IntegratorName = keyof typeof INTEGRATORS;

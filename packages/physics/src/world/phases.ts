import { eachRun, type Spans } from '../ecs/ranges.ts';
import { checkFunction } from '../errors/validate.ts';
import type { PhysicsWorld } from './create-world.ts';

/**
 * The chapters of a step, in order. Systems run in the order of their array; nothing says "before" or "after".
 */
export const PHASES = [
  /** Your own systems: controls, scripts. Reads anything, writes velocities and parameters. */
  'input',
  /** Emitters age, end and bear particles. */
  'emit',
  /** Saves the pose for interpolation and finds values that are not finite before they can spread. */
  'begin',
  /** Forces and the integrator: velocities and positions move by one step. */
  'integrate',
  /** Walls: bodies that ended inside one are brought back. */
  'walls',
  /** Contacts between bodies: broad phase, narrow phase, response. */
  'collide',
  /** Finds values that are not finite or out of range after the step, and quarantines their bodies. */
  'finish',
  /** Your own systems again, with this step's contacts and faults to read. */
  'events',
] as const;

export type Phase = (typeof PHASES)[number];

/** A system that may look at the whole world. */
export type GlobalSystem = (world: PhysicsWorld, dt: number) => void;

/** A system that, for each body, reads and writes the body's own row only. */
export interface LocalSystem {
  readonly name: string;
  /** Sweeps the runs of `spans`. */
  run(world: PhysicsWorld, spans: Spans, dt: number): void;
  /** What it is to the integrator, when that may take over its work: see docs/step.md. */
  readonly role?: 'begin' | 'integrate' | 'rotate' | 'box' | 'check';
}

export type System = GlobalSystem | LocalSystem;

/** The systems of a world. Push yours to a phase; the change takes effect at the next step. */
export type Phases = { readonly [P in Phase]: System[] };

export function createPhases(): Phases {
  return Object.freeze(Object.fromEntries(PHASES.map((phase) => [phase, []]))) as unknown as Phases;
}

/** Your own local system in plain TypeScript: `run` gets ascending runs of rows. @throws PhysicsError E_TYPE */
export function localSystem(
  name: string,
  run: (world: PhysicsWorld, first: number, last: number, dt: number) => void,
): LocalSystem {
  checkFunction(run, 'localSystem: run');
  return { name, run: eachRun(run) };
}

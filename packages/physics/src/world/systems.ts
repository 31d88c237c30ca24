import { forEachRange } from '../ecs/ranges.ts';
import { checkFunction } from '../errors/validate.ts';
import { PHASES } from './phases.ts';
import type { LocalSystem, Phases, PhysicsWorld } from './types.ts';

export function createPhases(): Phases {
  return Object.freeze(Object.fromEntries(PHASES.map((phase) => [phase, []]))) as unknown as Phases;
}

/** Creates a local system in plain TypeScript: `run` receives ascending ranges of rows. @throws PhysicsError E_TYPE */
export function localSystem(
  name: string,
  run: (world: PhysicsWorld, first: number, last: number, dt: number) => void,
): LocalSystem {
  checkFunction(run, 'localSystem: run');
  return { name, run: forEachRange(run) };
}

import { checkHas, checkList } from '../faults/validate';
import type { PhysicsWorld } from '../world';
import { type Ahead, aheadOf } from './ahead';
import { type LocalSystem, PHASES, type Phase, type System } from './phases';

/** Systems that run together: one global system, or consecutive local ones that share tiles. */
export interface Group {
  readonly phases: readonly Phase[];
  readonly systems: readonly System[];
  readonly tiled: boolean;
  /** Scratch rows may slide onto the tile: nobody outside this group uses the scratch. */
  readonly slides: boolean;
}

/** What a step does, worked out from the phases and forces; made anew only when those change. */
export interface Plan {
  readonly groups: readonly Group[];
  readonly signature: readonly unknown[];
  /** No force looks at more than its own body. */
  readonly forcesLocal: boolean;
  /** Every force ignores the time. */
  readonly forcesTimeless: boolean;
  /** The table of what the next tile reads. */
  readonly ahead: Ahead;
}

function isTiled(world: PhysicsWorld, system: System): system is LocalSystem {
  return typeof system !== 'function' && (system.isLocal?.(world) ?? true);
}

function usesScratch(system: System): boolean {
  return typeof system !== 'function' && system.usesScratch === true;
}

/** Said of what is no force. */
export const FORCE_HINT = 'A force is made by a function such as uniformGravity() or defineForce({ … }).';

/** @throws PhysicsError E_TYPE, naming the first that is no force */
export function checkForces(forces: readonly unknown[], what: string): void {
  checkList(forces, what);
  // By index: `forEach` would pass over the holes of a sparse array.
  for (let f = 0; f < forces.length; f++) checkHas(forces[f], 'accumulate', `${what}[${f}]`, FORCE_HINT);
}

/** @throws PhysicsError E_TYPE, naming the first that is no system */
export function checkSystems(systems: readonly unknown[], what: string): void {
  checkList(systems, what);
  const hint = 'A system is a function (world, dt) => void, or made by a function such as boxWalls({ … }).';
  for (let s = 0; s < systems.length; s++) {
    if (typeof systems[s] !== 'function') checkHas(systems[s], 'run', `${what}[${s}]`, hint);
  }
}

/** @throws PhysicsError E_TYPE */
export function checkIntegrator(integrator: unknown, what: string): void {
  checkHas(integrator, 'advance', what, 'Such as velocityVerlet, semiImplicitEuler or rungeKutta4.');
}

/**
 * The plan for the world as it is now, reused while neither phases, forces nor integrator changed.
 * @throws PhysicsError E_TYPE when one of them is not what it must be
 */
export function currentPlan(world: PhysicsWorld): Plan {
  const plan = world.internal.plan;
  if (plan !== undefined && isCurrent(world, plan)) return plan;
  const made = makePlan(world);
  world.internal.plan = made;
  return made;
}

function isCurrent(world: PhysicsWorld, plan: Plan): boolean {
  const { signature } = plan;
  let i = 0;
  if (signature[i++] !== world.integrator) return false;
  for (let p = 0; p < PHASES.length; p++) {
    const phase = PHASES[p];
    const systems = world.phases[phase];
    for (let s = 0; s < systems.length; s++) if (signature[i++] !== systems[s]) return false;
    if (signature[i++] !== phase) return false;
  }
  for (let f = 0; f < world.forces.length; f++) if (signature[i++] !== world.forces[f]) return false;
  return i === signature.length;
}

function makePlan(world: PhysicsWorld): Plan {
  checkForces(world.forces, 'world.forces');
  checkIntegrator(world.integrator, 'world.integrator');
  for (const phase of PHASES) checkSystems(world.phases[phase], `world.phases.${phase}`);
  const groups: { phases: Phase[]; systems: System[]; tiled: boolean }[] = [];
  const signature: unknown[] = [world.integrator];
  for (const phase of PHASES) {
    for (const system of world.phases[phase]) {
      signature.push(system);
      const tiled = isTiled(world, system);
      const open = groups[groups.length - 1];
      if (tiled && open?.tiled) {
        open.phases.push(phase);
        open.systems.push(system);
      } else {
        groups.push({ phases: [phase], systems: [system], tiled });
      }
    }
    signature.push(phase);
  }
  signature.push(...world.forces);
  const scratchGroups = groups.filter((group) => group.systems.some(usesScratch));
  const plainForces = world.forces.some((force) => force.usesForceColumns === true);
  return {
    signature,
    ahead: aheadOf(world),
    forcesLocal: world.forces.every(({ local }) => local),
    forcesTimeless: world.forces.every(({ timeless }) => timeless === true),
    groups: groups.map((group) => ({
      ...group,
      slides: group.tiled && !plainForces && scratchGroups.length === 1 && scratchGroups[0] === group,
    })),
  };
}

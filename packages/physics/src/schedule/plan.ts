import type { PhysicsWorld } from '../world';
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
}

function isTiled(world: PhysicsWorld, system: System): system is LocalSystem {
  return typeof system !== 'function' && (system.isLocal?.(world) ?? true);
}

function usesScratch(system: System): boolean {
  return typeof system !== 'function' && system.usesScratch === true;
}

/** The plan for the world as it is now, reused while neither phases, forces nor integrator changed. */
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
  for (const phase of PHASES) {
    const systems = world.phases[phase];
    for (let s = 0; s < systems.length; s++) if (signature[i++] !== systems[s]) return false;
    if (signature[i++] !== phase) return false;
  }
  for (let f = 0; f < world.forces.length; f++) if (signature[i++] !== world.forces[f]) return false;
  return i === signature.length;
}

function makePlan(world: PhysicsWorld): Plan {
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
    groups: groups.map((group) => ({
      ...group,
      slides: group.tiled && !plainForces && scratchGroups.length === 1 && scratchGroups[0] === group,
    })),
  };
}

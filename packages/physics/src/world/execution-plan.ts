import { PhysicsError } from '../errors/physics-error.ts';
import { checkHas, checkList, isRecord } from '../errors/validate.ts';
import { PHASES, type Phase } from './phases.ts';
import type { Force, Fusion, GlobalSystem, LocalSystem, PhysicsWorld, Plan, System } from './types.ts';

/** Hint of errors about values that are not forces. */
const FORCE_HINT = 'Create forces with a function such as uniformGravity() or defineForce({ … }).';

/**
 * @throws PhysicsError E_TYPE, naming the first value that is not a force; E_RANGE
 */
export function checkForces(forces: readonly unknown[], what: string, dimensions: 2 | 3): void {
  checkList(forces, what);
  // The loop uses indices, because `forEach` skips the holes of a sparse array.
  for (let f = 0; f < forces.length; f++) checkForce(forces[f], `${what}[${f}]`, dimensions);
}

/**
 * @throws PhysicsError E_TYPE for a value that is neither a law nor a force with `accumulate`; E_RANGE for a law of
 *   other dimensions
 */
export function checkForce(force: unknown, what: string, dimensions?: 2 | 3): void {
  if (!isRecord(force) || !isRecord(force.law)) {
    refuseUncalled(force, what, FORCE_HINT);
    checkHas(force, 'accumulate', what, FORCE_HINT);
    return;
  }
  const { dimensions: required, name } = force.law;
  if (dimensions === undefined || required === undefined || required === dimensions) return;
  throw new PhysicsError(
    'E_RANGE',
    `${what}: law "${name}" requires ${required} dimensions, but the world has ${dimensions}.`,
    {
      field: what,
    },
  );
}

/** Refuses the function that makes a force or an integrator in place of what it makes. @throws PhysicsError E_TYPE */
function refuseUncalled(value: unknown, what: string, hint = ''): void {
  if (typeof value !== 'function' || value.name === '') return;
  const { name } = value;
  throw new PhysicsError('E_TYPE', `${what} is the function ${name}, and not what it returns.`, {
    field: what,
    hint: `Call it: ${name}(), with its options if it takes any. ${hint}`.trim(),
  });
}

/**
 * @throws PhysicsError E_TYPE, naming the first value that is not a system
 */
export function checkSystems(systems: readonly unknown[], what: string): void {
  checkList(systems, what);
  const hint = 'A system is a function (world, dt) => void, or a system made by a function such as boxWalls({ … }).';
  for (let s = 0; s < systems.length; s++) {
    if (typeof systems[s] !== 'function') checkHas(systems[s], 'run', `${what}[${s}]`, hint);
  }
}

/** @throws PhysicsError E_TYPE */
export function checkIntegrator(integrator: unknown, what: string): void {
  if (isRecord(integrator) && isRecord(integrator.scheme)) return;
  refuseUncalled(integrator, what);
  checkHas(integrator, 'advance', what, 'Pass an integrator such as velocityVerlet, semiImplicitEuler or rungeKutta4.');
}

/**
 * Returns the plan of the world, reused until phases, forces or integrator change.
 * @throws PhysicsError E_TYPE if one of them has the wrong type, and what a system refuses
 */
export function currentPlan(world: PhysicsWorld): Plan {
  const plan = world.internal.plan;
  if (plan !== undefined && isCurrent(world, plan)) return plan;
  const made = makePlan(world);
  world.internal.plan = made;
  releaseForces(world);
  return made;
}

/** Releases the forces that were taken out of `world.forces`, and notes those that are there. */
function releaseForces(world: PhysicsWorld): void {
  const { forces } = world;
  const { heldForces } = world.internal;
  for (const force of heldForces) if (!forces.includes(force)) releaseForce(world, force);
  for (const force of forces) if (force.releaseMemory !== undefined) heldForces.add(force);
}

/** Lets a force that has left the world give its memory back, unless it is there once more or another force shares it. */
export function releaseForce(world: PhysicsWorld, force: Force): void {
  if (world.forces.includes(force)) return;
  const { releaseMemory } = force;
  world.internal.heldForces.delete(force);
  if (!world.forces.some((each) => each.releaseMemory === releaseMemory)) releaseMemory?.(world);
}

/** Returns a getter of a value that is computed on first use and cached with the plan of a world. */
export function cachedWithPlan<T>(make: (world: PhysicsWorld) => T): (world: PhysicsWorld) => T {
  const key = {};
  return (world) => {
    // A step keeps its plan, whatever user code does to the lists of the world meanwhile.
    const isRunning = world.state === 'preparing' || world.state === 'stepping';
    const running = isRunning ? world.internal.plan : undefined;
    const plan = running ?? currentPlan(world);
    const { kept } = plan;
    if (!kept.has(key)) {
      kept.set(key, make(world));
      plan.made++;
    }
    return kept.get(key) as T;
  };
}

function isCurrent(world: PhysicsWorld, plan: Plan): boolean {
  const { signature } = plan;
  let i = 0;
  if (signature[i++] !== world.integrator) return false;
  if (signature[i++] !== world.internal.partialEntities.immovable > 0) return false;
  if (signature[i++] !== world.internal.counts.GravityScale > 0) return false;
  if (signature[i++] !== world.internal.recordsContacts) return false;
  for (let p = 0; p < PHASES.length; p++) {
    const phase = PHASES[p];
    const systems = world.phases[phase];
    for (let s = 0; s < systems.length; s++) {
      if (signature[i++] !== systems[s] || signature[i++] !== isUseful(world, systems[s])) return false;
    }
    if (signature[i++] !== phase) return false;
  }
  for (let f = 0; f < world.forces.length; f++) if (signature[i++] !== world.forces[f]) return false;
  return i === signature.length;
}

/** Whether there are entities for a system. */
function isUseful({ internal: { counts } }: PhysicsWorld, system: System): boolean {
  return typeof system === 'function' || system.handles === undefined || counts[system.handles] > 0;
}

function makePlan(world: PhysicsWorld): Plan {
  checkForces(world.forces, 'world.forces', world.dimensions);
  checkIntegrator(world.integrator, 'world.integrator');
  for (const phase of PHASES) checkSystems(world.phases[phase], `world.phases.${phase}`);
  for (const system of world.phases.finish) (system as GlobalSystem).assertWorld?.(world);
  const { counts, partialEntities, recordsContacts } = world.internal;
  const signature: unknown[] = [
    world.integrator,
    partialEntities.immovable > 0,
    counts.GravityScale > 0,
    recordsContacts,
  ];
  for (const phase of PHASES) {
    signature.push(...world.phases[phase].flatMap((system) => [system, isUseful(world, system)]), phase);
  }
  signature.push(...world.forces);
  const systems = Object.fromEntries(
    PHASES.map((phase) => [phase, world.phases[phase].filter((system) => isUseful(world, system))]),
  ) as Record<Phase, System[]>;
  const { scheme, advance } = world.integrator;
  const hasStages = scheme !== undefined && advance === undefined;
  const isOneLoop = hasStages && (scheme.stages.length === 0 || world.forces.every(({ law }) => law !== undefined));
  const fusion = fusionOf(
    PHASES.flatMap((phase) => systems[phase]),
    isOneLoop,
  );
  return {
    signature,
    systems,
    forcesLocal: world.forces.every(({ local }) => local),
    fusion: hasStages ? fusion : undefined,
    isOneLoop,
    isStartCurrent: fusion.begin,
    kept: new Map(),
    made: 0,
  };
}

/**
 * Determines which systems next to the integrator its loops replace: walls only if the step is one loop, systems of rotation
 * never.
 */
function fusionOf(systems: readonly System[], isOneLoop: boolean): Fusion {
  const roles = systems.map((system) => (typeof system === 'function' ? undefined : system.role));
  const at = roles.indexOf('integrate');
  const isOnly = roles.lastIndexOf('integrate') === at;
  if (at < 0 || !isOnly) return { begin: false, walls: undefined, check: undefined };
  let next = at + 1;
  if (roles[next] === 'rotate') next++;
  const hasWalls = isOneLoop && roles[next] === 'box' && roles[next + 1] === 'check';
  const last = hasWalls ? next + 1 : next;
  const check = roles[last] === 'check' ? (systems[last] as LocalSystem) : undefined;
  return {
    begin: roles[at - 1] === 'begin',
    walls: hasWalls ? (systems[next] as LocalSystem) : undefined,
    check,
  };
}

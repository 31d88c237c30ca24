// Warnings about valid input that is probably a mistake. Each is given once per world. The export condition
// `production` replaces this file by `no-warnings.ts`.
import type { ComponentName } from '../components/all.ts';
import { warnOnce } from '../errors/warn-once.ts';
import type { Force, PhysicsWorld, Plan, Warning } from '../world/types.ts';

/** The default of `world.onWarning`. */
export function printWarning({ message, hint }: Warning): void {
  globalThis.console?.warn(`Principia: ${message} ${hint}`);
}

/** Durations in this range are more often milliseconds of a frame than seconds, s. */
const FRAME_MILLISECONDS = { min: 5, max: 50 };

/** Warns if a duration looks like the milliseconds of a frame. */
export function warnAboutDuration(world: PhysicsWorld, seconds: number, what: string): void {
  if (seconds < FRAME_MILLISECONDS.min || seconds > FRAME_MILLISECONDS.max) return;
  warnOnce(world, {
    message: `${what} got ${seconds}, which looks like milliseconds; times are in seconds.`,
    hint: `A frame of ${seconds} ms lasts ${seconds / 1000} s. Set \`world.onWarning\` if the step is meant to be that long.`,
  });
}

/**
 * Warns about components, handlers and forces that had no effect in the step that has just ended.
 * @param ignoredEvents events that have handlers and that no system dispatches
 */
export function warnAboutWorld(world: PhysicsWorld, plan: Plan, ignoredEvents: readonly string[]): void {
  warnAboutWalls(world, plan);
  for (const event of ignoredEvents) {
    warnOnce(world, {
      message: `a handler of "${event}" is never called, because no system of this world dispatches this event.`,
      hint: 'Create the world with `preset: particleContacts`.',
    });
  }
  warnAboutUnreadComponents(world);
  warnAboutInertiaTensors(world);
  warnAboutRepeatedForces(world);
}

function warnAboutWalls(world: PhysicsWorld, plan: Plan): void {
  if (world.integrator.solvesWalls === true) return;
  const walls = [
    ['SegmentWall', 'segment walls'],
    ['PlaneWall', 'plane walls'],
  ] as const;
  for (const [component, system] of walls) {
    const isRun = plan.systems.walls.some(({ name }) => name === system);
    if (isRun || world.internal.counts[component] === 0) continue;
    warnOnce(world, {
      message: `bodies pass through every ${component}, because no system of this world runs them.`,
      hint: 'Create the world with `preset: particleContacts`.',
    });
  }
}

/** Components that only forces read, and a factory of such a force. */
const READ_BY_FORCES: Partial<Record<ComponentName, string>> = {
  LinearDrag: 'linearDrag()',
  QuadraticDrag: 'quadraticDrag()',
  AngularDrag: 'angularDrag()',
  GravityScale: 'uniformGravity()',
  Lift: 'lift()',
  Hull: 'buoyancy({ … })',
  Thrust: 'thrust()',
  Motor: 'motors()',
  Engine: 'rocketEngines()',
  Charge: 'magneticField({ … }) or mutualCoulomb()',
};

function warnAboutUnreadComponents(world: PhysicsWorld): void {
  const read = new Set([...world.forces.flatMap(({ reads }) => reads), ...(world.integrator.reads ?? [])]);
  for (const [component, factory] of Object.entries(READ_BY_FORCES) as [ComponentName, string][]) {
    if (world.internal.counts[component] === 0 || read.has(component)) continue;
    warnOnce(world, {
      message: `${component} has no effect, because no force of this world reads it.`,
      hint: `Add ${factory} to \`forces\`.`,
    });
  }
}

function warnAboutInertiaTensors(world: PhysicsWorld): void {
  const { InertiaTensor, Orientation, AngularVelocity } = world.internal.counts;
  if (InertiaTensor <= Math.min(Orientation, AngularVelocity)) return;
  warnOnce(world, {
    message: 'some bodies have an InertiaTensor and do not rotate, because they lack Orientation or AngularVelocity.',
    hint: 'Spawn them with `orientation: {}` and `angularVelocity: {}` as well.',
  });
}

function warnAboutRepeatedForces(world: PhysicsWorld): void {
  const known = new Set<string>();
  for (const force of world.forces) {
    const key = signatureOf(force);
    if (key !== undefined && known.has(key)) {
      warnOnce(world, {
        message: `the force "${force.name}" is in \`world.forces\` twice with the same parameters, and acts twice.`,
        hint: 'Remove one of them.',
      });
    }
    if (key !== undefined) known.add(key);
  }
}

/** Identifies laws with equal constant parameters. Functions of a user may differ in what they compute. */
function signatureOf({ name, law, sources, parameters }: Force): string | undefined {
  if (law === undefined || sources?.some(({ when }) => when !== 'once')) return undefined;
  return JSON.stringify([name, law.structure, parameters]);
}

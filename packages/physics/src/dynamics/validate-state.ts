// Finds and repairs invalid values that user code wrote or a force produced.
//
// Every row is checked before a step, when its pose is saved, so that an invalid value never reaches a force or
// contact; and again after the step, so that no reader sees one. Kernels that process the rows anyway make both checks;
// this file handles rows that failed.
import { addComponent, entityExists, hasComponent, query, set } from 'bitecs';
import { MAX_POSITION } from '../components/position.ts';
import { MAX_ANGLE, MAX_ANGULAR_SPEED, MAX_QUATERNION_COMPONENT } from '../components/rotation.ts';
import { MAX_SPEED } from '../components/velocity.ts';
import { clearMissing } from '../ecs/partial-entities.ts';
import { forEachRange } from '../ecs/ranges.ts';
import { isOpen } from '../ecs/rows.ts';
import { reportFault } from '../errors/report-fault.ts';
import { ANGLES, AXES } from '../memory/axes.ts';
import { type Columns, copyPose } from '../memory/previous-pose.ts';
import type { LocalSystem, PhysicsWorld } from '../world/types.ts';
import { flushToZero } from './flush-to-zero.ts';

type When = 'begin' | 'finish';

/** Largest |force| along an axis, N; slightly below the limit of f32. */
const MAX_FORCE = 3e38;

/** Saves poses, and repairs values written between steps. First system of every preset. */
export const beginStep: LocalSystem = { name: 'begin', role: 'begin', run: forEachRange(beginRange) };

/** Flushes tiny values to zero, and finds invalid ones that the step produced. Last system of every preset. */
export const validateState: LocalSystem = checkSystem('check finite', flushToZero);

/** Finds invalid values before bodies pass them on to others. */
export const validateMotion: LocalSystem = checkSystem('check before contacts');

/** @param before runs before the check */
function checkSystem(name: string, before?: typeof flushToZero): LocalSystem {
  const system: LocalSystem = {
    name,
    role: 'check',
    readsOfOthers: [],
    run: forEachRange((world, first, last) => {
      clearMissing(world, first, last);
      before?.(world, first, last);
      const isFused = world.internal.plan?.fusion?.check === system;
      if ((isFused || isInRange(world, first, last)) && areAnglesValid(world, first, last)) return;
      repairRows(world, first, last, 'finish');
    }),
  };
  return system;
}

function beginRange(world: PhysicsWorld, first: number, last: number): void {
  // The loops of the integrator check positions and velocities themselves.
  const isFused = world.internal.plan?.fusion?.begin === true;
  const isValid = isFused || saveAxes(world, first, last) === 1;
  if (!isValid || !areAnglesValid(world, first, last)) {
    repairRows(world, first, last, 'begin');
    if (!isFused) saveAxes(world, first, last);
  }
  if (canRotate(world)) saveAngles(world, first, last);
}

/**
 * Checks rows one by one, clamps speeds and quarantines bodies that cannot continue.
 * @param laws the law that caused the fault, by row
 */
export function repairRows(
  world: PhysicsWorld,
  first: number,
  last: number,
  phase: When,
  laws?: ReadonlyMap<number, string>,
): void {
  for (let row = first; row < last; row++) repairRow(world, row, phase, laws?.get(row));
}

/**
 * Saves positions and velocities, and returns 1 if all were valid. An invalid position is not saved: the last valid one
 * stays.
 */
function saveAxes(world: PhysicsWorld, first: number, last: number): number {
  const { kernels, addresses, previousAddresses, scratch } = world;
  const { Position, Velocity } = addresses;
  const start = scratch.at.startVelocity;
  let valid = 1;
  const axes = AXES[world.dimensions];
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    const previous = previousAddresses.Position[axis];
    const v = Velocity[axis];
    valid &= kernels.beginAxis(previous, start[axis], Position[axis], v, MAX_POSITION, MAX_SPEED, first, last);
  }
  return valid;
}

function saveAngles(world: PhysicsWorld, first: number, last: number): void {
  const angle = ANGLES[world.dimensions];
  const current: Record<string, number> = world.addresses[angle];
  const before: Record<string, number> = world.previousAddresses[angle];
  for (const field in current) world.kernels.copyColumn(before[field], current[field], first, last);
}

/** Returns whether all positions and velocities are finite and within their limits. */
function isInRange(world: PhysicsWorld, first: number, last: number): boolean {
  const { kernels, addresses } = world;
  const { Position, Velocity } = addresses;
  let valid = 1;
  const axes = AXES[world.dimensions];
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    valid &= kernels.checkAxis(Position[axis], Velocity[axis], MAX_POSITION, MAX_SPEED, first, last);
  }
  return valid === 1;
}

/** Returns whether any body has an orientation or angular velocity; other worlds skip the checks of rotation. */
function canRotate({ internal: { counts } }: PhysicsWorld): boolean {
  return counts.AngularVelocity > 0 || counts.Rotation > 0 || counts.Orientation > 0;
}

function areAnglesValid(world: PhysicsWorld, first: number, last: number): boolean {
  if (!canRotate(world)) return true;
  const { kernels, addresses } = world;
  const { AngularVelocity: w, Rotation, Orientation: q } = addresses;
  const maxSpin = MAX_ANGULAR_SPEED;
  const limit = MAX_QUATERNION_COMPONENT;
  const valid = kernels.checkAxis(Rotation.angle, w.z, MAX_ANGLE, maxSpin, first, last);
  if (world.dimensions === 2) return valid === 1;
  const spatialValid =
    kernels.checkAxis(w.x, w.y, maxSpin, maxSpin, first, last) &
    kernels.checkAxis(q.x, q.y, limit, limit, first, last) &
    kernels.checkAxis(q.z, q.w, limit, limit, first, last);
  return (valid & spatialValid) === 1;
}

/** The largest magnitude of each column of a body. */
const LIMITS = [
  ['Position', MAX_POSITION],
  ['Orientation', MAX_QUATERNION_COMPONENT],
  ['Rotation', MAX_ANGLE],
  ['Velocity', MAX_SPEED],
  ['AngularVelocity', MAX_ANGULAR_SPEED],
] as const;

/** Networks of springs may need shorter steps than each spring by itself, of which `step` knows. */
const SPRING_HINT = {
  hint: 'Springs may be the cause: a network needs steps shorter than each of its springs does. Use a smaller dt, softer springs, or the integrator xpbd(); or check the force that accelerates the body.',
};

function springHint({ internal, integrator }: PhysicsWorld): { readonly hint?: string } {
  return internal.counts.Spring > 0 && integrator.solvesSprings !== true ? SPRING_HINT : {};
}

/**
 * Quarantines a body with an invalid value. A finite speed beyond the limit that a force or contact has caused is
 * clamped instead; one that user code has written would carry the body thousands of kilometres within the step.
 */
function repairRow(world: PhysicsWorld, row: number, phase: When, law?: string): void {
  for (const [name, limit] of LIMITS) {
    const columns: Columns = world.components[name];
    let isReported = false;
    for (const axis in columns) {
      const value = columns[axis][row];
      if (Math.abs(value) <= limit) continue;
      const field = `${name}.${axis}`;
      const isWritten = phase === 'begin' && name === 'Velocity';
      if (isWritten || name in world.previous || !Number.isFinite(value)) {
        quarantine(world, row, field, value, phase, law);
        return;
      }
      if (!isReported) reportFault(world, { code: 'E_SPEED', entity: row, field, value, phase, ...springHint(world) });
      isReported = true;
      columns[axis][row] = Math.sign(value) * limit;
    }
  }
}

/**
 * Keeps quarantined bodies at rest where they are, until their Position or Velocity is set or they lose `Quarantined`.
 * It runs after the bodies have moved, and again after contacts.
 */
export function holdQuarantined(world: PhysicsWorld): void {
  const { counts, stepFaults } = world.internal;
  // A body that was quarantined in this step gets the component at its end.
  if (counts.Quarantined === 0 && stepFaults.length === 0) return;
  const quarantined = query(world, [world.components.Quarantined]);
  for (let i = 0; i < quarantined.length; i++) stop(world, quarantined[i]);
}

/** Stops a body at its position at the start of the step. */
function quarantine(
  world: PhysicsWorld,
  row: number,
  field: string,
  value: number,
  phase: When,
  law: string | undefined,
): void {
  stop(world, row);
  // The restored pose may differ from the one that renderers read last.
  world.versions.pose++;
  reportOnce(world, row, field, value, phase, law);
}

function stop(world: PhysicsWorld, row: number): void {
  copyPose(world.previous, world.components, row);
  const { Velocity, AngularVelocity } = world.components;
  for (let a = 0; a < 3; a++) {
    const axis = AXES[3][a];
    Velocity[axis][row] = 0;
    AngularVelocity[axis][row] = 0;
  }
}

/** Reports the fault of a body, once until its values are corrected. */
function reportOnce(world: PhysicsWorld, row: number, field: string, value: number, phase: When, law?: string): void {
  const { Quarantined } = world.components;
  // Asks bitECS rather than the rows, which are updated only at the end of the step.
  const isBody = isOpen(world, row, 'Position') && entityExists(world, row);
  if (!isBody || hasComponent(world, row, Quarantined)) return;
  const code = Number.isFinite(value) ? 'E_RANGE' : 'E_NONFINITE';
  const blame =
    law === undefined ? {} : { law, hint: `Check the law "${law}": its force on the body is not a finite number.` };
  reportFault(world, { code, entity: row, field, value, phase, ...blame });
  addComponent(world, row, set(Quarantined, { step: world.tick }));
}

/**
 * Clears non-finite forces and quarantines the bodies, because a spring would propagate such a value within the step.
 */
export function quarantineBadForces(world: PhysicsWorld, first: number, last: number): void {
  const { x, y, z } = world.scratch.at.force;
  const { checkAxis } = world.kernels;
  let valid = checkAxis(x, y, MAX_FORCE, MAX_FORCE, first, last);
  if (world.dimensions === 3) valid &= checkAxis(z, z, MAX_FORCE, MAX_FORCE, first, last);
  if (valid === 1) return;
  const { force } = world.scratch;
  for (let row = first; row < last; row++) {
    for (const axis of AXES[world.dimensions]) {
      if (Math.abs(force[axis][row]) <= MAX_FORCE) continue;
      reportOnce(world, row, `force.${axis}`, force[axis][row], 'finish');
      for (const each of AXES[world.dimensions]) force[each][row] = 0;
    }
  }
}

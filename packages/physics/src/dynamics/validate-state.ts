// Values anyone may have written, or a force may have produced, made good again.
//
// Before a step every row is looked at as its pose is saved, so that a bad value someone wrote never enters a force or
// a contact; after the step once more, so that nobody ever reads a bad one. Both looks are part of kernels that touch
// the rows anyway; the code here runs for rows that failed.
import { addComponent, entityExists, hasComponent, set } from 'bitecs';
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

type When = 'begin' | 'finish';

/** Largest |force| along an axis, N; f32 ends a little above. */
const MAX_FORCE = 3e38;

/** Saves poses, and puts right what was written between steps. First system of every preset. */
export const beginStep: LocalSystem = { name: 'begin', role: 'begin', run: forEachRange(beginRun) };

/** Finds what the step itself made bad. Last system of every preset. */
export const validateState: LocalSystem = { name: 'check finite', role: 'check', run: forEachRange(checkRun) };

function beginRun(world: PhysicsWorld, first: number, last: number): void {
  // Positions and velocities are the business of the loop that reads them anyway.
  const isFused = world.internal.plan?.fusion?.begin === true;
  const isGood = isFused || saveAxes(world, first, last) === 1;
  if (!isGood || !anglesGood(world, first, last)) {
    repairRows(world, first, last, 'begin');
    if (!isFused) saveAxes(world, first, last);
  }
  if (canTurn(world)) saveAngles(world, first, last);
}

/**
 * Looks at rows one by one, caps speeds and quarantines bodies that cannot go on.
 * @param laws by row, the law that is to blame
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

/** Saves positions and velocities; 1 when all were good. A bad position is not saved: the last good one stays. */
function saveAxes(world: PhysicsWorld, first: number, last: number): number {
  const { kernels, addresses, previousAddresses, scratch } = world;
  const { Position, Velocity } = addresses;
  const start = scratch.at.startVelocity;
  let good = 1;
  const axes = AXES[world.dimensions];
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    const previous = previousAddresses.Position[axis];
    const v = Velocity[axis];
    good &= kernels.beginAxis(previous, start[axis], Position[axis], v, MAX_POSITION, MAX_SPEED, first, last);
  }
  return good;
}

function saveAngles(world: PhysicsWorld, first: number, last: number): void {
  const angle = ANGLES[world.dimensions];
  const now: Record<string, number> = world.addresses[angle];
  const before: Record<string, number> = world.previousAddresses[angle];
  for (const part in now) world.kernels.copyColumn(before[part], now[part], first, last);
}

function checkRun(world: PhysicsWorld, first: number, last: number): void {
  clearMissing(world, first, last);
  const isChecked = world.internal.plan?.fusion?.check === true;
  if ((isChecked || isInRange(world, first, last)) && anglesGood(world, first, last)) return;
  repairRows(world, first, last, 'finish');
}

/** Whether all positions and velocities are numbers within their limits. */
export function isInRange(world: PhysicsWorld, first: number, last: number): boolean {
  const { kernels, addresses } = world;
  const { Position, Velocity } = addresses;
  let good = 1;
  const axes = AXES[world.dimensions];
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    good &= kernels.checkAxis(Position[axis], Velocity[axis], MAX_POSITION, MAX_SPEED, first, last);
  }
  return good === 1;
}

/** Whether any body has an angle or turns: most worlds of particles pay nothing for those that do. */
function canTurn({ internal: { counts } }: PhysicsWorld): boolean {
  return counts.AngularVelocity > 0 || counts.Rotation > 0 || counts.Orientation > 0;
}

function anglesGood(world: PhysicsWorld, first: number, last: number): boolean {
  if (!canTurn(world)) return true;
  const { kernels, addresses } = world;
  const { AngularVelocity: w, Rotation, Orientation: q } = addresses;
  const most = MAX_ANGULAR_SPEED;
  const part = MAX_QUATERNION_COMPONENT;
  const good =
    kernels.checkAxis(w.x, w.y, most, most, first, last) &
    kernels.checkAxis(Rotation.angle, w.z, MAX_ANGLE, most, first, last);
  if (world.dimensions === 2) return good === 1;
  const whole =
    kernels.checkAxis(q.x, q.y, part, part, first, last) & kernels.checkAxis(q.z, q.w, part, part, first, last);
  return (good & whole) === 1;
}

/** The largest size of what a row of a body holds. */
const LIMITS = [
  ['Position', MAX_POSITION],
  ['Orientation', MAX_QUATERNION_COMPONENT],
  ['Rotation', MAX_ANGLE],
  ['Velocity', MAX_SPEED],
  ['AngularVelocity', MAX_ANGULAR_SPEED],
] as const;

/** Caps speeds beyond their limit; with anything else that is wrong a body cannot go on. */
function repairRow(world: PhysicsWorld, row: number, phase: When, law?: string): void {
  for (const [name, limit] of LIMITS) {
    const columns: Columns = world.components[name];
    let isTold = false;
    for (const axis in columns) {
      const value = columns[axis][row];
      if (Math.abs(value) <= limit) continue;
      const field = `${name}.${axis}`;
      if (name in world.previous || !Number.isFinite(value)) {
        quarantine(world, row, field, value, phase, law);
        return;
      }
      if (!isTold) reportFault(world, { code: 'E_SPEED', entity: row, field, value, phase });
      isTold = true;
      columns[axis][row] = Math.sign(value) * limit;
    }
  }
}

/** Puts a body to rest where it was when the step began. */
function quarantine(
  world: PhysicsWorld,
  row: number,
  field: string,
  value: number,
  phase: When,
  law: string | undefined,
): void {
  copyPose(world.previous, world.components, row);
  // What was good when it was last drawn may be another pose than that.
  world.versions.pose++;
  for (const axis of AXES[3]) {
    world.components.Velocity[axis][row] = 0;
    world.components.AngularVelocity[axis][row] = 0;
  }
  tag(world, row, field, value, phase, law);
}

/** Reports a body that went wrong, once for as long as nobody puts it in order. */
function tag(world: PhysicsWorld, row: number, field: string, value: number, phase: When, law?: string): void {
  const { Quarantined } = world.components;
  // bitECS is asked, not the rows: those learn of a quarantine, or of an entity's end, when the step is over.
  const isBody = isOpen(world, row, 'Position') && entityExists(world, row);
  if (!isBody || hasComponent(world, row, Quarantined)) return;
  const code = Number.isFinite(value) ? 'E_RANGE' : 'E_NONFINITE';
  const blame =
    law === undefined ? {} : { law, hint: `Look at the law "${law}": its force on the body is not a finite number.` };
  reportFault(world, { code, entity: row, field, value, phase, ...blame });
  addComponent(world, row, set(Quarantined, { step: world.tick }));
}

/**
 * Drops forces that are not finite, of bodies that others are joined to: a spring would carry them on before the step
 * is over. Called after each evaluation where forces or the integrator look at more than one body; elsewhere a bad force
 * stays with its body, and is found when the step ends.
 */
export function quarantineBadForces(world: PhysicsWorld, first: number, last: number): void {
  const { x, y, z } = world.scratch.at.force;
  const { checkAxis } = world.kernels;
  let good = checkAxis(x, y, MAX_FORCE, MAX_FORCE, first, last);
  if (world.dimensions === 3) good &= checkAxis(z, z, MAX_FORCE, MAX_FORCE, first, last);
  if (good === 1) return;
  const { force } = world.scratch;
  for (let row = first; row < last; row++) {
    for (const axis of AXES[world.dimensions]) {
      if (Math.abs(force[axis][row]) <= MAX_FORCE) continue;
      tag(world, row, `force.${axis}`, force[axis][row], 'finish');
      for (const each of AXES[world.dimensions]) force[each][row] = 0;
    }
  }
}

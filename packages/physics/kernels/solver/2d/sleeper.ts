// What sleep keeps of a body, by row.
import { columns, get } from '../../memory/columns';
import { RigidTable } from './rigid-table';
import { word } from './body';

// First what is compared in each step while a body sleeps.
@unmanaged
export class Sleeper {
  // Force, torque and angle when it fell asleep; of what does not sleep, the angle when the last step began.
  fx: real;
  fy: real;
  torque: real;
  angle: real;
  // The change of acceleration that wakes it, m/s².
  wakingAcceleration: real;
  // The collider in the last step, also of what does not move.
  radius: real;
  friction: real;
  tangentSpeed: real;
  rollingResistance: real;
  frictionCombine: i32;
  shape: i32;
  // Which of its axes were locked when it fell asleep.
  locks: i32;
  // Whether it was put to sleep in the last step, so that the forces on it at rest are not known yet.
  isStopped: i32;
  // The island that the body belongs to in this step, and the next body of its sleeping island: they form a ring.
  island: i32;
  next: i32;
  // What holds the body, and in the first body of an island what holds that (still-bodies.ts).
  holds: i32;
  // Time for which the body has been still, s.
  stillFor: real;
  // The least speed in this time, m/s, and the mean velocity of late, m/s and rad/s.
  slowest: real;
  meanX: real;
  meanY: real;
  meanW: real;
  // Time for which that mean was as small as it must be for what only joints hold, s.
  steadyFor: real;
  // Time for which it has hardly moved and no force has acted on it, s.
  freeFor: real;
  // Of a body that has become lighter: the inverse mass in the last step, 1/kg.
  formerInverseMass: real;
}

const SIZE: usize = (offsetof<Sleeper>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline export function sleeperOf(t: RigidTable, row: i32): Sleeper {
  return changetype<Sleeper>(t.sleepers + <usize>row * SIZE);
}

// Whether the collider of a body changed since the last step: its shape, or its surface.
export function hasNewCollider(t: RigidTable, row: i32): bool {
  const c = columns();
  const sleeper = sleeperOf(t, row);
  if (word(c.shape, row) != sleeper.shape || get(c.radius, row) != sleeper.radius) return true;
  if (get(c.friction, row) != sleeper.friction || get(t.tangentSpeed, row) != sleeper.tangentSpeed) return true;
  return frictionRule(t, row) != sleeper.frictionCombine || resistance(t, row) != sleeper.rollingResistance;
}

// These two columns are read only where colliders use them.
// @ts-ignore: decorator
@inline function resistance(t: RigidTable, row: i32): real {
  return t.usesResistance == 0 ? <real>0 : get(t.rollingResistance, row);
}

// @ts-ignore: decorator
@inline function frictionRule(t: RigidTable, row: i32): i32 {
  return t.usesColliderFlags == 0 ? 0 : word(t.frictionCombine, row);
}

// Records the collider of this step.
export function recordCollider(t: RigidTable, row: i32): void {
  const c = columns();
  const sleeper = sleeperOf(t, row);
  sleeper.shape = word(c.shape, row);
  sleeper.radius = get(c.radius, row);
  sleeper.friction = get(c.friction, row);
  sleeper.tangentSpeed = get(t.tangentSpeed, row);
  sleeper.frictionCombine = frictionRule(t, row);
  sleeper.rollingResistance = resistance(t, row);
}

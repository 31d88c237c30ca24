// What sleep keeps of a body, by row.
import { columns, get } from '../../memory/columns';
import { RigidTable } from './rigid-table';
import { word } from './body';

@unmanaged
export class Sleeper {
  // Time for which the body has been still, s.
  stillFor: real;
  // The least speed in this time, m/s.
  slowest: real;
  // Force, torque and angle when it fell asleep; of what does not move, the angle in the last step.
  fx: real;
  fy: real;
  torque: real;
  angle: real;
  // The collider in the last step, also of what does not move.
  radius: real;
  friction: real;
  tangentSpeed: real;
  shape: i32;
  // The island that the body belongs to in this step, and the next body of its sleeping island: they form a ring.
  island: i32;
  next: i32;
}

const SIZE: usize = (offsetof<Sleeper>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline export function sleeperOf(t: RigidTable, row: i32): Sleeper {
  return changetype<Sleeper>(t.sleepers + <usize>row * SIZE);
}

// Whether the collider of a body changed since the last step: its shape, its friction, or the speed of its surface.
export function hasNewCollider(t: RigidTable, row: i32): bool {
  const c = columns();
  const sleeper = sleeperOf(t, row);
  if (word(c.shape, row) != sleeper.shape || get(c.radius, row) != sleeper.radius) return true;
  return get(c.friction, row) != sleeper.friction || get(t.tangentSpeed, row) != sleeper.tangentSpeed;
}

// Records the collider of this step.
export function recordCollider(t: RigidTable, row: i32): void {
  const c = columns();
  const sleeper = sleeperOf(t, row);
  sleeper.shape = word(c.shape, row);
  sleeper.radius = get(c.radius, row);
  sleeper.friction = get(c.friction, row);
  sleeper.tangentSpeed = get(t.tangentSpeed, row);
}

// What sleep keeps of a body, by row.
import { RigidTable } from './rigid-table';

@unmanaged
export class Sleeper {
  // Time for which the body has been still, s.
  stillFor: real;
  // The least speed in this time, m/s.
  slowest: real;
  // Force, torque and angle when it fell asleep.
  fx: real;
  fy: real;
  torque: real;
  angle: real;
  // The island that the body belongs to in this step, and the next body of its sleeping island: they form a ring.
  island: i32;
  next: i32;
}

const SIZE: usize = (offsetof<Sleeper>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline export function sleeperOf(t: RigidTable, row: i32): Sleeper {
  return changetype<Sleeper>(t.sleepers + <usize>row * SIZE);
}

// Centres of attraction as a table for the law: src/forces/attractors.ts.
import { columns, get, isWaiting } from '../memory/columns';

// A centre at the start of the step. All fields are f64 in both precisions.
@unmanaged
export class Centre {
  x: f64;
  y: f64;
  z: f64;
  vx: f64;
  vy: f64;
  vz: f64;
  mu: f64;
  softeningSquared: f64;
  entity: f64;
}

const CENTRE_BYTES: usize = offsetof<Centre>();

// Copies the attractors with the given ids, so that the force of a step does not depend on which centres moved
// before. Centres with non-finite values are zeroed, because they would spoil every body; returns their number.
export function gatherAttractors(ids: usize, count: i32, mu: usize, softening: usize, centres: usize): i32 {
  const c = columns();
  let invalidCount = 0;
  for (let i = 0; i < count; i++) {
    const row = load<i32>(ids + ((<usize>i) << 2));
    const centre = changetype<Centre>(centres + <usize>i * CENTRE_BYTES);
    const soft = <f64>get(softening, row);
    centre.x = get(c.positionX, row);
    centre.y = get(c.positionY, row);
    centre.z = get(c.positionZ, row);
    centre.vx = get(c.velocityX, row);
    centre.vy = get(c.velocityY, row);
    centre.vz = get(c.velocityZ, row);
    centre.mu = get(mu, row);
    centre.softeningSquared = soft * soft;
    centre.entity = row;
    const sum = centre.x + centre.y + centre.z + centre.vx + centre.vy + centre.vz + centre.mu + soft;
    const isValid = sum - sum == 0;
    if (isValid && !isWaiting(row)) continue;
    memory.fill(changetype<usize>(centre), 0, offsetof<Centre>('entity'));
    if (!isValid) invalidCount++;
  }
  return invalidCount;
}

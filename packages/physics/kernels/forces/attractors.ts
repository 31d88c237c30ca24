// Centres of attraction as rows of numbers that the law reads: src/forces/attractors.ts.
import { columns, get } from '../memory/columns';

// A centre as it was when the step began. All f64, whatever the columns are.
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

// Copies the attractors with the given ids: the pull of a step must not depend on which of them moved before.
// One whose values are not finite pulls nothing, lest it take every body along; returns how many there are.
export function gatherAttractors(ids: usize, count: i32, mu: usize, softening: usize, centres: usize): i32 {
  const c = columns();
  let bad = 0;
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
    if (sum - sum == 0) continue;
    memory.fill(changetype<usize>(centre), 0, offsetof<Centre>('entity'));
    bad++;
  }
  return bad;
}

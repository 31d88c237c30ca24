// Fixed charges as a table for the law: src/forces/fixed-charges.ts.
import { columns, get, isWaiting } from '../memory/columns';

// A source at the start of the step: position, charge, and the radius inside which it does not act. f64.
@unmanaged
export class Source {
  x: f64;
  y: f64;
  z: f64;
  charge: f64;
  radius: f64;
}

// Copies the bodies of `ids` without mass to `sources` and returns their number, or -1 - n if a non-finite charge was
// skipped.
export function gatherCharges(ids: usize, count: i32, charge: usize, sources: usize): i32 {
  const c = columns();
  let sourceCount = 0;
  let hasInvalid = false;
  for (let i = 0; i < count; i++) {
    const row = load<i32>(ids + ((<usize>i) << 2));
    const q = <f64>get(charge, row);
    // Only bodies without mass are sources; a NaN mass does not qualify.
    if (get(c.mass, row) != 0 || q == 0 || isWaiting(row)) continue;
    if (q - q != 0) {
      hasInvalid = true;
      continue;
    }
    const source = changetype<Source>(sources + <usize>sourceCount * offsetof<Source>());
    source.x = get(c.positionX, row);
    source.y = get(c.positionY, row);
    source.z = get(c.positionZ, row);
    source.charge = q;
    source.radius = get(c.radius, row);
    sourceCount++;
  }
  return hasInvalid ? -1 - sourceCount : sourceCount;
}

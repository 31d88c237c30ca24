// Fixed charges as a table for the law: src/forces/fixed-charges.ts.
import { columns, get } from '../memory/columns';

// A source at the start of the step: position, charge, and the radius inside which it does not act. f64.
const SOURCE_BYTES: usize = 40;

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
    if (get(c.mass, row) != 0 || q == 0) continue;
    if (q - q != 0) {
      hasInvalid = true;
      continue;
    }
    const source = sources + <usize>sourceCount * SOURCE_BYTES;
    store<f64>(source, get(c.positionX, row));
    store<f64>(source, get(c.positionY, row), 8);
    store<f64>(source, get(c.positionZ, row), 16);
    store<f64>(source, q, 24);
    store<f64>(source, get(c.radius, row), 32);
    sourceCount++;
  }
  return hasInvalid ? -1 - sourceCount : sourceCount;
}

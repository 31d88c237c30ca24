// Fixed charges as rows of numbers that the law reads: src/forces/fixed-charges.ts.
import { columns, get } from '../memory/columns';

// A source as it was when the step began: position, charge, and the radius inside which it does not act. f64.
@unmanaged
export class Source {
  x: f64;
  y: f64;
  z: f64;
  charge: f64;
  radius: f64;
}

// Copies the bodies of `ids` that have no mass to `sources` and returns their number, or -1 - n when a charge was not
// finite and stayed out.
export function gatherCharges(ids: usize, count: i32, charge: usize, sources: usize): i32 {
  const c = columns();
  let kept = 0;
  let bad = false;
  for (let i = 0; i < count; i++) {
    const row = load<i32>(ids + ((<usize>i) << 2));
    const q = <f64>get(charge, row);
    // Only who has no mass is a source: one whose mass is not a number stays out.
    if (get(c.mass, row) != 0 || q == 0) continue;
    if (q - q != 0) {
      bad = true;
      continue;
    }
    const source = changetype<Source>(sources + <usize>kept * offsetof<Source>());
    source.x = get(c.positionX, row);
    source.y = get(c.positionY, row);
    source.z = get(c.positionZ, row);
    source.charge = q;
    source.radius = get(c.radius, row);
    kept++;
  }
  return bad ? -1 - kept : kept;
}

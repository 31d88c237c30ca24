// A chain of rods between two anchors that are farther apart than it is long cannot keep its lengths: it lies straight
// between them, and all rods have the same strain and an infinite tension.
import { get, put } from '../memory/columns';
import { ConstraintTable, packedAt, packedComponent, putPackedComponent, word } from './table';

// Returns false, and moves no body, if the chain of rows [first, last) is not of this kind.
export function stretchBetweenAnchors(t: ConstraintTable, first: i32, last: i32): bool {
  const a = packedAt(t, word(t.a, first));
  const b = packedAt(t, word(t.b, last - 1));
  if (packedComponent(a, 3) != 0 || packedComponent(b, 3) != 0) return false;
  let length: f64 = 0;
  for (let row = first; row < last; row++) {
    if (!(get(t.gain, row) > 0 && get(t.softness, row) == 0)) return false;
    length += abs<f64>(<f64>get(t.length, row));
  }
  const startX = <f64>packedComponent(a, 0);
  const startY = <f64>packedComponent(a, 1);
  const startZ = <f64>packedComponent(a, 2);
  const x = <f64>packedComponent(b, 0) - startX;
  const y = <f64>packedComponent(b, 1) - startY;
  const z = <f64>packedComponent(b, 2) - startZ;
  if (!(length > 0 && x * x + y * y + z * z > length * length)) return false;
  let along: f64 = 0;
  for (let row = first; row < last; row++) {
    put(t.tension, row, Infinity);
    if (row == last - 1) break;
    along += abs<f64>(<f64>get(t.length, row)) / length;
    const p = packedAt(t, word(t.b, row));
    putPackedComponent(p, 0, <real>(startX + along * x));
    putPackedComponent(p, 1, <real>(startY + along * y));
    putPackedComponent(p, 2, <real>(startZ + along * z));
  }
  return true;
}

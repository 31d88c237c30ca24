// The viscous damping of springs, one row after the other.
import { columns, get, put } from '../memory/columns';
import { SpringTable } from '../forces/springs';
import { ConstraintTable, RIGID, isTensionOnly, packedAt, packedComponent, tableAt, word } from './table';

// Damps implicitly: removes the share c h w / (1 + c h w) of the extension rate u, which is stable at any damping.
export function dampConstraints(table: usize, h: f64): void {
  const t = tableAt(table);
  const springs = changetype<SpringTable>(t.springs);
  for (let row = 0; row < t.rowCount; row++) {
    const spring = word(t.springIds, row);
    if (spring == 0) continue;
    const damping = <f64>get(springs.damping, spring);
    if (damping == 0 || <f64>get(springs.stiffness, spring) >= RIGID) continue;
    if (isTensionOnly(get(t.length, row)) && get(t.tension, row) <= 0) continue;
    const w =
      <f64>packedComponent(packedAt(t, word(t.a, row)), 3) + <f64>packedComponent(packedAt(t, word(t.b, row)), 3);
    const rate = damping * h * w;
    dampRow(t, row, rate / (1 + rate), isTensionOnly(get(t.length, row)));
  }
}

// Removes a share of the extension rate; a tension-only row only resists extension.
function dampRow(t: ConstraintTable, row: i32, share: f64, tensionOnly: bool): void {
  const c = columns();
  const a = word(t.a, row);
  const b = word(t.b, row);
  const x = <f64>get(c.positionX, b) - <f64>get(c.positionX, a);
  const y = <f64>get(c.positionY, b) - <f64>get(c.positionY, a);
  const z = <f64>get(c.positionZ, b) - <f64>get(c.positionZ, a);
  const square = x * x + y * y + z * z;
  const wa = <f64>packedComponent(packedAt(t, a), 3);
  const wb = <f64>packedComponent(packedAt(t, b), 3);
  if (!(square > 1e-30) || wa + wb == 0) return;
  const rate =
    x * (<f64>get(c.velocityX, b) - <f64>get(c.velocityX, a)) +
    y * (<f64>get(c.velocityY, b) - <f64>get(c.velocityY, a)) +
    z * (<f64>get(c.velocityZ, b) - <f64>get(c.velocityZ, a));
  if (tensionOnly && rate < 0) return;
  const impulse = (share * rate) / (square * (wa + wb));
  addVelocity(a, impulse * wa, x, y, z);
  addVelocity(b, -impulse * wb, x, y, z);
}

// @ts-ignore: decorator
@inline function addVelocity(body: u32, by: f64, x: f64, y: f64, z: f64): void {
  const c = columns();
  put(c.velocityX, body, <real>(<f64>get(c.velocityX, body) + by * x));
  put(c.velocityY, body, <real>(<f64>get(c.velocityY, body) + by * y));
  put(c.velocityZ, body, <real>(<f64>get(c.velocityZ, body) + by * z));
}

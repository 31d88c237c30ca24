// Drift and kick, the operations of integrators, for one axis. A body without mass (m = 0) keeps its velocity.
import { LANES, accelerationOf, add, at, mul, splat } from '../memory/lanes';

// Kick: v += F/m dt.
export function kickAxis(v: usize, force: usize, mass: usize, dt: real, first: i32, last: i32): void {
  const h = splat(dt);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const a = accelerationOf(v128.load(force + o), v128.load(mass + o));
    v128.store(v + o, add(v128.load(v + o), mul(a, h)));
  }
}

// Drift: x += v dt.
export function driftAxis(x: usize, v: usize, dt: real, first: i32, last: i32): void {
  const h = splat(dt);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    v128.store(x + o, add(v128.load(x + o), mul(v128.load(v + o), h)));
  }
}

import { LANES, add, at, mul, splat } from '../lanes';

// F += m g along one axis.
export function uniformGravityAxis(force: usize, mass: usize, g: real, first: i32, last: i32): void {
  const acceleration = splat(g);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    v128.store(force + o, add(v128.load(force + o), mul(v128.load(mass + o), acceleration)));
  }
}

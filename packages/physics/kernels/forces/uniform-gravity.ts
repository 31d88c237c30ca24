import { BLOCK, LANES, add, at, mul, splat } from '../lanes';

// F += m g along one axis.
export function uniformGravityAxis(force: usize, mass: usize, g: real, first: i32, last: i32): void {
  const acceleration = splat(g);
  for (let row = first; row < last; row += BLOCK) {
    const o = at(row);
    fall(force + o, mass + o, acceleration);
    fall(force + o + 16, mass + o + 16, acceleration);
    fall(force + o + 32, mass + o + 32, acceleration);
    fall(force + o + 48, mass + o + 48, acceleration);
  }
}

// @ts-ignore: decorator
@inline function fall(force: usize, mass: usize, acceleration: v128): void {
  v128.store(force, add(v128.load(force), mul(v128.load(mass), acceleration)));
}

// F = m g along one axis, whatever stood there.
export function assignGravityAxis(force: usize, mass: usize, g: real, first: i32, last: i32): void {
  if (g == 0) return memory.fill(force + at(first), 0, at(last - first));
  const acceleration = splat(g);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    v128.store(force + o, mul(v128.load(mass + o), acceleration));
  }
}

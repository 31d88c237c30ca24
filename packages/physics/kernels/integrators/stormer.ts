// Stoermer's step for one axis: positions carry the motion, velocities are read off them.
import { accelerationOf, add, at, LANES, mul, splat } from '../lanes';

// A body goes on with the displacement of its last step where nobody has moved or pushed it since (`leftX`, `leftV`
// hold what the last step left); otherwise it starts afresh with x(-dt) = x - v dt + a dt^2/2. `ratio` is dt over the
// last dt, zero at the first step.
export function stormerAxis(
  x: usize,
  v: usize,
  displacement: usize,
  leftX: usize,
  leftV: usize,
  force: usize,
  mass: usize,
  dt: real,
  ratio: real,
  first: i32,
  last: i32,
): void {
  const h = splat(dt);
  const half = splat(<real>0.5 * dt);
  const scale = splat(ratio);
  // a dt (dt + last dt)/2: with equal steps a dt^2.
  const bend = splat(ratio > 0 ? <real>0.5 * dt * (dt + dt / ratio) : dt * dt);
  const start = splat(dt * dt * <real>0.5);
  const known = v128.gt<real>(scale, splat(0));
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const position = v128.load(x + o);
    const velocity = v128.load(v + o);
    const a = accelerationOf(v128.load(force + o), v128.load(mass + o));
    const same = v128.and(v128.eq<real>(position, v128.load(leftX + o)), v128.eq<real>(velocity, v128.load(leftV + o)));
    const goesOn = add(mul(v128.load(displacement + o), scale), mul(a, bend));
    const starts = add(mul(velocity, h), mul(a, start));
    const d = v128.bitselect(goesOn, starts, v128.and(same, known));
    const moved = add(position, d);
    // The mean velocity of the step, and half a step's acceleration more.
    const after = add(v128.div<real>(d, h), mul(a, half));
    v128.store(displacement + o, d);
    v128.store(x + o, moved);
    v128.store(leftX + o, moved);
    v128.store(v + o, after);
    v128.store(leftV + o, after);
  }
}

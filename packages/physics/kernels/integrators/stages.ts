// The moves integrators are made of, for one axis. A body without mass (m = 0) keeps its velocity.
import { BLOCK, LANES, accelerationOf, add, at, mul, splat } from '../lanes';

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

// Kick, then drift with the new velocity, in one pass: the same bits as kickAxis followed by driftAxis.
export function kickDriftAxis(x: usize, v: usize, force: usize, mass: usize, dt: real, first: i32, last: i32): void {
  const h = splat(dt);
  for (let row = first; row < last; row += BLOCK) {
    const o = at(row);
    kickDrift(x + o, v + o, force + o, mass + o, h);
    kickDrift(x + o + 16, v + o + 16, force + o + 16, mass + o + 16, h);
    kickDrift(x + o + 32, v + o + 32, force + o + 32, mass + o + 32, h);
    kickDrift(x + o + 48, v + o + 48, force + o + 48, mass + o + 48, h);
  }
}

// @ts-ignore: decorator
@inline function kickDrift(x: usize, v: usize, force: usize, mass: usize, h: v128): void {
  const a = accelerationOf(v128.load(force), v128.load(mass));
  const velocity = add(v128.load(v), mul(a, h));
  v128.store(v, velocity);
  v128.store(x, add(v128.load(x), mul(velocity, h)));
}

// First half of velocity Verlet: a = F/m is kept, x += v dt + a dt^2/2, and v += a dt as the predictor that forces
// depending on velocity see at the end of the step.
export function verletPredictAxis(
  x: usize,
  v: usize,
  acceleration: usize,
  force: usize,
  mass: usize,
  dt: real,
  first: i32,
  last: i32,
): void {
  const h = splat(dt);
  const half = splat(<real>0.5 * dt);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const a = accelerationOf(v128.load(force + o), v128.load(mass + o));
    const velocity = v128.load(v + o);
    v128.store(acceleration + o, a);
    v128.store(x + o, add(v128.load(x + o), mul(add(velocity, mul(a, half)), h)));
    v128.store(v + o, add(velocity, mul(a, h)));
  }
}

// Second half of velocity Verlet: v = v(start) + (a(start) + a(end)) dt/2.
export function verletCorrectAxis(
  v: usize,
  start: usize,
  acceleration: usize,
  force: usize,
  mass: usize,
  dt: real,
  first: i32,
  last: i32,
): void {
  const half = splat(<real>0.5 * dt);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const a = add(v128.load(acceleration + o), accelerationOf(v128.load(force + o), v128.load(mass + o)));
    v128.store(v + o, add(v128.load(start + o), mul(a, half)));
  }
}

// One stage of an explicit Runge-Kutta method: with k = (v, F/m) at the stage, adds `weight` k to the running sums and
// moves the state to start + k dt `next` for the next stage.
export function rungeKuttaStageAxis(
  x: usize,
  v: usize,
  startX: usize,
  startV: usize,
  sumX: usize,
  sumV: usize,
  force: usize,
  mass: usize,
  weight: real,
  next: real,
  first: i32,
  last: i32,
): void {
  const w = splat(weight);
  const h = splat(next);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const a = accelerationOf(v128.load(force + o), v128.load(mass + o));
    const velocity = v128.load(v + o);
    v128.store(sumX + o, add(v128.load(sumX + o), mul(velocity, w)));
    v128.store(sumV + o, add(v128.load(sumV + o), mul(a, w)));
    v128.store(x + o, add(v128.load(startX + o), mul(velocity, h)));
    v128.store(v + o, add(v128.load(startV + o), mul(a, h)));
  }
}

// End of a Runge-Kutta step: state = start + dt sum.
export function rungeKuttaFinishAxis(
  x: usize,
  v: usize,
  startX: usize,
  startV: usize,
  sumX: usize,
  sumV: usize,
  dt: real,
  first: i32,
  last: i32,
): void {
  const h = splat(dt);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    v128.store(x + o, add(v128.load(startX + o), mul(v128.load(sumX + o), h)));
    v128.store(v + o, add(v128.load(startV + o), mul(v128.load(sumV + o), h)));
  }
}

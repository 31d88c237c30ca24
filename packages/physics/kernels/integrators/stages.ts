// The moves integrators are made of, for one axis. A body without mass (m = 0) keeps its velocity.
import { aheadBytes, aheadCount, readAhead } from '../ahead';
import { columns } from '../columns';
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

// Kick, then drift with the new velocity, of all axes (2 or 3) in one pass: the same bits as kickAxis followed by
// driftAxis, and time to read the next tile's rows while the divisions run.
export function kickDrift(axes: i32, fx: usize, fy: usize, fz: usize, dt: real, first: i32, last: i32): void {
  const c = columns();
  const h = splat(dt);
  const x = c.positionX;
  const y = c.positionY;
  const z = c.positionZ;
  const vx = c.velocityX;
  const vy = c.velocityY;
  const vz = c.velocityZ;
  const ahead = aheadBytes();
  const count = aheadCount();
  for (let row = first; row < last; row += BLOCK) {
    const block = at(row);
    readAhead(count, block + ahead);
    for (let o = block; o < block + 64; o += 16) {
      const mass = v128.load(c.mass + o);
      kickDriftAxis(x + o, vx + o, fx + o, mass, h);
      kickDriftAxis(y + o, vy + o, fy + o, mass, h);
      if (axes == 3) kickDriftAxis(z + o, vz + o, fz + o, mass, h);
    }
  }
}

// @ts-ignore: decorator
@inline function kickDriftAxis(x: usize, v: usize, force: usize, mass: v128, h: v128): void {
  const velocity = add(v128.load(v), mul(accelerationOf(v128.load(force), mass), h));
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

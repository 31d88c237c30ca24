// The rare case: bodies beyond a wall. They are listed while a tile of bodies moves, and rebound after it: code for them
// amid the loop would take registers from all other bodies.
import { ENTRY_BYTES, MASS, RADIUS, add, areBelow, isAll, largest, magnitude, mul, splat, sub } from './layout';
import { dt, high, low, maxPosition, maxSpeed, restitution } from './setting';

// Takes a vector into the list of an axis where a body of it is beyond a wall, and returns where the list ends then. The
// entry is written in any case, and overwritten by the next one where there was no hit: a branch would be guessed wrong.
// @ts-ignore: decorator
@inline export function noteHit(end: usize, o: usize, x: usize, start: v128, room: v128, middle: v128): usize {
  store<usize>(end, o);
  v128.store(end, start, 16);
  const isInside = isAll(v128.le<real>(magnitude(sub(v128.load(o + x), middle)), room));
  return end + <usize>!isInside * ENTRY_BYTES;
}

// Brings what a list holds back between the walls: the instant of impact inside the step, and the flight after it, as in
// packages/physics/kernels/walls. Both walls at once, as a body is beyond one of them. Semi-implicit Euler's velocities
// lag its positions by half a step. Returns 1 when all values are in range afterwards.
export function rebound(first: usize, end: usize, x: usize, v: usize): i32 {
  const zero = splat(0);
  const lag = splat(<real>0.5 * dt);
  const h = splat(dt);
  const rate = splat(<real>1 / dt);
  let speeds = i32x4.splat(0);
  let good = 1;
  for (let entry = first; entry < end; entry += ENTRY_BYTES) {
    const o = load<usize>(entry);
    const start = v128.load(entry, 16);
    const position = v128.load(x + o);
    const velocity = v128.load(v + o);
    const radius = v128.load(o, RADIUS);
    const lower = add(splat(low), radius);
    const upper = sub(splat(high), radius);
    const isLow = v128.lt<real>(position, lower);
    const plane = v128.bitselect(lower, upper, isLow);
    // The sign that turns what points outwards at this wall into what points downwards.
    const sign = v128.andnot(splat(-0.0), isLow);
    const solid = v128.and(v128.gt<real>(radius, zero), v128.gt<real>(v128.load(o, MASS), zero));
    const fits = v128.and(solid, v128.le<real>(lower, upper));
    const hit = v128.and(v128.or(isLow, v128.gt<real>(position, upper)), fits);

    const twice = mul(splat(2), v128.xor(sign, sub(plane, position)));
    const pull = mul(v128.xor(sign, sub(start, velocity)), rate);
    const speed = sub(mul(pull, lag), v128.xor(sign, velocity));
    const then = v128.sqrt<real>(v128.pmax<real>(zero, sub(mul(speed, speed), mul(pull, twice))));
    const since = v128.pmin<real>(h, v128.div<real>(twice, add(then, speed)));
    const gained = mul(pull, since);
    const impact = v128.pmax<real>(zero, sub(speed, gained));
    const leave = mul(splat(restitution), impact);
    const out = mul(since, sub(leave, mul(splat(0.5), gained)));

    const entering = v128.and(hit, v128.gt<real>(speed, zero));
    const flies = v128.and(entering, v128.and(v128.gt<real>(out, zero), v128.gt<real>(impact, zero)));
    const after = v128.xor(sign, v128.and(sub(leave, sub(gained, mul(pull, lag))), flies));
    const there = v128.bitselect(add(plane, v128.xor(sign, v128.and(out, flies))), position, hit);
    const onward = v128.bitselect(after, velocity, entering);
    v128.store(x + o, there);
    v128.store(v + o, onward);
    speeds = largest(speeds, magnitude(onward));
    if (!isAll(v128.and(v128.ge<real>(there, lower), v128.le<real>(there, upper)))) good &= hold(o, x, v);
  }
  return good & i32(areBelow(speeds, splat(maxSpeed)));
}

// Puts inside what is still beyond a wall, because it crossed the box within the step; what does not fit between the
// walls, in the middle and at rest. Returns 1 when the positions are in range; that of a body without mass may be outside.
function hold(o: usize, x: usize, v: usize): i32 {
  const zero = splat(0);
  const radius = v128.load(o, RADIUS);
  const lower = add(splat(low), radius);
  const upper = sub(splat(high), radius);
  const solid = v128.and(v128.gt<real>(radius, zero), v128.gt<real>(v128.load(o, MASS), zero));
  const tight = v128.and(solid, v128.gt<real>(lower, upper));
  const position = v128.load(x + o);
  const inside = v128.min<real>(v128.max<real>(position, lower), upper);
  const held = v128.bitselect(mul(splat(0.5), add(lower, upper)), inside, tight);
  const there = v128.bitselect(held, position, solid);
  v128.store(x + o, there);
  v128.store(v + o, v128.andnot(v128.load(v + o), tight));
  return i32(isAll(v128.le<real>(magnitude(there), splat(maxPosition))));
}

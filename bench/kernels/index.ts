// The reference the composed systems of the scene `particles` are measured against: one loop that does all their work
// on a body while it is in registers. It saves the pose, sees that all values are in range, adds gravity and quadratic
// drag, moves by semi-implicit Euler, bounces in the box and looks at the values once more. Same arithmetic in the same
// order as packages/physics/kernels, so the final states are equal to the last bit; a test holds them together.
// Nothing is shared with those kernels on purpose: a change there must not change what it is compared with.

// @ts-ignore: decorator
@inline const LANES: i32 = 16 / sizeof<real>();

// @ts-ignore: decorator
@inline function splat(value: real): v128 {
  return v128.splat<real>(value);
}

// @ts-ignore: decorator
@inline function add(a: v128, b: v128): v128 {
  return v128.add<real>(a, b);
}

// @ts-ignore: decorator
@inline function sub(a: v128, b: v128): v128 {
  return v128.sub<real>(a, b);
}

// @ts-ignore: decorator
@inline function mul(a: v128, b: v128): v128 {
  return v128.mul<real>(a, b);
}

// @ts-ignore: decorator
@inline function inRange(value: v128, limit: v128): v128 {
  return v128.le<real>(v128.abs<real>(value), limit);
}

// What all bodies share. It stands in the reserved first page of the world's memory, behind the engine's own table.
@unmanaged
class Setting {
  low: real;
  high: real;
  gravityX: real;
  gravityY: real;
  gravityZ: real;
  restitution: real;
  maxPosition: real;
  maxSpeed: real;
  dt: real;
}

// Where the columns start, as many words as the class has fields.
@unmanaged
class Columns {
  x: usize;
  y: usize;
  z: usize;
  vx: usize;
  vy: usize;
  vz: usize;
  previousX: usize;
  previousY: usize;
  previousZ: usize;
  mass: usize;
  drag: usize;
  radius: usize;
  restitution: usize;
}

// @ts-ignore: decorator
@inline function savePose(previous: usize, position: v128, limit: v128): v128 {
  const good = inRange(position, limit);
  if (i32x4.all_true(good)) v128.store(previous, position);
  else v128.store(previous, v128.bitselect(position, v128.load(previous), good));
  return good;
}

// A body so fast that it crosses the box within a step meets both walls; after this many it is put inside.
const MOST_BOUNCES: i32 = 4;

// The velocity at the start of the step, which a rebound moves along.
let start: v128 = i32x4.splat(0);

// One wall: the instant of impact inside the step, and the flight after it. The lanes of `hit` are beyond `plane`.
// Semi-implicit Euler's velocities lag its positions by half a step.
// @ts-ignore: decorator
@inline function rebound(
  x: usize,
  v: usize,
  plane: v128,
  side: v128,
  hit: v128,
  restitution: v128,
  dt: v128,
): void {
  const zero = splat(0);
  const position = v128.load(x);
  const velocity = v128.load(v);
  const lag = mul(splat(0.5), dt);
  const depth = mul(side, sub(plane, position));
  const pull = v128.div<real>(mul(side, sub(start, velocity)), dt);
  const speed = add(v128.neg<real>(mul(side, velocity)), mul(pull, lag));
  const twice = add(depth, depth);
  const then = v128.sqrt<real>(v128.max<real>(sub(mul(speed, speed), mul(pull, twice)), zero));
  const since = v128.min<real>(v128.div<real>(twice, add(then, speed)), dt);
  const impact = v128.max<real>(sub(speed, mul(pull, since)), zero);
  const leave = mul(restitution, impact);
  const out = mul(since, sub(leave, mul(splat(0.5), mul(pull, since))));
  const entering = v128.and(hit, v128.gt<real>(speed, zero));
  const flies = v128.and(entering, v128.and(v128.gt<real>(out, zero), v128.gt<real>(impact, zero)));
  const after = mul(side, v128.and(sub(leave, mul(pull, sub(since, lag))), flies));
  v128.store(x, v128.bitselect(add(plane, v128.and(mul(side, out), flies)), position, hit));
  v128.store(v, v128.bitselect(after, velocity, entering));
  start = v128.bitselect(add(start, v128.and(sub(after, velocity), flies)), start, flies);
  start = v128.andnot(start, v128.andnot(entering, flies));
}

// The rare case: some bodies of a vector are beyond a wall.
function bounce(x: usize, v: usize, mass: usize, radius: usize, bounciness: usize, setting: usize): void {
  const s = changetype<Setting>(setting);
  const zero = splat(0);
  const dt = splat(s.dt);
  const r = v128.load(radius);
  const lower = add(splat(s.low), r);
  const upper = sub(splat(s.high), r);
  const solid = v128.and(v128.gt<real>(r, zero), v128.gt<real>(v128.load(mass), zero));
  const fits = v128.and(solid, v128.le<real>(lower, upper));
  const e = v128.max<real>(v128.load(bounciness), splat(s.restitution));
  for (let turn = 0; turn < MOST_BOUNCES; turn++) {
    const position = v128.load(x);
    const hitLow = v128.and(v128.lt<real>(position, lower), fits);
    const hitHigh = v128.and(v128.gt<real>(position, upper), fits);
    if (!v128.any_true(v128.or(hitLow, hitHigh))) break;
    if (v128.any_true(hitLow)) rebound(x, v, lower, splat(1), hitLow, e, dt);
    if (v128.any_true(hitHigh)) rebound(x, v, upper, splat(-1), hitHigh, e, dt);
  }
  const position = v128.load(x);
  const inside = v128.min<real>(v128.max<real>(position, lower), upper);
  const tight = v128.and(solid, v128.gt<real>(lower, upper));
  const held = v128.bitselect(mul(splat(0.5), add(lower, upper)), position, tight);
  v128.store(x, v128.bitselect(inside, held, fits));
  v128.store(v, v128.andnot(v128.load(v), tight));
}

// Kick, drift, walls and the last look for one axis of the vector of bodies at `o`.
// @ts-ignore: decorator
@inline function finishAxis(
  c: Columns,
  s: Setting,
  o: usize,
  x: usize,
  v: usize,
  position: v128,
  before: v128,
  force: v128,
  mass: v128,
  radius: v128,
  low: v128,
  high: v128,
  maxPosition: v128,
  maxSpeed: v128,
  dt: v128,
): v128 {
  const acceleration = v128.and(v128.div<real>(force, mass), v128.gt<real>(mass, splat(0)));
  const velocity = add(before, mul(acceleration, dt));
  const moved = add(position, mul(velocity, dt));
  v128.store(v, velocity);
  v128.store(x, moved);
  const outside = v128.or(v128.lt<real>(moved, add(low, radius)), v128.gt<real>(moved, sub(high, radius)));
  if (!v128.any_true(outside)) return v128.and(inRange(moved, maxPosition), inRange(velocity, maxSpeed));
  start = before;
  bounce(x, v, c.mass + o, c.radius + o, c.restitution + o, changetype<usize>(s));
  return v128.and(inRange(v128.load(x), maxPosition), inRange(v128.load(v), maxSpeed));
}

// One step of rows [first, last) in the plane; 1 when every value was and is in range.
export function fused2d(columns: usize, setting: usize, first: i32, last: i32): i32 {
  const c = changetype<Columns>(columns);
  const s = changetype<Setting>(setting);
  const maxX = splat(s.maxPosition);
  const maxV = splat(s.maxSpeed);
  const gx = splat(s.gravityX);
  const gy = splat(s.gravityY);
  const low = splat(s.low);
  const high = splat(s.high);
  const dt = splat(s.dt);
  let good = i32x4.splat(-1);
  for (let row = first; row < last; row += LANES) {
    const o = <usize>row * sizeof<real>();
    const x = v128.load(c.x + o);
    const y = v128.load(c.y + o);
    const vx = v128.load(c.vx + o);
    const vy = v128.load(c.vy + o);
    const savedX = savePose(c.previousX + o, x, maxX);
    const savedY = savePose(c.previousY + o, y, maxX);
    const before = v128.and(v128.and(savedX, savedY), v128.and(inRange(vx, maxV), inRange(vy, maxV)));
    const mass = v128.load(c.mass + o);
    const radius = v128.load(c.radius + o);
    const speed = v128.sqrt<real>(add(mul(vx, vx), mul(vy, vy)));
    const k = mul(v128.load(c.drag + o), speed);
    const fx = sub(mul(mass, gx), mul(k, vx));
    const fy = sub(mul(mass, gy), mul(k, vy));
    const afterX = finishAxis(c, s, o, c.x + o, c.vx + o, x, vx, fx, mass, radius, low, high, maxX, maxV, dt);
    const afterY = finishAxis(c, s, o, c.y + o, c.vy + o, y, vy, fy, mass, radius, low, high, maxX, maxV, dt);
    good = v128.and(v128.and(good, before), v128.and(afterX, afterY));
  }
  return i32(i32x4.all_true(good));
}

// The same in space.
export function fused3d(columns: usize, setting: usize, first: i32, last: i32): i32 {
  const c = changetype<Columns>(columns);
  const s = changetype<Setting>(setting);
  const maxX = splat(s.maxPosition);
  const maxV = splat(s.maxSpeed);
  const gx = splat(s.gravityX);
  const gy = splat(s.gravityY);
  const gz = splat(s.gravityZ);
  const low = splat(s.low);
  const high = splat(s.high);
  const dt = splat(s.dt);
  let good = i32x4.splat(-1);
  for (let row = first; row < last; row += LANES) {
    const o = <usize>row * sizeof<real>();
    const x = v128.load(c.x + o);
    const y = v128.load(c.y + o);
    const z = v128.load(c.z + o);
    const vx = v128.load(c.vx + o);
    const vy = v128.load(c.vy + o);
    const vz = v128.load(c.vz + o);
    const savedX = savePose(c.previousX + o, x, maxX);
    const savedY = savePose(c.previousY + o, y, maxX);
    const savedZ = savePose(c.previousZ + o, z, maxX);
    const slow = v128.and(inRange(vx, maxV), v128.and(inRange(vy, maxV), inRange(vz, maxV)));
    const before = v128.and(v128.and(savedX, savedY), v128.and(savedZ, slow));
    const mass = v128.load(c.mass + o);
    const radius = v128.load(c.radius + o);
    const speed = v128.sqrt<real>(add(add(mul(vx, vx), mul(vy, vy)), mul(vz, vz)));
    const k = mul(v128.load(c.drag + o), speed);
    const fx = sub(mul(mass, gx), mul(k, vx));
    const fy = sub(mul(mass, gy), mul(k, vy));
    const fz = sub(mul(mass, gz), mul(k, vz));
    const afterX = finishAxis(c, s, o, c.x + o, c.vx + o, x, vx, fx, mass, radius, low, high, maxX, maxV, dt);
    const afterY = finishAxis(c, s, o, c.y + o, c.vy + o, y, vy, fy, mass, radius, low, high, maxX, maxV, dt);
    const afterZ = finishAxis(c, s, o, c.z + o, c.vz + o, z, vz, fz, mass, radius, low, high, maxX, maxV, dt);
    good = v128.and(v128.and(good, before), v128.and(afterX, v128.and(afterY, afterZ)));
  }
  return i32(i32x4.all_true(good));
}

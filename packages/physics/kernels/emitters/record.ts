// The record of an emitter: parameters, counters, and addresses of its pool's arrays and of columns. All state is in
// the world's memory, so that a copy of the memory is a copy of every emitter.

export const MAX_STOPS: i32 = 4;
export const MAX_RAMPS: i32 = 8;

// A pool has `capacity` slots; `ids` maps a slot to its entity.
@unmanaged
export class Emitter {
  // u32 per slot: the entity; its generation owned by the pool; the next in the queue of free slots; neighbours in
  // the list of the living by age.
  ids: usize;
  generation: usize;
  free: usize;
  older: usize;
  newer: usize;
  // Per slot: f64 time of birth by the emitter's clock, f32 lifetime (0 for a free slot), f32 factor of the size, u32
  // ramp.
  bornAt: usize;
  lifetime: usize;
  sizeFactor: usize;
  ramp: usize;
  // Per ramp, a lookup table of 256 u32 colours over a life.
  colors: usize;
  // Addresses of columns outside the table of columns.
  previousX: usize;
  previousY: usize;
  previousZ: usize;
  color: usize;
  size: usize;
  generations: usize;
  // The particles that ended in this step, if reported: u32 ids, and x, y, z, vx, vy, vz as f64.
  endedIds: usize;
  endedAt: usize;
  endedThisStep: i32;
  bursts: usize;
  burstCount: i32;
  capacity: i32;
  freeHead: i32;
  freeCount: i32;
  alive: i32;
  oldest: u32;
  newest: u32;
  dimensions: i32;
  recyclesOldest: i32;
  emits: i32;
  // 1 if directions and spreads are in the frame of the body that the emitter follows.
  turns: i32;
  // Number of births in this step; the next particle of `nextNewborns`, the number left, and the end of the rows found.
  newborns: i32;
  cursor: u32;
  remaining: i32;
  newbornEnd: i32;
  rampCount: i32;
  sizeStops: i32;
  changed: i32;
  // 1 if colours or sizes were changed, so that living particles need an update.
  refreshAppearance: i32;
  random0: u32;
  random1: u32;
  random2: u32;
  random3: u32;
  color0: u32;
  color1: u32;
  color2: u32;
  color3: u32;
  color4: u32;
  color5: u32;
  color6: u32;
  color7: u32;
  color8: u32;
  color9: u32;
  color10: u32;
  color11: u32;
  color12: u32;
  color13: u32;
  color14: u32;
  color15: u32;
  color16: u32;
  color17: u32;
  color18: u32;
  color19: u32;
  color20: u32;
  color21: u32;
  color22: u32;
  color23: u32;
  color24: u32;
  color25: u32;
  color26: u32;
  color27: u32;
  color28: u32;
  color29: u32;
  color30: u32;
  color31: u32;
  stops0: u32;
  stops1: u32;
  stops2: u32;
  stops3: u32;
  stops4: u32;
  stops5: u32;
  stops6: u32;
  stops7: u32;
  // The emitter's clock, s; the time since it last emitted, s; the pending fraction of a birth.
  clock: f64;
  pending: f64;
  fractionalBirths: f64;
  // The parameters, in the order of src/emitters/options.ts. The direction is a unit vector, the spread the
  // half-angle of the cone.
  rate: f64;
  lifetimeMin: f64;
  lifetimeMax: f64;
  speedMin: f64;
  speedMax: f64;
  directionX: f64;
  directionY: f64;
  directionZ: f64;
  spread: f64;
  areaX: f64;
  areaY: f64;
  areaZ: f64;
  scatterX: f64;
  scatterY: f64;
  scatterZ: f64;
  inheritVelocity: f64;
  mass: f64;
  sizeFactorMin: f64;
  sizeFactorMax: f64;
  size0: f64;
  size1: f64;
  size2: f64;
  size3: f64;
  // Cosine of the spread, and radius of the colliders, m.
  cosSpread: f64;
  radius: f64;
  // Position now and at the last step, and the velocity that particles inherit.
  x: f64;
  y: f64;
  z: f64;
  lastX: f64;
  lastY: f64;
  lastZ: f64;
  velocityX: f64;
  velocityY: f64;
  velocityZ: f64;
  // Place of births in the frame of the body, and the body's rotation now and at the last step, as unit quaternions.
  offsetX: f64;
  offsetY: f64;
  offsetZ: f64;
  turnX: f64;
  turnY: f64;
  turnZ: f64;
  turnW: f64;
  lastTurnX: f64;
  lastTurnY: f64;
  lastTurnZ: f64;
  lastTurnW: f64;
  born: f64;
  ended: f64;
  droppedCount: f64;
}

// A requested burst, kept until the next step.
@unmanaged
export class Burst {
  count: f64;
  // 1 if it has its own position; the ramp to use, or -1.
  placed: f64;
  ramp: f64;
  x: f64;
  y: f64;
  z: f64;
  velocityX: f64;
  velocityY: f64;
  velocityZ: f64;
  // Address of its pattern, three f64 per velocity, or 0; number of velocities; factor of the velocities.
  pattern: f64;
  patternCount: f64;
  scale: f64;
}

// @ts-ignore: decorator
@inline export function word(base: usize, slot: u32): u32 {
  return load<u32>(base + ((<usize>slot) << 2));
}

// @ts-ignore: decorator
@inline export function putWord(base: usize, slot: u32, value: u32): void {
  store<u32>(base + ((<usize>slot) << 2), value);
}

// Particles age: some end, and of the others colours and sizes change with the elapsed fraction of their life.
import { fractionsOf, lastTwo, writeColor, writeColors, writeSize, writeSizes } from './appearance';
import { end, ownsEntity } from './pool';
import { Emitter, word } from './record';

export function ageParticles(e: Emitter): void {
  if (e.alive == 0) return;
  endParticles(e);
  const updatesColor = e.refreshAppearance != 0 || hasColorRamp(e);
  const updatesSize = e.refreshAppearance != 0 || e.sizeStops > 1;
  e.refreshAppearance = 0;
  if (!updatesColor && !updatesSize) return;
  updateAppearance(e, updatesColor, updatesSize);
  e.changed = 1;
}

// Ends the particles whose life is over or whose entity was removed. Four slots are looked at at a time, because in most steps
// none of them ends. The loops read the record through locals, because the compiler must assume that stores to columns change
// the record.
function endParticles(e: Emitter): void {
  const capacity = e.capacity;
  const lifetimes = e.lifetime;
  const births = e.bornAt;
  const ids = e.ids;
  const own = e.generation;
  const generations = e.generations;
  const clock = f64x2.splat(e.clock);
  for (let slot: i32 = 0; slot < capacity; slot += 4) {
    const isWhole = slot + 4 <= capacity;
    const at = (<usize>slot) << 2;
    if (isWhole && goOn(lifetimes + at, births + 2 * at, ids + at, own + at, generations, clock)) continue;
    endSome(e, slot, min<i32>(slot + 4, capacity));
  }
}

// Which of the rows of four slots stand where those of neighbours of the first would.
// @ts-ignore: decorator
@inline function areNeighbours(ids: usize): v128 {
  const neighbours = i32x4.add(i32x4.splat(load<u32>(ids)), i32x4(0, 1, 2, 3));
  return i32x4.eq(v128.load(ids), neighbours);
}

// Whether the particles of four slots go on, with their own entities. A slot without a particle has the lifetime zero. It is
// false where the four rows are not neighbours.
// @ts-ignore: decorator
@inline function goOn(
  lifetimes: usize,
  births: usize,
  ids: usize,
  own: usize,
  generations: usize,
  clock: v128,
): bool {
  const lifetime = v128.load(lifetimes);
  const first = f64x2.promote_low_f32x4(lifetime);
  const second = f64x2.promote_low_f32x4(lastTwo(lifetime));
  const endsFirst = f64x2.ge(f64x2.sub(clock, v128.load(births)), first);
  const endsSecond = f64x2.ge(f64x2.sub(clock, v128.load(births, 16)), second);
  const ends = v128.shuffle<i32>(endsFirst, endsSecond, 0, 2, 4, 6);
  const isOwn = i32x4.eq(v128.load(generations + ((<usize>load<u32>(ids)) << 2)), v128.load(own));
  const goesOn = v128.or(v128.andnot(isOwn, ends), f32x4.eq(lifetime, f32x4.splat(0)));
  return i32x4.all_true(v128.and(goesOn, areNeighbours(ids)));
}

function endSome(e: Emitter, first: i32, last: i32): void {
  for (let slot = first; slot < last; slot++) {
    const lifetime = <f64>load<f32>(e.lifetime + ((<usize>slot) << 2));
    if (lifetime == 0) continue;
    const elapsed = e.clock - load<f64>(e.bornAt + ((<usize>slot) << 3));
    if (elapsed >= lifetime || !ownsEntity(e, slot)) end(e, slot);
  }
}

// The elapsed fraction of a life is below 1, so it always has a next stop.
function updateAppearance(e: Emitter, updatesColor: bool, updatesSize: bool): void {
  const clock = e.clock;
  const lifetimes = e.lifetime;
  const births = e.bornAt;
  const ids = e.ids;
  const colors = e.colors;
  const ramps = e.ramp;
  const color = e.color;
  const sizes = changetype<usize>(e) + offsetof<Emitter>('size0');
  const stops = e.sizeStops;
  const factors = e.sizeFactor;
  const size = e.size;
  for (let first: i32 = 0, capacity = e.capacity; first < capacity; first += 4) {
    const at = (<usize>first) << 2;
    if (first + 4 <= capacity && areAlive(lifetimes + at) && i32x4.all_true(areNeighbours(ids + at))) {
      const row = word(ids, first);
      const lifetime = v128.load(lifetimes + at);
      const a = fractionsOf(lifetime, births + 2 * at, clock);
      const b = fractionsOf(lastTwo(lifetime), births + 2 * at + 16, clock);
      if (updatesColor) writeColors(colors, ramps + at, color + ((<usize>row) << 2), a, b);
      if (updatesSize) writeSizes(sizes, stops, factors + at, size + <usize>row * sizeof<real>(), a, b);
      continue;
    }
    for (let slot = first, last = min<i32>(first + 4, capacity); slot < last; slot++) {
      const lifetime = <f64>load<f32>(lifetimes + ((<usize>slot) << 2));
      if (lifetime == 0) continue;
      const fraction = (clock - load<f64>(births + ((<usize>slot) << 3))) / lifetime;
      const row = word(ids, slot);
      if (updatesColor) writeColor(colors, ramps, color, slot, row, fraction);
      if (updatesSize) writeSize(sizes, stops, factors, size, slot, row, fraction);
    }
  }
}

// Whether four slots have particles: a slot without one has the lifetime zero.
// @ts-ignore: decorator
@inline function areAlive(lifetimes: usize): bool {
  return i32x4.all_true(v128.load(lifetimes));
}

function hasColorRamp(e: Emitter): bool {
  for (let ramp: i32 = 0; ramp < e.rampCount; ramp++) {
    if (word(changetype<usize>(e) + offsetof<Emitter>('stops0'), ramp) > 1) return true;
  }
  return false;
}

// What an emitter does in the `emit` phase: its particles grow older and some end, then new ones are born.
//
// The births of the time since the last step are made now, each at its own moment: the i-th when rate x time reaches a
// whole number. So a stream of particles is the same for steps of any length, and has no gaps between frames.
import { bear } from './birth';
import { paintColor, paintSize } from './appearance';
import { end } from './pool';
import { Burst, Emitter, word } from './record';

export function stepEmitter(emitter: usize, dt: f64): void {
  const e = changetype<Emitter>(emitter);
  e.clock += e.pending;
  e.endedNow = 0;
  e.changed = 0;
  age(e);
  if (e.emits != 0) stream(e);
  burst(e);
  e.lastX = e.x;
  e.lastY = e.y;
  e.lastZ = e.z;
  e.pending = dt;
}

// Everything the loop reads of the record stands in locals: stores to the columns could change the record for all the
// compiler knows. A part of a life is below 1, so that it has a shade and a stop behind it.
function age(e: Emitter): void {
  if (e.alive == 0) return;
  const clock = e.clock;
  const lives = e.life;
  const births = e.bornAt;
  const ids = e.ids;
  const ours = e.generation;
  const generations = e.generations;
  const colors = e.colors;
  const ramps = e.ramp;
  const color = e.color;
  const sizes = changetype<usize>(e) + offsetof<Emitter>('size0');
  const stops = e.sizeStops;
  const factors = e.factor;
  const size = e.size;
  const colorful = e.repaint != 0 || anyRamp(e);
  const growing = e.repaint != 0 || stops > 1;
  for (let slot: i32 = 0, capacity = e.capacity; slot < capacity; slot++) {
    const life = <f64>load<f32>(lives + ((<usize>slot) << 2));
    if (life == 0) continue;
    const years = clock - load<f64>(births + ((<usize>slot) << 3));
    const row = word(ids, slot);
    if (years >= life || word(generations, row) != word(ours, slot)) {
      end(e, slot);
      continue;
    }
    const part = years / life;
    if (colorful) paintColor(colors, ramps, color, slot, row, part);
    if (growing) paintSize(sizes, stops, factors, size, slot, row, part);
  }
  e.repaint = 0;
  if (colorful || growing) e.changed = 1;
}

function anyRamp(e: Emitter): bool {
  for (let ramp: i32 = 0; ramp < e.rampCount; ramp++) {
    if (word(changetype<usize>(e) + offsetof<Emitter>('stops0'), ramp) > 1) return true;
  }
  return false;
}

function stream(e: Emitter): void {
  if (e.rate == 0 || e.pending == 0) return;
  const due = e.owed + e.rate * e.pending;
  const count = floor<f64>(due);
  // What cannot even find a slot by ending all others is not worth drawing.
  const skipped = max<f64>(0, count - <f64>e.capacity);
  e.lost += skipped;
  // Counted in whole numbers: beyond 2^53 a double no longer grows by one.
  for (let born: i32 = 1, most = <i32>(count - skipped); born <= most; born++) {
    const since = (skipped + <f64>born - e.owed) / e.rate;
    const t = since / e.pending;
    bear(
      e,
      e.lastX + (e.x - e.lastX) * t,
      e.lastY + (e.y - e.lastY) * t,
      e.lastZ + (e.z - e.lastZ) * t,
      e.velocityX,
      e.velocityY,
      e.velocityZ,
      max<f64>(0, e.pending - since),
      -1,
    );
  }
  e.owed = due - count;
}

function burst(e: Emitter): void {
  for (let b: i32 = 0; b < e.burstCount; b++) {
    const asked = changetype<Burst>(e.bursts + <usize>b * offsetof<Burst>());
    const placed = asked.placed != 0;
    const x = placed ? asked.x : e.x;
    const y = placed ? asked.y : e.y;
    const z = placed ? asked.z : e.z;
    const vx = asked.velocityX + (placed ? 0 : e.velocityX);
    const vy = asked.velocityY + (placed ? 0 : e.velocityY);
    const vz = asked.velocityZ + (placed ? 0 : e.velocityZ);
    const pattern = <usize>asked.pattern;
    const length = <i32>asked.patternCount;
    for (let i: i32 = 0, count = <i32>asked.count; i < count; i++) {
      const given = pattern == 0 ? 0 : pattern + <usize>(i % length) * 24;
      bear(e, x, y, z, vx, vy, vz, 0, <i32>asked.ramp, given, asked.scale);
    }
  }
  e.burstCount = 0;
}

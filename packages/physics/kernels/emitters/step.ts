// The emitter's part of the `emit` phase: its particles age and some end, then new ones are born.
//
// All births since the last step are made now, each at its own time: the i-th when rate x time reaches an integer. So
// a stream of particles is the same for steps of any length, and has no gaps between frames.
import { ageParticles } from './age';
import { createParticle } from './birth';
import { beginNozzle, nozzleU, nozzleV, nozzleW, nozzleX, nozzleY, nozzleZ, placeNozzle } from './turn';
import { Burst, Emitter, word } from './record';

export function stepEmitter(emitter: usize, dt: f64): void {
  const e = changetype<Emitter>(emitter);
  e.clock += e.pending;
  e.endedThisStep = 0;
  e.changed = 0;
  e.newborns = 0;
  ageParticles(e);
  beginNozzle(e);
  if (e.emits != 0) emitStream(e);
  emitBursts(e);
  e.lastX = e.x;
  e.lastY = e.y;
  e.lastZ = e.z;
  e.lastTurnX = e.turnX;
  e.lastTurnY = e.turnY;
  e.lastTurnZ = e.turnZ;
  e.lastTurnW = e.turnW;
  e.pending = dt;
}

function emitStream(e: Emitter): void {
  if (e.rate == 0 || e.pending == 0) return;
  const due = e.fractionalBirths + e.rate * e.pending;
  const count = floor<f64>(due);
  // Births beyond the capacity draw no random numbers. They are dropped, but for those whose life is over by now in any case.
  const skipped = max<f64>(0, count - <f64>e.capacity);
  const over = floor<f64>(e.fractionalBirths + e.rate * (e.pending - e.lifetimeMax));
  const ended = max<f64>(0, min<f64>(skipped, over));
  e.born += ended;
  e.ended += ended;
  e.droppedCount += skipped - ended;
  // An integer counter, because an f64 above 2^53 does not change when 1 is added.
  for (let born: i32 = 1, lastBirth = <i32>(count - skipped); born <= lastBirth; born++) {
    const sinceStart = (skipped + <f64>born - e.fractionalBirths) / e.rate;
    const t = sinceStart / e.pending;
    placeNozzle(e, t);
    const age = max<f64>(0, e.pending - sinceStart);
    createParticle(
      e,
      e.lastX + (e.x - e.lastX) * t + nozzleX,
      e.lastY + (e.y - e.lastY) * t + nozzleY,
      e.lastZ + (e.z - e.lastZ) * t + nozzleZ,
      e.velocityX + nozzleU,
      e.velocityY + nozzleV,
      e.velocityZ + nozzleW,
      age,
      -1,
    );
  }
  e.fractionalBirths = due - count;
}

function emitBursts(e: Emitter): void {
  placeNozzle(e, 1);
  for (let b: i32 = 0; b < e.burstCount; b++) {
    const request = changetype<Burst>(e.bursts + <usize>b * offsetof<Burst>());
    const placed = request.placed != 0;
    const x = placed ? request.x : e.x;
    const y = placed ? request.y : e.y;
    const z = placed ? request.z : e.z;
    const vx = request.velocityX + (placed ? 0 : e.velocityX + nozzleU);
    const vy = request.velocityY + (placed ? 0 : e.velocityY + nozzleV);
    const vz = request.velocityZ + (placed ? 0 : e.velocityZ + nozzleW);
    const pattern = <usize>request.pattern;
    const length = <i32>request.patternCount;
    for (let i: i32 = 0, count = <i32>request.count; i < count; i++) {
      const given = pattern == 0 ? 0 : pattern + <usize>(i % length) * 24;
      createParticle(e, x, y, z, vx, vy, vz, 0, <i32>request.ramp, given, request.scale);
    }
  }
  e.burstCount = 0;
}

// The birth of a particle: position, speed and direction.
import { columns, put } from '../memory/columns';
import { computeSineCosine, sineCosine } from '../math/elementary';
import { randomUnit } from '../math/random';
import { applyAppearance } from './appearance';
import { rotate, rotated } from './turn';
import { NONE, link, nextGeneration, takeSlot } from './pool';
import { Emitter, putWord, word } from './record';

const TWO_PI: f64 = 6.283185307179586;

let directionX: f64 = 0;
let directionY: f64 = 0;
let directionZ: f64 = 0;

// @ts-ignore: decorator
@inline function randomState(e: Emitter): usize {
  return changetype<usize>(e) + offsetof<Emitter>('random0');
}

// @ts-ignore: decorator
@inline function drawBetween(e: Emitter, low: f64, high: f64): f64 {
  return low + (high - low) * randomUnit(randomState(e));
}

// Draws a direction, uniform by angle within the wedge about the emitter's direction.
function aim2d(e: Emitter): void {
  computeSineCosine(e.spread * drawBetween(e, -1, 1));
  directionX = e.directionX * sineCosine.cosine - e.directionY * sineCosine.sine;
  directionY = e.directionX * sineCosine.sine + e.directionY * sineCosine.cosine;
  directionZ = 0;
}

// Draws a direction, uniform by solid angle within the cone about the emitter's direction d; u and w are normal to d
// and to each other.
function aim3d(e: Emitter): void {
  const c = drawBetween(e, 1, e.cosSpread);
  computeSineCosine(TWO_PI * randomUnit(randomState(e)));
  const s = sqrt<f64>(max<f64>(0, 1 - c * c));
  const upright = abs<f64>(e.directionZ) > 0.9;
  let ux = upright ? 0 : e.directionY;
  let uy = upright ? e.directionZ : -e.directionX;
  let uz = upright ? -e.directionY : 0;
  const norm = 1 / sqrt<f64>(ux * ux + uy * uy + uz * uz);
  ux *= norm;
  uy *= norm;
  uz *= norm;
  const wx = e.directionY * uz - e.directionZ * uy;
  const wy = e.directionZ * ux - e.directionX * uz;
  const wz = e.directionX * uy - e.directionY * ux;
  const a = s * sineCosine.cosine;
  const b = s * sineCosine.sine;
  directionX = c * e.directionX + a * ux + b * wx;
  directionY = c * e.directionY + a * uy + b * wy;
  directionZ = c * e.directionZ + a * uz + b * wz;
}

// Creates a particle that left (x, y, z) `age` seconds ago and has moved since at its initial velocity, to which (vx,
// vy, vz) is added; newborns.ts adds what forces did since. Every particle draws the same count of random numbers in 2D and 3D, even if it is dead at birth,
// so that the step's length does not change the next particle. A `given` velocity, three f64 times `scale`, replaces
// the drawn velocity.
export function createParticle(
  e: Emitter,
  x: f64,
  y: f64,
  z: f64,
  vx: f64,
  vy: f64,
  vz: f64,
  age: f64,
  ramp: i32,
  given: usize = 0,
  scale: f64 = 1,
): void {
  const lifetime = drawBetween(e, e.lifetimeMin, e.lifetimeMax);
  const speed = drawBetween(e, e.speedMin, e.speedMax);
  const factor = drawBetween(e, e.sizeFactorMin, e.sizeFactorMax);
  const chosen = ramp >= 0 ? ramp : <i32>(randomUnit(randomState(e)) * <f64>e.rampCount);
  if (e.dimensions == 2) aim2d(e);
  else aim3d(e);
  if (given != 0) {
    directionX = load<f64>(given) * scale;
    directionY = load<f64>(given, 8) * scale;
    directionZ = load<f64>(given, 16) * scale;
  } else {
    directionX *= speed;
    directionY *= speed;
    directionZ *= speed;
  }
  rotate(
    e,
    directionX + e.scatterX * drawBetween(e, -1, 1),
    directionY + e.scatterY * drawBetween(e, -1, 1),
    directionZ + e.scatterZ * drawBetween(e, -1, 1),
  );
  const ux = rotated.x + vx;
  const uy = rotated.y + vy;
  const uz = rotated.z + vz;
  rotate(e, e.areaX * drawBetween(e, -1, 1), e.areaY * drawBetween(e, -1, 1), e.areaZ * drawBetween(e, -1, 1));
  const px = x + rotated.x + ux * age;
  const py = y + rotated.y + uy * age;
  const pz = z + rotated.z + uz * age;
  e.born += 1;
  if (age >= lifetime) {
    e.ended += 1;
    return;
  }
  const slot = takeSlot(e);
  if (slot == NONE) {
    e.droppedCount += 1;
    e.born -= 1;
    return;
  }
  const row = word(e.ids, slot);
  setPosition(e, row, px, py, pz);
  const c = columns();
  put(c.velocityX, row, <real>ux);
  put(c.velocityY, row, <real>uy);
  put(c.velocityZ, row, <real>uz);
  put(c.mass, row, <real>e.mass);
  put(c.radius, row, <real>e.radius);
  store<f64>(e.bornAt + ((<usize>slot) << 3), e.clock - age);
  store<f32>(e.lifetime + ((<usize>slot) << 2), <f32>lifetime);
  store<f32>(e.sizeFactor + ((<usize>slot) << 2), <f32>factor);
  putWord(e.ramp, slot, chosen);
  nextGeneration(e, slot);
  link(e, slot);
  e.newborns++;
  applyAppearance(e, slot, row, age / lifetime);
  e.changed = 1;
}

// Sets the previous pose to the new one: a renderer must not interpolate from the end of the row's last life.
function setPosition(e: Emitter, row: u32, x: f64, y: f64, z: f64): void {
  const c = columns();
  put(c.positionX, row, <real>x);
  put(c.positionY, row, <real>y);
  put(c.positionZ, row, <real>z);
  put(e.previousX, row, <real>x);
  put(e.previousY, row, <real>y);
  put(e.previousZ, row, <real>z);
}

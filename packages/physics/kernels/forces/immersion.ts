// Bodies in a fluid with a level surface: how much of each is under it, and what the fluid does to that much.
//
// A hull is a sphere (shape 0), an upright box (1) or, in 2D, a polygon that turns with the body (2 and up).
import { columns, get, put } from '../columns';
import { cosine, sine } from '../math/elementary';

// The fluid, all f64; src/forces/pool.ts writes it. `up` is the unit vector against gravity.
@unmanaged
export class Pool {
  density: f64;
  gravity: f64;
  upX: f64;
  upY: f64;
  upZ: f64;
  level: f64;
  flowX: f64;
  flowY: f64;
  flowZ: f64;
}

@unmanaged
export class Hulls {
  volume: usize;
  halfHeight: usize;
  shape: usize;
  quadratic: usize;
  linear: usize;
}

// @ts-ignore: decorator
@inline function half(h: Hulls, row: i32): f64 {
  const given = <f64>get(h.halfHeight, row);
  return given > 0 ? given : <f64>get(columns().radius, row);
}

// Height of a centre above the origin.
// @ts-ignore: decorator
@inline function heightOf(p: Pool, row: i32): f64 {
  const c = columns();
  return p.upX * <f64>get(c.positionX, row) + p.upY * <f64>get(c.positionY, row) + p.upZ * <f64>get(c.positionZ, row);
}

// Depth of the centre over the half height, within -1 and 1.
// @ts-ignore: decorator
@inline function relativeDepth(p: Pool, h: Hulls, row: i32): f64 {
  const depth = p.level - heightOf(p, row);
  const size = half(h, row);
  if (!(size > 0)) return depth > 0 ? 1 : -1;
  return max<f64>(-1, min<f64>(1, depth / size));
}

// @ts-ignore: decorator
@inline function fractionOf(shape: u32, d: f64): f64 {
  return shape == 0 ? 0.5 + 0.25 * d * (3 - d * d) : 0.5 + 0.5 * d;
}

// @ts-ignore: decorator
@inline function shapeOf(h: Hulls, row: i32): u32 {
  return load<u32>(h.shape + ((<usize>row) << 2));
}

// F += density V f g against gravity, on spheres and boxes.
export function upthrust(pool: usize, hulls: usize, fx: usize, fy: usize, fz: usize, first: i32, last: i32): void {
  const p = changetype<Pool>(pool);
  const h = changetype<Hulls>(hulls);
  for (let row = first; row < last; row++) {
    const volume = <f64>get(h.volume, row);
    const shape = shapeOf(h, row);
    if (volume == 0 || shape > 1) continue;
    const size = p.density * p.gravity * volume * fractionOf(shape, relativeDepth(p, h, row));
    put(fx, row, get(fx, row) + <real>(size * p.upX));
    put(fy, row, get(fy, row) + <real>(size * p.upY));
    put(fz, row, get(fz, row) + <real>(size * p.upZ));
  }
}

// The work done against the upthrust on spheres and boxes, from wholly outside, J:
//   density V g R U(d), with U' = f: sphere d/2 + 3 d^2/8 - d^4/16 + 3/16, box (1 + d)^2/4, and d beyond d = 1.
export function upthrustPotential(pool: usize, hulls: usize, rows: i32): f64 {
  const p = changetype<Pool>(pool);
  const h = changetype<Hulls>(hulls);
  let total: f64 = 0;
  for (let row = 0; row < rows; row++) {
    const volume = <f64>get(h.volume, row);
    const shape = shapeOf(h, row);
    if (volume == 0 || shape > 1) continue;
    const size = half(h, row);
    const d = relativeDepth(p, h, row);
    const partial = shape == 0 ? 0.1875 + d * (0.5 + d * (0.375 - 0.0625 * d * d)) : 0.25 * (1 + d) * (1 + d);
    const work = d >= 1 ? p.level - heightOf(p, row) : size * partial;
    total += p.density * p.gravity * volume * work;
  }
  return total;
}

// The same where the fluid is everywhere, from height 0. What has no mass is not moved, and has no energy to give.
export function balloonPotential(pool: usize, hulls: usize, rows: i32): f64 {
  const p = changetype<Pool>(pool);
  const h = changetype<Hulls>(hulls);
  const c = columns();
  let total: f64 = 0;
  for (let row = 0; row < rows; row++) {
    const volume = <f64>get(h.volume, row);
    if (volume == 0 || get(c.mass, row) == 0) continue;
    total -= p.density * p.gravity * volume * heightOf(p, row);
  }
  return total;
}

// F -= f (k |w| + c) w, with the columns of quadratic and linear drag and the velocity w through the fluid.
export function immersedDrag(pool: usize, hulls: usize, fx: usize, fy: usize, fz: usize, first: i32, last: i32): void {
  const p = changetype<Pool>(pool);
  const h = changetype<Hulls>(hulls);
  const c = columns();
  for (let row = first; row < last; row++) {
    const k = <f64>get(h.quadratic, row);
    const l = <f64>get(h.linear, row);
    if (k == 0 && l == 0) continue;
    const share = fractionOf(min<u32>(shapeOf(h, row), 1), relativeDepth(p, h, row));
    if (share == 0) continue;
    const x = <f64>get(c.velocityX, row) - p.flowX;
    const y = <f64>get(c.velocityY, row) - p.flowY;
    const z = <f64>get(c.velocityZ, row) - p.flowZ;
    const size = share * (k * sqrt<f64>(x * x + y * y + z * z) + l);
    put(fx, row, get(fx, row) - <real>(size * x));
    put(fy, row, get(fy, row) - <real>(size * y));
    put(fz, row, get(fz, row) - <real>(size * z));
  }
}

// Takes from the force found so far what accelerates the fluid: F *= m / (m + C density V f).
export function addedMass(
  pool: usize,
  hulls: usize,
  coefficient: f64,
  fx: usize,
  fy: usize,
  fz: usize,
  first: i32,
  last: i32,
): void {
  const p = changetype<Pool>(pool);
  const h = changetype<Hulls>(hulls);
  const c = columns();
  for (let row = first; row < last; row++) {
    const volume = <f64>get(h.volume, row);
    const mass = <f64>get(c.mass, row);
    if (volume == 0 || mass == 0) continue;
    const share = fractionOf(min<u32>(shapeOf(h, row), 1), relativeDepth(p, h, row));
    const scale = <real>(mass / (mass + coefficient * p.density * volume * share));
    put(fx, row, get(fx, row) * scale);
    put(fy, row, get(fy, row) * scale);
    put(fz, row, get(fz, row) * scale);
  }
}

// The part of a polygon under the level: area and first moments about the centre, by the shoelace formula.
let area: f64 = 0;
let momentX: f64 = 0;
let momentY: f64 = 0;

function addEdge(x1: f64, y1: f64, x2: f64, y2: f64): void {
  const cross = x1 * y2 - x2 * y1;
  area += 0.5 * cross;
  momentX += ((x1 + x2) * cross) / 6;
  momentY += ((y1 + y2) * cross) / 6;
}

// `depth` is that of the centre; `polygon` the vertices about it, anticlockwise. Clipping a polygon against one line
// leaves one closed outline (Sutherland, Hodgman, CACM 17, 32, 1974), of which no list has to be kept.
function clip(p: Pool, polygon: usize, count: i32, angle: f64, depth: f64): void {
  area = 0;
  momentX = 0;
  momentY = 0;
  const cosA = cosine(angle);
  const sinA = sine(angle);
  let started = false;
  let startX: f64 = 0;
  let startY: f64 = 0;
  let penX: f64 = 0;
  let penY: f64 = 0;
  const end = polygon + ((<usize>(count - 1)) << 4);
  let px = load<f64>(end) * cosA - load<f64>(end, 8) * sinA;
  let py = load<f64>(end) * sinA + load<f64>(end, 8) * cosA;
  let under = depth - (p.upX * px + p.upY * py);
  for (let i = 0; i < count; i++) {
    const vertex = polygon + ((<usize>i) << 4);
    const x = load<f64>(vertex) * cosA - load<f64>(vertex, 8) * sinA;
    const y = load<f64>(vertex) * sinA + load<f64>(vertex, 8) * cosA;
    const next = depth - (p.upX * x + p.upY * y);
    if (under > 0 != next > 0) {
      const t = under / (under - next);
      const cx = px + (x - px) * t;
      const cy = py + (y - py) * t;
      if (started) addEdge(penX, penY, cx, cy);
      else {
        started = true;
        startX = cx;
        startY = cy;
      }
      penX = cx;
      penY = cy;
    }
    if (next > 0) {
      if (started) addEdge(penX, penY, x, y);
      else {
        started = true;
        startX = x;
        startY = y;
      }
      penX = x;
      penY = y;
    }
    px = x;
    py = y;
    under = next;
  }
  if (started) addEdge(penX, penY, startX, startY);
}

// Upthrust on polygons of one shape, at the centre of the part under the level, and the torque it has about the body's.
export function polygonUpthrust(
  pool: usize,
  hulls: usize,
  shape: i32,
  polygon: usize,
  count: i32,
  whole: f64,
  angle: usize,
  fx: usize,
  fy: usize,
  torque: usize,
  first: i32,
  last: i32,
): void {
  const p = changetype<Pool>(pool);
  const h = changetype<Hulls>(hulls);
  const c = columns();
  for (let row = first; row < last; row++) {
    const volume = <f64>get(h.volume, row);
    if (volume == 0 || shapeOf(h, row) != <u32>shape) continue;
    const height = p.upX * <f64>get(c.positionX, row) + p.upY * <f64>get(c.positionY, row);
    clip(p, polygon, count, get(angle, row), p.level - height);
    const perArea = (p.density * p.gravity * volume) / whole;
    put(fx, row, get(fx, row) + <real>(perArea * area * p.upX));
    put(fy, row, get(fy, row) + <real>(perArea * area * p.upY));
    put(torque, row, get(torque, row) + <real>(perArea * (momentX * p.upY - momentY * p.upX)));
  }
}

// The work done against the upthrust on polygons of one shape, J: each part of the outline under the level counts with
// its depth, whose slope along the height is the area and about the centre the torque.
export function polygonPotential(
  pool: usize,
  hulls: usize,
  shape: i32,
  polygon: usize,
  count: i32,
  whole: f64,
  angle: usize,
  rows: i32,
): f64 {
  const p = changetype<Pool>(pool);
  const h = changetype<Hulls>(hulls);
  const c = columns();
  let total: f64 = 0;
  for (let row = 0; row < rows; row++) {
    const volume = <f64>get(h.volume, row);
    if (volume == 0 || shapeOf(h, row) != <u32>shape) continue;
    const depth = p.level - (p.upX * <f64>get(c.positionX, row) + p.upY * <f64>get(c.positionY, row));
    clip(p, polygon, count, get(angle, row), depth);
    const work = area * depth - (momentX * p.upX + momentY * p.upY);
    total += ((p.density * p.gravity * volume) / whole) * work;
  }
  return total;
}

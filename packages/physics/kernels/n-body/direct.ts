// Direct summation: every pair is computed once, with forces that are equal and opposite to the last bit.
//
// Two bodies i are broadcast against the bodies j of a tile, one vector at a time. The vector of j that contains i
// itself is computed in one direction only, by every i in it, so that no lane needs a mask: a body at distance 0 from
// itself exerts no force. A tile fits the first-level cache, and sums over tiles round less than one long sum.
import { get, put } from '../memory/columns';
import { LANES, add, at, div, mul, splat, sub } from '../memory/lanes';
import { NBody } from './workspace';

const TILE: i32 = 512;

// @ts-ignore: decorator
@inline export function laneSum(v: v128): real {
  if (sizeof<real>() == 8) return v128.extract_lane<real>(v, 0) + v128.extract_lane<real>(v, 1);
  const low = f32x4.extract_lane(v, 0) + f32x4.extract_lane(v, 1);
  return <real>(low + (f32x4.extract_lane(v, 2) + f32x4.extract_lane(v, 3)));
}

// Returns the strength over distance cubed (inverse square) or squared (inverse distance), from the squared softened
// distance u.
// @ts-ignore: decorator
@inline export function scaledStrength(strength: v128, u: v128, inverseSquare: bool): v128 {
  return div(strength, inverseSquare ? mul(u, v128.sqrt<real>(u)) : u);
}

function clearResults(w: NBody): void {
  const bytes = at((w.end + 7) & ~7);
  memory.fill(w.ax, 0, bytes);
  memory.fill(w.ay, 0, bytes);
  memory.fill(w.az, 0, bytes);
}

// @ts-ignore: decorator
@inline function pairs3d(w: NBody, i: i32, first: i32, last: i32, mutual: bool): void {
  const soft = splat(<real>w.softening2);
  const x0 = v128.load_splat<real>(w.x + at(i));
  const y0 = v128.load_splat<real>(w.y + at(i));
  const z0 = v128.load_splat<real>(w.z + at(i));
  const s0 = v128.load_splat<real>(w.s + at(i));
  const x1 = v128.load_splat<real>(w.x + at(i + 1));
  const y1 = v128.load_splat<real>(w.y + at(i + 1));
  const z1 = v128.load_splat<real>(w.z + at(i + 1));
  const s1 = v128.load_splat<real>(w.s + at(i + 1));
  let ax0 = splat(0);
  let ay0 = splat(0);
  let az0 = splat(0);
  let ax1 = splat(0);
  let ay1 = splat(0);
  let az1 = splat(0);
  const xs = w.x;
  const ys = w.y;
  const zs = w.z;
  const ss = w.s;
  const fxs = w.ax;
  const fys = w.ay;
  const fzs = w.az;
  const end = at(last);
  for (let o = at(first); o < end; o += 16) {
    const x = v128.load(xs + o);
    const y = v128.load(ys + o);
    const z = v128.load(zs + o);
    const s = v128.load(ss + o);
    let dx = sub(x, x0);
    let dy = sub(y, y0);
    let dz = sub(z, z0);
    let k = scaledStrength(mul(s, s0), add(add(mul(dx, dx), mul(dy, dy)), add(mul(dz, dz), soft)), true);
    dx = mul(dx, k);
    dy = mul(dy, k);
    dz = mul(dz, k);
    ax0 = add(ax0, dx);
    ay0 = add(ay0, dy);
    az0 = add(az0, dz);
    let ex = sub(x, x1);
    let ey = sub(y, y1);
    let ez = sub(z, z1);
    k = scaledStrength(mul(s, s1), add(add(mul(ex, ex), mul(ey, ey)), add(mul(ez, ez), soft)), true);
    ex = mul(ex, k);
    ey = mul(ey, k);
    ez = mul(ez, k);
    ax1 = add(ax1, ex);
    ay1 = add(ay1, ey);
    az1 = add(az1, ez);
    if (mutual) {
      v128.store(fxs + o, sub(v128.load(fxs + o), add(dx, ex)));
      v128.store(fys + o, sub(v128.load(fys + o), add(dy, ey)));
      v128.store(fzs + o, sub(v128.load(fzs + o), add(dz, ez)));
    }
  }
  put(w.ax, i, get(w.ax, i) + laneSum(ax0));
  put(w.ay, i, get(w.ay, i) + laneSum(ay0));
  put(w.az, i, get(w.az, i) + laneSum(az0));
  put(w.ax, i + 1, get(w.ax, i + 1) + laneSum(ax1));
  put(w.ay, i + 1, get(w.ay, i + 1) + laneSum(ay1));
  put(w.az, i + 1, get(w.az, i + 1) + laneSum(az1));
}

// Computes the forces between the sources in 3D for the law 1/r².
export function direct3d(w: NBody): void {
  clearResults(w);
  const n = w.tests;
  for (let tile = 0; tile < n; tile += TILE) {
    const last = min(tile + TILE, n);
    for (let i = 0; i < last; i += 2) {
      const own = i & -LANES;
      if (own >= tile) pairs3d(w, i, own, own + LANES, false);
      pairs3d(w, i, max(tile, own + LANES), last, true);
    }
  }
}

// @ts-ignore: decorator
@inline function pairs2d(w: NBody, i: i32, first: i32, last: i32, mutual: bool, inverseSquare: bool): void {
  const soft = splat(<real>w.softening2);
  const x0 = v128.load_splat<real>(w.x + at(i));
  const y0 = v128.load_splat<real>(w.y + at(i));
  const s0 = v128.load_splat<real>(w.s + at(i));
  const x1 = v128.load_splat<real>(w.x + at(i + 1));
  const y1 = v128.load_splat<real>(w.y + at(i + 1));
  const s1 = v128.load_splat<real>(w.s + at(i + 1));
  let ax0 = splat(0);
  let ay0 = splat(0);
  let ax1 = splat(0);
  let ay1 = splat(0);
  const xs = w.x;
  const ys = w.y;
  const ss = w.s;
  const fxs = w.ax;
  const fys = w.ay;
  const end = at(last);
  for (let o = at(first); o < end; o += 16) {
    const x = v128.load(xs + o);
    const y = v128.load(ys + o);
    const s = v128.load(ss + o);
    let dx = sub(x, x0);
    let dy = sub(y, y0);
    let k = scaledStrength(mul(s, s0), add(mul(dx, dx), add(mul(dy, dy), soft)), inverseSquare);
    dx = mul(dx, k);
    dy = mul(dy, k);
    ax0 = add(ax0, dx);
    ay0 = add(ay0, dy);
    let ex = sub(x, x1);
    let ey = sub(y, y1);
    k = scaledStrength(mul(s, s1), add(mul(ex, ex), add(mul(ey, ey), soft)), inverseSquare);
    ex = mul(ex, k);
    ey = mul(ey, k);
    ax1 = add(ax1, ex);
    ay1 = add(ay1, ey);
    if (mutual) {
      v128.store(fxs + o, sub(v128.load(fxs + o), add(dx, ex)));
      v128.store(fys + o, sub(v128.load(fys + o), add(dy, ey)));
    }
  }
  put(w.ax, i, get(w.ax, i) + laneSum(ax0));
  put(w.ay, i, get(w.ay, i) + laneSum(ay0));
  put(w.ax, i + 1, get(w.ax, i + 1) + laneSum(ax1));
  put(w.ay, i + 1, get(w.ay, i + 1) + laneSum(ay1));
}

// @ts-ignore: decorator
@inline function sum2d(w: NBody, inverseSquare: bool): void {
  clearResults(w);
  const n = w.tests;
  for (let tile = 0; tile < n; tile += TILE) {
    const last = min(tile + TILE, n);
    for (let i = 0; i < last; i += 2) {
      const own = i & -LANES;
      if (own >= tile) pairs2d(w, i, own, own + LANES, false, inverseSquare);
      pairs2d(w, i, max(tile, own + LANES), last, true, inverseSquare);
    }
  }
}

// Computes the forces between the sources in 2D for the law 1/r² or 1/r.
export function direct2d(w: NBody, inverseSquare: bool): void {
  if (inverseSquare) sum2d(w, true);
  else sum2d(w, false);
}

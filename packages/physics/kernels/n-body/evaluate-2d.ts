// The acceleration of a group from its interaction lists in 2D, for the law 1/r² or 1/r; see evaluate-3d.ts.
//
// For 1/r, with w = 1/u, S' = 2S and T' = tr S'/2:
//   body  a = s d w
//   cell  a = d (M w - T' w² + 2 (d·S'd) w³) - S'd w²      + dipole D w - 2 d (D·d) w²
// Cost per target: 27 operations per cell, 11 per body, and no square root.
import { LANES, add, at, div, mul, splat, sub } from '../memory/lanes';
import { scaledStrength } from './direct';
import { NBody, REAL } from './workspace';

// @ts-ignore: decorator
@inline function evaluate(w: NBody, first: i32, last: i32, inverseSquare: bool, dipole: bool): void {
  const soft = splat(<real>w.softening2);
  const one = splat(1);
  const factor = splat(inverseSquare ? 3 : 2);
  const second = splat(inverseSquare ? 2.5 : 2);
  const cells = w.cells;
  const cellsEnd = cells + ((<usize>w.cellCount) << 2);
  const ranges = w.ranges;
  const points = w.points;
  const pointsEnd = points + ((<usize>w.pointCount) << 2);
  const rangesEnd = ranges + ((<usize>w.rangeCount) << 3);
  for (let t = first; t < last; t += LANES) {
    const x = v128.load(w.px + at(t));
    const y = v128.load(w.py + at(t));
    let ax = splat(0);
    let ay = splat(0);
    for (let cell = cells; cell < cellsEnd; cell += 4) {
      const p = <usize>load<u32>(cell);
      const dx = sub(v128.load_splat<real>(p), x);
      const dy = sub(v128.load_splat<real>(p + REAL), y);
      const u = add(mul(dx, dx), add(mul(dy, dy), soft));
      const w1 = div(one, inverseSquare ? v128.sqrt<real>(u) : u);
      const per = inverseSquare ? mul(w1, w1) : w1;
      // d^-3 and d^-5, or d^-2 and d^-4.
      const r3 = inverseSquare ? mul(w1, per) : w1;
      const r5 = mul(r3, per);
      const xy = v128.load_splat<real>(p + 5 * REAL);
      const sx = add(mul(v128.load_splat<real>(p + 4 * REAL), dx), mul(xy, dy));
      const sy = add(mul(xy, dx), mul(v128.load_splat<real>(p + 7 * REAL), dy));
      const ds = add(mul(dx, sx), mul(dy, sy));
      let k = sub(mul(mul(second, ds), per), v128.load_splat<real>(p + 10 * REAL));
      if (dipole) {
        const gx = v128.load_splat<real>(p + 11 * REAL);
        const gy = v128.load_splat<real>(p + 12 * REAL);
        k = sub(k, mul(factor, add(mul(gx, dx), mul(gy, dy))));
        ax = add(ax, mul(gx, r3));
        ay = add(ay, mul(gy, r3));
      }
      k = add(mul(v128.load_splat<real>(p + 3 * REAL), r3), mul(k, r5));
      ax = add(ax, sub(mul(dx, k), mul(sx, r5)));
      ay = add(ay, sub(mul(dy, k), mul(sy, r5)));
    }
    for (let point = points; point < pointsEnd; point += 4) {
      const p = <usize>load<u32>(point);
      const dx = sub(v128.load_splat<real>(p), x);
      const dy = sub(v128.load_splat<real>(p + REAL), y);
      const u = add(mul(dx, dx), add(mul(dy, dy), soft));
      const k = scaledStrength(v128.load_splat<real>(p + 3 * REAL), u, inverseSquare);
      ax = add(ax, mul(dx, k));
      ay = add(ay, mul(dy, k));
    }
    for (let range = ranges; range < rangesEnd; range += 8) {
      const end = at(load<i32>(range, 4));
      for (let o = at(load<i32>(range)); o < end; o += REAL) {
        const dx = sub(v128.load_splat<real>(w.px + o), x);
        const dy = sub(v128.load_splat<real>(w.py + o), y);
        const u = add(mul(dx, dx), add(mul(dy, dy), soft));
        const k = scaledStrength(v128.load_splat<real>(w.ps + o), u, inverseSquare);
        ax = add(ax, mul(dx, k));
        ay = add(ay, mul(dy, k));
      }
    }
    v128.store(w.ax + at(t), ax);
    v128.store(w.ay + at(t), ay);
  }
}

export function evaluate2d(w: NBody, first: i32, last: i32, inverseSquare: bool, dipole: bool): void {
  if (inverseSquare) {
    if (dipole) evaluate(w, first, last, true, true);
    else evaluate(w, first, last, true, false);
  } else {
    if (dipole) evaluate(w, first, last, false, true);
    else evaluate(w, first, last, false, false);
  }
}

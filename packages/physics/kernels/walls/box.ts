// Bodies inside an axis-aligned box, one axis at a time.
//
// A body that ends the step beyond a wall met it inside the step. With `depth` beyond the wall, `speed` into it and the
// step's mean acceleration `pull` towards it, constant acceleration gives the speed at impact and the time since,
//     impact^2 = speed^2 - 2 pull depth,   since = 2 depth / (impact + speed),
// and the rebound flies for that time:
//     away = e impact - pull since,   out = e impact since - pull since^2 / 2.
// A rebound that ends within the step (out <= 0) is too short for it to resolve: the body rests on the wall.
import { Columns, columns, get } from '../columns';
import { LANES, add, at, div, mul, splat, sub } from '../lanes';
import { wallFriction } from './friction';

// Handles the lanes of one vector of rows against the wall at `plane` (already moved inward by the radius), whose
// inside is towards `side` (+1 or -1). Returns the change of normal velocity per lane, zero where nothing was hit.
// @ts-ignore: decorator
@inline function rebound(
  x: usize, v: usize, start: v128, plane: v128, side: v128, hit: v128, restitution: v128, dt: real,
): v128 {
  const zero = splat(0);
  const two = splat(2);
  const position = v128.load(x);
  const velocity = v128.load(v);
  const depth = mul(side, sub(plane, position));
  const speed = v128.neg<real>(mul(side, velocity));
  const pull = div(mul(side, sub(start, velocity)), splat(dt));
  const square = sub(mul(speed, speed), mul(mul(two, pull), depth));
  const impact = v128.sqrt<real>(v128.max<real>(square, zero));
  const since = v128.min<real>(div(mul(two, depth), add(impact, speed)), splat(dt));
  const leave = mul(restitution, impact);
  const fall = mul(pull, since);
  const out = mul(since, sub(leave, mul(splat(0.5), fall)));
  const flies = v128.and(v128.gt<real>(out, zero), v128.gt<real>(impact, zero));
  const entering = v128.and(hit, v128.gt<real>(speed, zero));
  const away = v128.and(sub(leave, fall), flies);
  v128.store(x, v128.bitselect(
    add(plane, v128.and(mul(side, out), v128.and(flies, entering))), position, hit));
  v128.store(v, v128.bitselect(mul(side, away), velocity, entering));
  return v128.and(add(away, speed), entering);
}

function rub(
  c: Columns, row: i32, change: v128, axis: i32, side: real, wallFrictionCoefficient: real,
): void {
  for (let lane = 0; lane < LANES; lane++) {
    const dv = lane == 0 ? v128.extract_lane<real>(change, 0)
      : lane == 1 ? v128.extract_lane<real>(change, 1)
      : sizeof<real>() == 4 && lane == 2 ? <real>f32x4.extract_lane(change, 2)
      : sizeof<real>() == 4 ? <real>f32x4.extract_lane(change, 3) : <real>0;
    if (!(dv > 0)) continue;
    const own = get(c.friction, row + lane);
    const mu = wallFrictionCoefficient < 0 ? own : sqrt<real>(own * wallFrictionCoefficient);
    if (mu > 0) {
      wallFriction(
        c, row + lane, axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0, mu, dv);
    }
  }
}

// Bounces rows [first, last) off the planes `low` and `high` of one axis (0, 1, 2). Only bodies with a collider
// (radius > 0) and mass > 0 are moved. `start` is the velocity column at the start of the step; the contact's
// restitution is the larger of the body's and the wall's; the friction coefficient is the geometric mean of the two,
// or the body's own where `friction` is negative.
export function boxAxis(
  axis: i32, x: usize, v: usize, start: usize, low: real, high: real, restitution: real, friction: real, dt: real,
  first: i32, last: i32,
): void {
  const c = columns();
  const zero = splat(0);
  const lowest = splat(low);
  const highest = splat(high);
  const wall = splat(restitution);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const radius = v128.load(c.radius + o);
    const position = v128.load(x + o);
    const lower = add(lowest, radius);
    const upper = sub(highest, radius);
    const below = v128.lt<real>(position, lower);
    const above = v128.gt<real>(position, upper);
    if (!v128.any_true(v128.or(below, above))) continue;
    const solid = v128.and(
      v128.gt<real>(radius, zero), v128.gt<real>(v128.load(c.mass + o), zero));
    const e = v128.max<real>(v128.load(c.restitution + o), wall);
    const startV = v128.load(start + o);
    const rough = v128.any_true(v128.gt<real>(v128.load(c.friction + o), zero));
    const hitLow = v128.and(below, solid);
    if (v128.any_true(hitLow)) {
      const change = rebound(x + o, v + o, startV, lower, splat(1), hitLow, e, dt);
      if (rough) rub(c, row, change, axis, 1, friction);
    }
    const hitHigh = v128.andnot(v128.and(above, solid), below);
    if (v128.any_true(hitHigh)) {
      const change = rebound(x + o, v + o, startV, upper, splat(-1), hitHigh, e, dt);
      if (rough) rub(c, row, change, axis, -1, friction);
    }
  }
}

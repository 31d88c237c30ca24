// The instant of impact on a flat surface, from the state at the end of the step. Generic over one body (`real`) and a
// vector of bodies (v128), so that the formula stands here alone.
//
// With `depth` beyond the surface, `speed` into it and the step's mean acceleration `pull` towards it, constant
// acceleration gives the time since the impact and the speed it happened at:
//     since = 2 depth / (sqrt(speed^2 - 2 pull depth) + speed),   impact = speed - pull since.
// A time longer than the step means that the body began the step beyond the surface; it counts as the whole step.
// A rebound that leaves at `leave` has since come
//     out = since (leave - pull since / 2)
// away from the surface. Where that is not positive the rebound ended within the step: it is too short for the step to
// resolve, and the body rests.

// @ts-ignore: decorator
@inline function plus<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.add<real>(a, b);
  return (a + b) as T;
}

// @ts-ignore: decorator
@inline function minus<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.sub<real>(a, b);
  return (a - b) as T;
}

// @ts-ignore: decorator
@inline function times<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.mul<real>(a, b);
  return (a * b) as T;
}

// @ts-ignore: decorator
@inline function over<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.div<real>(a, b);
  return (a / b) as T;
}

// @ts-ignore: decorator
@inline function root<T>(a: T): T {
  if (isVector<T>()) return v128.sqrt<real>(a);
  return sqrt<T>(a);
}

// @ts-ignore: decorator
@inline function smaller<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.min<real>(a, b);
  return min<T>(a, b);
}

// @ts-ignore: decorator
@inline function positive<T>(a: T): T {
  if (isVector<T>()) return v128.max<real>(a, v128.splat<real>(0));
  return max<T>(a, <T>0);
}

// Time since the impact, at most `dt`.
// @ts-ignore: decorator
@inline export function timeSince<T>(depth: T, speed: T, pull: T, dt: T): T {
  const twice = plus<T>(depth, depth);
  const then = root<T>(positive<T>(minus<T>(times<T>(speed, speed), times<T>(pull, twice))));
  return smaller<T>(over<T>(twice, plus<T>(then, speed)), dt);
}

// Speed into the surface at the impact.
// @ts-ignore: decorator
@inline export function impactSpeed<T>(speed: T, pull: T, since: T): T {
  return positive<T>(minus<T>(speed, times<T>(pull, since)));
}

// How far a rebound has come since.
// @ts-ignore: decorator
@inline export function distanceOut<T>(leave: T, pull: T, since: T, half: T): T {
  return times<T>(since, minus<T>(leave, times<T>(half, times<T>(pull, since))));
}

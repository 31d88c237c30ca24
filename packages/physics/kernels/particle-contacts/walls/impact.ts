// Impact on a flat surface, computed from the state at the end of the step. The functions are generic over one body
// (`real`) and a vector of bodies (v128), so that the formula exists only once.
//
// With `depth` beyond the surface, `speed` into it and the step's mean acceleration a towards it, constant acceleration
// gives the time since the impact and the impact speed:
//     t = 2 depth / (sqrt(speed^2 - 2 a depth) + speed),   impact = speed - a t.
// A time longer than the step means that the body began the step beyond the surface; it is clamped to the step. A
// rebound at speed u has since moved
//     out = t (u - a t / 2)
// away from the surface. If that is not positive, the rebound ended within the step: it is too short to resolve, and
// the body is at rest.
import { larger, smaller } from '../../memory/lanes';

// @ts-ignore: decorator
@inline function add<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.add<real>(a, b);
  return (a + b) as T;
}

// @ts-ignore: decorator
@inline function subtract<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.sub<real>(a, b);
  return (a - b) as T;
}

// @ts-ignore: decorator
@inline function multiply<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.mul<real>(a, b);
  return (a * b) as T;
}

// @ts-ignore: decorator
@inline function divide<T>(a: T, b: T): T {
  if (isVector<T>()) return v128.div<real>(a, b);
  return (a / b) as T;
}

// @ts-ignore: decorator
@inline function squareRoot<T>(a: T): T {
  if (isVector<T>()) return v128.sqrt<real>(a);
  return sqrt<T>(a);
}

// @ts-ignore: decorator
@inline function minimum<T>(a: T, b: T): T {
  if (isVector<T>()) return smaller(a as v128, b as v128) as T;
  return min<T>(a, b);
}

// @ts-ignore: decorator
@inline function clampToPositive<T>(a: T): T {
  if (isVector<T>()) return larger(a as v128, v128.splat<real>(0)) as T;
  return max<T>(a, <T>0);
}

// Returns the time since the impact, at most `dt`.
// @ts-ignore: decorator
@inline export function computeTimeSinceImpact<T>(depth: T, speed: T, acceleration: T, dt: T): T {
  const twice = add<T>(depth, depth);
  const impactSpeed = squareRoot<T>(
    clampToPositive<T>(subtract<T>(multiply<T>(speed, speed), multiply<T>(acceleration, twice))),
  );
  return minimum<T>(divide<T>(twice, add<T>(impactSpeed, speed)), dt);
}

// Returns the speed into the surface at the impact.
// @ts-ignore: decorator
@inline export function computeImpactSpeed<T>(speed: T, acceleration: T, timeSinceImpact: T): T {
  return clampToPositive<T>(subtract<T>(speed, multiply<T>(acceleration, timeSinceImpact)));
}

// Returns the distance that a rebound has moved away from the surface.
// @ts-ignore: decorator
@inline export function computeReboundDistance<T>(
  reboundSpeed: T,
  acceleration: T,
  timeSinceImpact: T,
  half: T,
): T {
  return multiply<T>(
    timeSinceImpact,
    subtract<T>(reboundSpeed, multiply<T>(half, multiply<T>(acceleration, timeSinceImpact))),
  );
}

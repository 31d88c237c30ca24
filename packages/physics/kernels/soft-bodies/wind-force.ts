// The aerodynamic force of the wind on LANES triangles.
//
//   F = rho A |u| (c_n (u.n) n + c_t (u - (u.n) n)) / 2, a third on each corner, u: wind minus mean velocity
import { add, div, dot, larger, mul, splat, sub } from '../memory/lanes';

// The wind, and, after `computeWindForce`, the force on each corner.
@unmanaged
class WindState {
  x: v128;
  y: v128;
  z: v128;
  // rho / 12, since the normal is as long as twice the area and the force is split over three corners.
  strength: v128;
  // c_n - c_t, and c_t.
  normalExcess: v128;
  tangential: v128;
  fx: v128;
  fy: v128;
  fz: v128;
}

export const windState = changetype<WindState>(memory.data(144, 16));

// Minimum square of twice an area, m^4: smaller triangles are degenerate, and their force vanishes with the square.
const MIN_SQUARE: real = 1e-36;

export function setWind(x: f64, y: f64, z: f64, density: f64, normal: f64, tangential: f64): void {
  windState.x = splat(<real>x);
  windState.y = splat(<real>y);
  windState.z = splat(<real>z);
  windState.strength = splat(<real>(density / 12));
  windState.normalExcess = splat(<real>normal - <real>tangential);
  windState.tangential = splat(<real>tangential);
}

// Computes the force from the vectors b and d from the first corner to the two others, and the sum v of the corners'
// velocities.
// @ts-ignore: decorator
@inline export function computeWindForce(
  bx: v128,
  by: v128,
  bz: v128,
  dx: v128,
  dy: v128,
  dz: v128,
  vx: v128,
  vy: v128,
  vz: v128,
): void {
  const third = splat(<real>(1.0 / 3));
  // The normal, as long as twice the area.
  const nx = sub(mul(by, dz), mul(bz, dy));
  const ny = sub(mul(bz, dx), mul(bx, dz));
  const nz = sub(mul(bx, dy), mul(by, dx));
  const square = dot(nx, ny, nz, nx, ny, nz);
  const ux = sub(windState.x, mul(vx, third));
  const uy = sub(windState.y, mul(vy, third));
  const uz = sub(windState.z, mul(vz, third));
  const scale = mul(windState.strength, v128.sqrt<real>(mul(square, dot(ux, uy, uz, ux, uy, uz))));
  const strength = v128.and(scale, v128.gt<real>(square, splat(0)));
  const normalTerm = mul(windState.normalExcess, dot(ux, uy, uz, nx, ny, nz));
  const normalPart = mul(strength, div(normalTerm, larger(square, splat(MIN_SQUARE))));
  const tangentPart = mul(strength, windState.tangential);
  windState.fx = add(mul(normalPart, nx), mul(tangentPart, ux));
  windState.fy = add(mul(normalPart, ny), mul(tangentPart, uy));
  windState.fz = add(mul(normalPart, nz), mul(tangentPart, uz));
}

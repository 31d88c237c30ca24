// The wind on LANES triangles.
//
//   F = rho A |u| (c_n (u.n) n + c_t (u - (u.n) n)) / 2, a third on each corner, u: wind minus mean velocity
import { add, div, dot, larger, mul, splat, sub } from '../memory/lanes';

// What blows, and, after `blow`, the force on each corner.
@unmanaged
class Breeze {
  x: v128;
  y: v128;
  z: v128;
  // rho / 12: a normal is as long as twice the area, and a force goes to three corners.
  strength: v128;
  // c_n - c_t, and c_t.
  across: v128;
  along: v128;
  fx: v128;
  fy: v128;
  fz: v128;
}

export const breeze = changetype<Breeze>(memory.data(144, 16));

// A square of twice an area that is as good as none, m^4: what it divides is smaller still.
const LEAST: real = 1e-36;

export function setBreeze(x: f64, y: f64, z: f64, density: f64, normal: f64, tangential: f64): void {
  breeze.x = splat(<real>x);
  breeze.y = splat(<real>y);
  breeze.z = splat(<real>z);
  breeze.strength = splat(<real>(density / 12));
  breeze.across = splat(<real>normal - <real>tangential);
  breeze.along = splat(<real>tangential);
}

// By the ways b and d from the first corner to the two others, and the sum v of the velocities of all three.
// @ts-ignore: decorator
@inline export function blow(
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
  const ux = sub(breeze.x, mul(vx, third));
  const uy = sub(breeze.y, mul(vy, third));
  const uz = sub(breeze.z, mul(vz, third));
  const scale = mul(breeze.strength, v128.sqrt<real>(mul(square, dot(ux, uy, uz, ux, uy, uz))));
  const push = v128.and(scale, v128.gt<real>(square, splat(0)));
  const across = mul(breeze.across, dot(ux, uy, uz, nx, ny, nz));
  const part = mul(push, div(across, larger(square, splat(LEAST))));
  const along = mul(push, breeze.along);
  breeze.fx = add(mul(part, nx), mul(along, ux));
  breeze.fy = add(mul(part, ny), mul(along, uy));
  breeze.fz = add(mul(part, nz), mul(along, uz));
}

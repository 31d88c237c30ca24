// A shell whose stars form a text: each star gets the velocity that brings it to its place in the text.
// |
// | r(t) = ln(1 + k v t)/k,  so  v = (e^(k r) - 1)/(k t)
// |
// | the way of a body at speed v under quadratic drag alone, after t    k  drag over mass, 1/m
//
// A rush away from the burst with quadratic drag: Parker, American Journal of Physics 45, 606 (1977). Buoyancy and
// wind move all stars nearly alike, so the text keeps its form while it rises.
import { exp } from '@principia/physics';

/** Largest number of stars of a text: each is a burst of its own, of which an emitter takes 256 in a step. */
export const MAX_TEXT_STARS = 240;
/** Numbers per star in a text: x and y within the unit circle, and the index of the colour, −1 for the shell's. */
export const TEXT_STRIDE = 3;
/**
 * Radius of the circle that a text fills, m, and the time after which it does, s. The stars are lanterns, which drag stops and
 * buoyancy holds: the fastest begin at 104 m/s, of which the first step takes k v dt = 43 %.
 */
export const TEXT_REACH = 15.5;
export const TEXT_TIME = 1.8;

/**
 * Velocities of the stars of a text relative to the shell, x and y in turn, m/s. Their sum is zero, so that the burst
 * keeps the momentum of the shell.
 * @param points of `TEXT_STRIDE` numbers each @param drag over mass, 1/m
 */
export function textVelocities(points: readonly number[], drag: number): Float64Array {
  const count = points.length / TEXT_STRIDE;
  const out = new Float64Array(2 * count);
  let [meanX, meanY] = [0, 0];
  for (let i = 0; i < count; i++) {
    const x = points[TEXT_STRIDE * i];
    const y = points[TEXT_STRIDE * i + 1];
    const distance = Math.sqrt(x * x + y * y);
    const speed = (exp(drag * TEXT_REACH * distance) - 1) / (drag * TEXT_TIME);
    const share = distance > 0 ? speed / distance : 0;
    out[2 * i] = share * x;
    out[2 * i + 1] = share * y;
    meanX += out[2 * i] / count;
    meanY += out[2 * i + 1] / count;
  }
  for (let i = 0; i < count; i++) {
    out[2 * i] -= meanX;
    out[2 * i + 1] -= meanY;
  }
  return out;
}

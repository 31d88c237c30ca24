/** The frame that turns with two bodies about their centre of mass, in which both stand still. */
import { defineLaw, type Force, scalar, vec3 } from '@principia/physics';
import type { Point } from '../picture.ts';

/** Centrifugal and Coriolis acceleration: a = Ω² r − 2 Ω × v. The second does no work. Goldstein, section 4.10. */
const law = defineLaw({
  name: 'rotating frame',
  formula: 'a = Ω² r − 2 Ω × v',
  source: 'Goldstein, Classical Mechanics, section 4.10.',
  parameters: { spin: scalar('rad/s') },
  dimensions: 2,
  acceleration({ position, velocity }, { spin }) {
    const coriolis = vec3(velocity.y, velocity.x.negate(), 0).mul(spin.mul(2));
    return position.mul(spin.square()).add(coriolis);
  },
  potential: ({ position, mass }, { spin }) => position.lengthSquared().mul(spin.square()).mul(mass).mul(-0.5),
});

/** @param spin Ω, rad/s */
export const rotatingFrame = (spin: number): Force => law({ spin });

/** A swing about Lagrange's point L4 in the frame that turns with Ω = 1, for small displacements e^(st). */
export interface Libration {
  /** Growth and angular frequency: the real and the imaginary part of s, per radian of the turn. */
  readonly growth: number;
  readonly frequency: number;
  /** Displacement and velocity at the start of a swing of amplitude 1 that does not grow. */
  readonly displacement: Point;
  readonly velocity: Point;
}

/**
 * The slower swing, a root of s⁴ + s² + 27 μ(1 − μ)/4 = 0; with μ beyond (1 − √(23/27))/2 = 0.03852 it grows (Routh
 * 1875). Murray and Dermott, Solar System Dynamics, section 3.7.
 * @param ratio μ, the mass of the lighter body by that of both
 */
export function libration(ratio: number): Libration {
  const under = 1 - 27 * ratio * (1 - ratio);
  if (under < 0) {
    // s² = (−1 + i √−under)/2, so |s²| and the real part give both parts of s.
    const size = Math.sqrt(1 - under) / 2;
    const none = { x: 0, y: 0 };
    return {
      growth: Math.sqrt((size - 1 / 2) / 2),
      frequency: Math.sqrt((size + 1 / 2) / 2),
      displacement: { x: 1, y: 0 },
      velocity: none,
    };
  }
  const frequency = Math.sqrt((1 - Math.sqrt(under)) / 2);
  // The first line of ẍ − 2ẏ = 3x/4 + c y, ÿ + 2ẋ = c x + 9y/4 with y = cos ωt.
  const c = ((3 * Math.sqrt(3)) / 4) * (1 - 2 * ratio);
  const scale = -1 / (frequency * frequency + 3 / 4);
  return {
    growth: 0,
    frequency,
    displacement: { x: c * scale, y: 1 },
    velocity: { x: -2 * frequency * frequency * scale, y: 0 },
  };
}

import { cos, exp, sin } from '@principia/physics';
import type { Point } from '../picture.ts';

/**
 * Point vortices of an ideal fluid in the plane, repeated along x: the velocity that they give to a point. Saffman, Vortex
 * Dynamics (1992), section 7.1; the core is that of Krasny (1986).
 */
export class PointVortices {
  readonly #period: number;
  #count = 0;
  /** Of each vortex: circulation and, with k = 2π/period, sin k x, cos k x, exp k y, exp −k y. */
  readonly #table: Float64Array;

  /** @param period length after which all is repeated, m */
  constructor(capacity: number, period: number) {
    this.#period = period;
    this.#table = new Float64Array(5 * capacity);
  }

  clear(): void {
    this.#count = 0;
  }

  /** @param circulation m²/s, positive counter-clockwise */
  add(x: number, y: number, circulation: number): void {
    const k = (2 * Math.PI) / this.#period;
    const rise = exp(k * y);
    this.#table.set([circulation, sin(k * x), cos(k * x), rise, 1 / rise], 5 * this.#count++);
  }

  /**
   * Writes the velocity of the fluid at a point to `result`, m/s. A vortex does not move itself.
   * @param core radius of the core of each vortex, which turns like a solid, m
   */
  velocityAt(x: number, y: number, core: number, result: { -readonly [Axis in keyof Point]: number }): void {
    const k = (2 * Math.PI) / this.#period;
    const [s, c, rise] = [sin(k * x), cos(k * x), exp(k * y)];
    const softening = (k * k * core * core) / 2;
    let [u, v] = [0, 0];
    for (let i = 0; i < 5 * this.#count; i += 5) {
      const table = this.#table;
      const [up, down] = [rise * table[i + 4], table[i + 3] / rise];
      const cosine = c * table[i + 2] + s * table[i + 1];
      const below = (up + down) / 2 - cosine + softening;
      if (below < 1e-12) continue;
      const strength = table[i] / (2 * this.#period * below);
      u -= (strength * (up - down)) / 2;
      v += strength * (s * table[i + 2] - c * table[i + 1]);
    }
    result.x = u;
    result.y = v;
  }
}

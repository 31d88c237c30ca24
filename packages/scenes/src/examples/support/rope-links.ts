/** The links of a rope as the book has them: springs, and damping of velocity differences in every direction. */
import { defineForce, type Force } from '@principia/physics';

export interface LinkOptions {
  /** Stiffness k of a link, N/m. */
  readonly stiffness: number;
  /** Damping c of the relative velocity of neighbours, kg/s. */
  readonly damping: number;
  /** Natural length L of a link, m. */
  readonly length: number;
}

/**
 * F on b = −k (d − L) n − c (v_b − v_a), and the opposite on a, for each pair of neighbours. Unlike the damping of
 * `springs`, it also brakes sideways motion.
 */
export function ropeLinks(ids: readonly number[], { stiffness, damping, length }: LinkOptions): Force {
  return defineForce({
    name: 'rope links',
    local: false,
    accumulate({ components: { Position: p, Velocity: v }, scratch: { force } }) {
      for (let i = 1; i < ids.length; i++) {
        const [a, b] = [ids[i - 1], ids[i]];
        const [dx, dy] = [p.x[b] - p.x[a], p.y[b] - p.y[a]];
        const pull = stiffness * (1 - length / Math.sqrt(dx * dx + dy * dy));
        const [fx, fy] = [pull * dx + damping * (v.x[b] - v.x[a]), pull * dy + damping * (v.y[b] - v.y[a])];
        force.x[a] += fx;
        force.y[a] += fy;
        force.x[b] -= fx;
        force.y[b] -= fy;
      }
    },
  });
}

import { defineComponent, real } from './define.ts';

/** A fixed centre of Newtonian attraction: it attracts bodies with Mass and is not affected by forces. */
export const Attractor = defineComponent({
  scalar: 'mu',
  fields: {
    /** Gravitational parameter μ = G M, m³/s²; negative repels. */
    mu: real('m³/s²', { bounds: { min: -1e38, max: 1e38 } }),
    /** Plummer softening length ε, m: the attraction is μ r / (r² + ε²)^(3/2), finite everywhere for ε > 0. */
    softening: real('m', { bounds: { min: 0, max: 1e12 } }),
  },
});

import { defineComponent, real } from './define.ts';

/** A round collider (disc in 2D, ball in 3D) at the body's position, and its surface properties. */
export const Collider = defineComponent({
  scalar: 'radius',
  fields: {
    /** Radius, m. */
    radius: real('m', {
      initial: 0.5,
      bounds: { min: 1e-9, max: 1e12 },
      hint: 'For a point without contacts, omit Collider.',
    }),
    /** Ratio of separation to approach speed: 0 inelastic, 1 elastic; above 1, up to 10, adds energy. */
    restitution: real('', { initial: 0, bounds: { min: 0, max: 10 } }),
    /** Coulomb friction coefficient, static and kinetic. */
    friction: real('', { initial: 0, bounds: { min: 0, max: 100 } }),
  },
});

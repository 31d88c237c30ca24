import { defineComponent, real } from './define.ts';

/** A round collider (disc in 2D, ball in 3D) about the body's position, and how its surface behaves. */
export const Collider = defineComponent({
  scalar: 'radius',
  fields: {
    /** Metres. */
    radius: real('m', {
      initial: 0.5,
      bounds: { min: 1e-9, max: 1e12 },
      hint: 'For a point that touches nothing, leave Collider out.',
    }),
    /** Ratio of separation to approach speed: 0 dead, 1 elastic; above 1 gains energy and is allowed up to 10. */
    restitution: real('', { initial: 0, bounds: { min: 0, max: 10 } }),
    /** Coulomb coefficient, static and kinetic alike. */
    friction: real('', { initial: 0, bounds: { min: 0, max: 100 } }),
  },
});

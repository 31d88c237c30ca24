import { defineComponent, real } from './define.ts';

/** Coefficient c of drag F = -c (v - w), kg/s; Stokes: 6 π η r. */
export const LinearDrag = defineComponent({
  scalar: 'coefficient',
  fields: { coefficient: real('kg/s', { bounds: { min: 0, max: 1e38 } }) },
});

/** Coefficient k of drag F = -k |v - w| (v - w), kg/m; k = ρ C_d A / 2. */
export const QuadraticDrag = defineComponent({
  scalar: 'coefficient',
  fields: { coefficient: real('kg/m', { bounds: { min: 0, max: 1e38 } }) },
});

/** Coefficient k of the drag on rotation τ = -k ω, N m s; Stokes: 8 π η r³ for a sphere. */
export const AngularDrag = defineComponent({
  scalar: 'coefficient',
  fields: { coefficient: real('N m s', { bounds: { min: 0, max: 1e38 } }) },
});

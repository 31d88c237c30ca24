import { defineComponent, real } from './define.ts';

/** Coefficient k of lift F = k |v| (s × v), kg/m; k = ρ C_L A / 2. Negative pushes down. */
export const Lift = defineComponent({
  scalar: 'coefficient',
  fields: { coefficient: real('kg/m', { bounds: { min: -1e38, max: 1e38 } }) },
});

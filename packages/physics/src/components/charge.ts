import { defineComponent, real } from './define.ts';

/** Electric charge, C. */
export const Charge = defineComponent({
  scalar: 'value',
  fields: { value: real('C', { bounds: { min: -1e38, max: 1e38 } }) },
});

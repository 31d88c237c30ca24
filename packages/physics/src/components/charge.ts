import { defineComponent, real } from './define';

/** Electric charge, C. */
export const Charge = defineComponent({
  scalar: 'value',
  fields: { value: real('C', { bounds: { min: -1e38, max: 1e38 } }) },
});

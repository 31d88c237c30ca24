import { defineComponent, real } from './define.ts';

/**
 * Factor of the acceleration by `uniformGravity` on this body: 0 for none, negative upwards. Without the component the
 * factor is 1, whatever is written to the column.
 */
export const GravityScale = defineComponent({
  scalar: 'value',
  fields: { value: real('', { initial: 1, bounds: { min: -1e6, max: 1e6 } }) },
});

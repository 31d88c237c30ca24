import { defineComponent, real } from './define';

/**
 * Mass, kg. A body without it (the column holds 0) is not moved by forces or contacts: it is static, or kinematic when
 * it has a velocity. Infinity is taken and means the same.
 */
export const Mass = defineComponent({
  name: 'Mass',
  key: 'mass',
  scalar: 'value',
  fields: {
    value: real('kg', {
      initial: 1,
      bounds: { above: 0, max: 1e38 },
      infinite: 0,
      hint: 'For a body that forces do not move, leave Mass out.',
    }),
  },
});

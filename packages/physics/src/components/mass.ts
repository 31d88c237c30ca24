import { defineComponent, type FieldSpec, real } from './define.ts';

/** Comments for editors: see `PositionFields`. */
export type MassFields = {
  /** Mass, kg; default 1. 0 in the column is a body that no force moves. */
  value: FieldSpec<'real'>;
};

/**
 * Mass, kg. Forces and contacts move bodies with Position, Velocity and Mass. A body without Mass (the column holds
 * 0) is static, or kinematic if it has a velocity; infinity means the same.
 */
export const Mass = defineComponent<{ readonly scalar: 'value'; readonly fields: MassFields }>({
  scalar: 'value',
  fields: {
    value: real('kg', {
      initial: 1,
      // Below 1e-37 kg an f32 world would store zero, which means static.
      bounds: { above: 0, min: 1e-37, max: 1e38 },
      infinite: 0,
      hint: 'For a body that forces do not move, omit Mass.',
    }),
  },
});

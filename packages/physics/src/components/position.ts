import { defineComponent, real } from './define.ts';

/** Largest |coordinate| a world takes, metres: 100 light-years would not fit, the solar system does a hundred times. */
export const MAX_POSITION = 1e15;

/** Where the centre of mass is, metres. Having it makes an entity a body. In 2D `z` is zero. */
export const Position = defineComponent({
  fields: {
    x: real('m', { bounds: { min: -MAX_POSITION, max: MAX_POSITION } }),
    y: real('m', { bounds: { min: -MAX_POSITION, max: MAX_POSITION } }),
    z: real('m', { bounds: { min: -MAX_POSITION, max: MAX_POSITION }, spatial: true }),
  },
});

import { defineComponent, real } from './define.ts';

/** The speed of light in vacuum, m/s, exact (SI): the maximum speed along an axis; larger values are clamped. */
export const MAX_SPEED = 299_792_458;

/** Velocity of the centre of mass, m/s. */
export const Velocity = defineComponent({
  fields: {
    x: real('m/s', { bounds: { min: -MAX_SPEED, max: MAX_SPEED } }),
    y: real('m/s', { bounds: { min: -MAX_SPEED, max: MAX_SPEED } }),
    z: real('m/s', { bounds: { min: -MAX_SPEED, max: MAX_SPEED }, spatial: true }),
  },
});

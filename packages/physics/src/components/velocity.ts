import { defineComponent, type FieldSpec, real } from './define.ts';

/** The speed of light in vacuum, m/s, exact (SI): the maximum speed along an axis; larger values are clamped. */
export const MAX_SPEED = 299_792_458;

/** The bounds of a velocity along an axis. */
export const VELOCITY_LIMITS = {
  min: -MAX_SPEED,
  max: MAX_SPEED,
  hint: 'The limit holds for the number, in whatever units: take a larger unit of length or a shorter one of time, as docs/units.md says.',
};

/** Comments for editors: see `PositionFields`. */
export type VelocityFields = {
  /** Along x, m/s; default 0. */
  x: FieldSpec<'real'>;
  /** Along y, m/s; default 0. */
  y: FieldSpec<'real'>;
  /** Along z, m/s; default 0. */
  z: FieldSpec<'real'>;
};

/** Velocity of the centre of mass, m/s. */
export const Velocity = defineComponent<{ readonly fields: VelocityFields }>({
  fields: {
    x: real('m/s', { bounds: VELOCITY_LIMITS }),
    y: real('m/s', { bounds: VELOCITY_LIMITS }),
    z: real('m/s', { bounds: VELOCITY_LIMITS, spatial: true }),
  },
});

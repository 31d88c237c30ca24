import { defineComponent, type FieldSpec, real } from './define.ts';

/** Maximum |coordinate|, m: a hundred times the size of the solar system, and less than 100 light-years. */
export const MAX_POSITION = 1e15;

/** The bounds of a coordinate. */
export const POSITION_LIMITS = {
  min: -MAX_POSITION,
  max: MAX_POSITION,
  hint: 'The limit holds for the number, in whatever units: take a larger unit of length, as docs/units.md says.',
};

/** Its own type, because declarations of inferred types lose the comments that editors show. */
export type PositionFields = {
  /** Along x, m; default 0. */
  x: FieldSpec<'real'>;
  /** Along y, m; default 0. */
  y: FieldSpec<'real'>;
  /** Along z, m; default 0. */
  z: FieldSpec<'real'>;
};

/** Position of the centre of mass, m. An entity with Position is a body. In 2D `z` is zero. */
export const Position = defineComponent<{ readonly fields: PositionFields }>({
  fields: {
    x: real('m', { bounds: POSITION_LIMITS }),
    y: real('m', { bounds: POSITION_LIMITS }),
    z: real('m', { bounds: POSITION_LIMITS, spatial: true }),
  },
});

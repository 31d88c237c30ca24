import { defineComponent, real } from './define.ts';

/** Maximum |coordinate|, m: a hundred times the size of the solar system, and less than 100 light-years. */
export const MAX_POSITION = 1e15;

/** Position of the centre of mass, m. An entity with Position is a body. In 2D `z` is zero. */
export const Position = defineComponent({
  fields: {
    x: real('m', { bounds: { min: -MAX_POSITION, max: MAX_POSITION } }),
    y: real('m', { bounds: { min: -MAX_POSITION, max: MAX_POSITION } }),
    z: real('m', { bounds: { min: -MAX_POSITION, max: MAX_POSITION }, spatial: true }),
  },
});

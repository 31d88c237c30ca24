import { defineComponent, normaliseFields, real } from './define.ts';
import { MAX_POSITION } from './position.ts';

const PLACE = { bounds: { min: -MAX_POSITION, max: MAX_POSITION } };
/** A normal of any length is taken; its square must stay finite in f32. */
const DIRECTION = { bounds: { min: -1e12, max: 1e12 } };

/** A straight wall between two points of the plane; both its sides and its ends are solid. 2D. */
export const SegmentWall = defineComponent({
  fields: {
    ax: real('m', PLACE),
    ay: real('m', PLACE),
    bx: real('m', PLACE),
    by: real('m', PLACE),
    restitution: real('', { bounds: { min: 0, max: 10 } }),
    friction: real('', { initial: 1, bounds: { min: 0, max: 100 } }),
  },
});

/** A half-space: solid where n·x < offset. The normal points out of it. 2D and 3D. */
export const PlaneWall = defineComponent({
  fields: {
    nx: real('', DIRECTION),
    ny: real('', { ...DIRECTION, initial: 1 }),
    nz: real('', { ...DIRECTION, spatial: true }),
    /** Distance of the plane from the origin along the normal, m. */
    offset: real('m', PLACE),
    restitution: real('', { bounds: { min: 0, max: 10 } }),
    friction: real('', { initial: 1, bounds: { min: 0, max: 100 } }),
  },
  complete(values, entity) {
    normaliseFields(
      values,
      ['nx', 'ny', 'nz'],
      'planeWall',
      'Give nx, ny and nz of the normal, such as { ny: 1 }.',
      entity,
    );
  },
});

import { defineComponent, normaliseFields, real } from './define.ts';
import { MAX_POSITION } from './position.ts';

const COORDINATE = { bounds: { min: -MAX_POSITION, max: MAX_POSITION } };
/** A normal of any length is valid; its square must be finite in f32. */
const DIRECTION = { bounds: { min: -1e12, max: 1e12 } };

/** A straight wall between two points, solid on both sides and at its ends. 2D only. */
export const SegmentWall = defineComponent({
  fields: {
    ax: real('m', COORDINATE),
    ay: real('m', COORDINATE),
    bx: real('m', COORDINATE),
    by: real('m', COORDINATE),
    restitution: real('', { bounds: { min: 0, max: 10 } }),
    friction: real('', { initial: 1, bounds: { min: 0, max: 100 } }),
  },
});

/** A half-space: solid where n·x < offset, with the outward normal n. 2D and 3D. */
export const PlaneWall = defineComponent({
  fields: {
    nx: real('', DIRECTION),
    ny: real('', { ...DIRECTION, initial: 1 }),
    nz: real('', { ...DIRECTION, spatial: true }),
    /** Distance of the plane from the origin along the normal, m. */
    offset: real('m', COORDINATE),
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

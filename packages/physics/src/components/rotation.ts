import { defineComponent, type FieldSpec, normaliseFields, real } from './define.ts';

/** Maximum |angular velocity| about an axis, rad/s; larger values are clamped. */
export const MAX_ANGULAR_SPEED = 1e9;

/** Maximum |angle|, rad; f32 cannot resolve directions long before. */
export const MAX_ANGLE = 1e12;

/** Maximum |component| of a quaternion in a column: unit quaternions stay within 1, and small drift is normalised. */
export const MAX_QUATERNION_COMPONENT = 2;

/** Comments for editors: see `PositionFields`. */
export type RotationFields = {
  /** Angle, rad, anticlockwise from +x; default 0. */
  angle: FieldSpec<'real'>;
};

/** Angle of the body in 2D, rad, anticlockwise from +x. */
export const Rotation = defineComponent<{ readonly scalar: 'angle'; readonly fields: RotationFields }>({
  scalar: 'angle',
  fields: { angle: real('rad', { bounds: { min: -MAX_ANGLE, max: MAX_ANGLE } }) },
});

const VECTOR_PART = { spatial: true, hint: 'In 2D give `rotation`, an angle in radians.' };

/** Orientation in 3D: the unit quaternion from the body's frame to the world's. Given values are normalised. */
export const Orientation = defineComponent({
  fields: { x: real('', VECTOR_PART), y: real('', VECTOR_PART), z: real('', VECTOR_PART), w: real('', { initial: 1 }) },
  complete(values, entity) {
    normaliseFields(
      values,
      ['x', 'y', 'z', 'w'],
      'orientation',
      'Give a quaternion of length 1; { w: 1 } is the identity.',
      entity,
    );
  },
});

/** Comments for editors: see `PositionFields`. */
export type AngularVelocityFields = {
  /** About x, rad/s; default 0. */
  x: FieldSpec<'real'>;
  /** About y, rad/s; default 0. */
  y: FieldSpec<'real'>;
  /** About z, rad/s, in 2D anticlockwise; default 0. */
  z: FieldSpec<'real'>;
};

/** Angular velocity, rad/s. In 2D only `z` rotates the body, anticlockwise. */
export const AngularVelocity = defineComponent<{ readonly scalar: 'z'; readonly fields: AngularVelocityFields }>({
  scalar: 'z',
  fields: {
    x: real('rad/s', { bounds: { min: -MAX_ANGULAR_SPEED, max: MAX_ANGULAR_SPEED }, spatial: true }),
    y: real('rad/s', { bounds: { min: -MAX_ANGULAR_SPEED, max: MAX_ANGULAR_SPEED }, spatial: true }),
    z: real('rad/s', { bounds: { min: -MAX_ANGULAR_SPEED, max: MAX_ANGULAR_SPEED } }),
  },
});

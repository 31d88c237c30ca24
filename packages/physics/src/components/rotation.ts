import { defineComponent, normaliseFields, real } from './define.ts';

/** Largest |angular velocity| about an axis, rad/s; a value beyond is capped. */
export const MAX_ANGULAR_SPEED = 1e9;

/** Largest |angle| a world takes, radians; f32 tells no directions apart long before. */
export const MAX_ANGLE = 1e12;

/** Largest |part| of a quaternion found in a column: those of a unit one stay within 1, and a little drift is put right. */
export const MAX_QUATERNION_PART = 2;

/** 2D: angle of the body, radians, anticlockwise from +x. */
export const Rotation = defineComponent({
  scalar: 'angle',
  fields: { angle: real('rad', { bounds: { min: -MAX_ANGLE, max: MAX_ANGLE } }) },
});

/** 3D: unit quaternion from the body's frame to the world's. Given values are normalised. */
export const Orientation = defineComponent({
  fields: { x: real(''), y: real(''), z: real(''), w: real('', { initial: 1 }) },
  complete(values, entity) {
    normaliseFields(
      values,
      ['x', 'y', 'z', 'w'],
      'orientation',
      'Give a quaternion of length 1; { w: 1 } is "not rotated".',
      entity,
    );
  },
});

/** Angular velocity, rad/s. In 2D only `z` turns the body, anticlockwise. */
export const AngularVelocity = defineComponent({
  scalar: 'z',
  fields: {
    x: real('rad/s', { bounds: { min: -MAX_ANGULAR_SPEED, max: MAX_ANGULAR_SPEED }, spatial: true }),
    y: real('rad/s', { bounds: { min: -MAX_ANGULAR_SPEED, max: MAX_ANGULAR_SPEED }, spatial: true }),
    z: real('rad/s', { bounds: { min: -MAX_ANGULAR_SPEED, max: MAX_ANGULAR_SPEED } }),
  },
});

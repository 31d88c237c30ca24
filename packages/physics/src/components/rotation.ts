import { PhysicsError } from '../faults/physics-error';
import { defineComponent, real } from './define';

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
    const { x = 0, y = 0, z = 0, w = 0 } = values;
    const norm = Math.sqrt(x * x + y * y + z * z + w * w);
    if (!(norm > 1e-12) || !Number.isFinite(norm)) {
      throw new PhysicsError('E_RANGE', `orientation (${x}, ${y}, ${z}, ${w}) has no direction.`, {
        entity,
        field: 'orientation',
        value: values,
        hint: 'Give a quaternion of length 1; { w: 1 } is "not rotated".',
      });
    }
    values.x = x / norm;
    values.y = y / norm;
    values.z = z / norm;
    values.w = w / norm;
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

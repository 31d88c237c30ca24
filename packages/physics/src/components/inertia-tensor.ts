import { PhysicsError } from '../errors/physics-error.ts';
import { defineComponent, real } from './define.ts';

/** Rounding by which a flat body may violate the triangle inequality: x = y + z holds for it exactly. */
export const ROUNDING = 1e-6;

const MOMENT = {
  initial: 1,
  bounds: { above: 0, max: 1e38 },
  spatial: true,
  hint: 'Give the three principal moments, such as those of boxInertia(mass, size).',
};

/**
 * Principal moments of inertia about the x, y and z axes of the body, kg m². The body's axes are its principal axes. It
 * replaces Inertia in the rotation of a body with Orientation and AngularVelocity, which then precesses, nutates and
 * tumbles. No moment exceeds the sum of the other two.
 */
export const InertiaTensor = defineComponent({
  fields: { x: real('kg m²', MOMENT), y: real('kg m²', MOMENT), z: real('kg m²', MOMENT) },
  complete({ x, y, z }, entity) {
    const largest = Math.max(x, y, z);
    if (largest <= (x + y + z - largest) * (1 + ROUNDING)) return;
    throw new PhysicsError(
      'E_RANGE',
      `inertiaTensor (${x}, ${y}, ${z}) belongs to no body: one moment exceeds the sum of the other two.`,
      {
        entity,
        field: 'inertiaTensor',
        value: { x, y, z },
        hint: 'Give the principal moments in the body’s axes: ∫(y² + z²) dm, ∫(x² + z²) dm and ∫(x² + y²) dm.',
      },
    );
  },
});

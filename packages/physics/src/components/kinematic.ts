import { defineComponent } from './define.ts';

/**
 * Marks a rigid body that moves by its velocity whatever it meets, although it has mass: forces, contacts and joints do not
 * change it. Removing the component gives it back to them, with the velocity that it has. A body without mass needs no mark.
 */
export const Kinematic = defineComponent({ fields: {} });

import { defineComponent, u32 } from './define.ts';

/**
 * Marks a body with an invalid state: it rests at its last valid pose, whatever acts on it, until its Position or
 * Velocity is set, as by `addComponent(world, id, set(Velocity, { x: 2 }))`, or the component is removed. Values written to
 * columns do not release it.
 */
export const Quarantined = defineComponent({
  scalar: 'step',
  fields: { step: u32('', {}) },
});

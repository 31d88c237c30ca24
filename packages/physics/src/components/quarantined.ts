import { defineComponent, u32 } from './define.ts';

/**
 * Marks a body with an invalid state: it rests at its last valid pose, whatever acts on it, until its Position or
 * Velocity is set, or the component is removed.
 */
export const Quarantined = defineComponent({
  scalar: 'step',
  fields: { step: u32('', {}) },
});

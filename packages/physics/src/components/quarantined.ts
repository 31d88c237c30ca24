import { defineComponent, u32 } from './define.ts';

/** Marks a body with a non-finite state: it was reset to its last valid pose and stopped. */
export const Quarantined = defineComponent({
  scalar: 'step',
  fields: { step: u32('', {}) },
});

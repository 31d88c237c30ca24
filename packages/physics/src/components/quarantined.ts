import { defineComponent, u32 } from './define.ts';

/** Marks a body whose values became nonsense: it was put back to its last good pose and stopped. */
export const Quarantined = defineComponent({
  scalar: 'step',
  fields: { step: u32('', {}) },
});

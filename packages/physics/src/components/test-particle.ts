import { defineComponent } from './define.ts';

/** Marks a test particle: mutual forces act on it, but it exerts none. */
export const TestParticle = defineComponent({
  fields: {},
});

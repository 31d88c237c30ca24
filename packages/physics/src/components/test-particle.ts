import { defineComponent } from './define.ts';

/** Marks a body that feels mutual forces but exerts none: it follows the field of the others. */
export const TestParticle = defineComponent({
  fields: {},
});

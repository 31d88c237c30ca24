import { defineComponent } from './define';

/** Marks a body that feels mutual forces but exerts none: it follows the field of the others. */
export const TestParticle = defineComponent({
  fields: {},
});

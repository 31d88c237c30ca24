import { defineComponent } from './define.ts';

/** Marks a rigid body that does not fall asleep, nor do the bodies that it touches or is joined to. */
export const NeverSleep = defineComponent({ fields: {} });

import { defineComponent } from './define.ts';

/** Marks a rigid body that moves and does not fall asleep, nor do the bodies that it touches or is joined to; on a static one it does nothing. */
export const NeverSleep = defineComponent({ fields: {} });

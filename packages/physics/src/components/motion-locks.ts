import { defineComponent, flag } from './define.ts';

/**
 * Which motions of a rigid body are locked: its velocity along these axes of the world stays 0, whatever acts on it. Without
 * the component none is, whatever is written to the columns.
 */
export const MotionLocks = defineComponent({
  fields: {
    /** 1 where the body does not move along x. */
    x: flag(),
    /** 1 where the body does not move along y. */
    y: flag(),
    /** 1 where the body does not turn. */
    angle: flag(),
  },
});

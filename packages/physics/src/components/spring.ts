import { defineComponent, real, u32 } from './define';

/** A damped Hooke spring between two bodies. The entity that has it is the spring; `a` and `b` are body ids. */
export const Spring = defineComponent({
  name: 'Spring',
  key: 'spring',
  fields: {
    a: u32('id', { bounds: { min: 1 } }),
    b: u32('id', { bounds: { min: 1 } }),
    /** Force per extension, N/m. */
    stiffness: real('N/m', { bounds: { min: 0, max: 1e30 } }),
    /** Force per speed of extension, N s/m. */
    damping: real('N s/m', { bounds: { min: 0, max: 1e30 } }),
    /** Natural length, m. */
    length: real('m', { bounds: { min: 0, max: 1e12 } }),
  },
});

import { defineComponent, real } from './define.ts';

/**
 * Moment of inertia about the centre, kg m²: a disc has m r²/2, a solid sphere 2 m r²/5. Zero, or no component, locks
 * the rotation: contacts do not turn the body.
 */
export const Inertia = defineComponent({
  scalar: 'value',
  fields: { value: real('kg m²', { initial: 1, bounds: { min: 0, max: 1e38 }, infinite: 0 }) },
});

import { defineComponent, type FieldSpec, real } from './define.ts';

/** Comments for editors: see `PositionFields`. */
export type InertiaFields = {
  /** Moment of inertia about the centre, kg m²; default 1. */
  value: FieldSpec<'real'>;
};

/**
 * Moment of inertia about the centre, kg m²: m r²/2 for a disc, 2 m r²/5 for a solid sphere. Zero, or an absent
 * component, locks the rotation: contacts do not rotate the body.
 */
export const Inertia = defineComponent<{ readonly scalar: 'value'; readonly fields: InertiaFields }>({
  scalar: 'value',
  fields: { value: real('kg m²', { initial: 1, bounds: { min: 0, max: 1e38 }, infinite: 0 }) },
});

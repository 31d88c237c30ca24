import { PhysicsError } from '../errors/physics-error.ts';
import { bodyId, defineComponent, flag, real, u32 } from './define.ts';

/**
 * A damped Hooke spring between two bodies. The entity with this component is the spring, and is removed with either
 * of its bodies. A body without mass is an anchor.
 */
export const Spring = defineComponent({
  fields: {
    /** The ids of the bodies that it joins. */
    a: bodyId('aGeneration', true),
    b: bodyId('bGeneration', true),
    /** The generations of these ids, filled in by the engine. */
    aGeneration: u32(''),
    bGeneration: u32(''),
    /** Force per extension, N/m. Infinity makes a rod, or an inextensible string: only for the integrator `xpbd`. */
    stiffness: real('N/m', { bounds: { min: 0, max: 1e30 }, infinite: 1e30 }),
    /** Force per rate of extension, N s/m. */
    damping: real('N s/m', { bounds: { min: 0, max: 1e30 } }),
    /** Natural length, m. */
    length: real('m', { bounds: { min: 0, max: 1e12 } }),
    /**
     * 1 for a spring that only pulls, like a rope: it exerts no force below its natural length. 0 for a spring that
     * also pushes.
     */
    tensionOnly: flag(),
    /** Tension at which the spring breaks, N, if the system `breakSprings` runs; 0 for never. */
    breakForce: real('N', { bounds: { min: 0, max: 1e30 } }),
  },
  complete({ a, b }, entity) {
    if (a !== 0 && b !== 0 && a !== b) return;
    const problem = a === b && a !== 0 ? `spring joins body ${a} to itself.` : 'spring needs two bodies, a and b.';
    throw new PhysicsError('E_RANGE', problem, {
      entity,
      field: 'spring.b',
      value: b,
      hint: 'Give the ids of two different bodies as a and b.',
    });
  },
});

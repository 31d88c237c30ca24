import { PhysicsError } from '../errors/physics-error.ts';
import { bodyId, defineComponent, real, u32 } from './define.ts';

/**
 * A damped Hooke spring between two bodies. The entity that has it is the spring, and goes when one of its bodies goes.
 * A body without mass is an anchor.
 */
export const Spring = defineComponent({
  fields: {
    /** The bodies it joins, by id. */
    a: bodyId('aLife'),
    b: bodyId('bLife'),
    /** Which life of those ids is meant; filled in by the engine. */
    aLife: u32(''),
    bLife: u32(''),
    /** Force per extension, N/m. Infinity makes a rod, or an inextensible string: for the integrator `xpbd` only. */
    stiffness: real('N/m', { bounds: { min: 0, max: 1e30 }, infinite: 1e30 }),
    /** Force per speed of extension, N s/m. */
    damping: real('N s/m', { bounds: { min: 0, max: 1e30 } }),
    /** Natural length, m. */
    length: real('m', { bounds: { min: 0, max: 1e12 } }),
    /** 1 for a cord, which pulls when longer than its natural length and never pushes. */
    cord: u32('', { bounds: { max: 1 } }),
    /** Pull at which it breaks where the system `breakSprings` runs, N; 0 for never. */
    breakForce: real('N', { bounds: { min: 0, max: 1e30 } }),
  },
  complete({ a, b }, entity) {
    if (a !== 0 && b !== 0 && a !== b) return;
    const problem = a === b && a !== 0 ? `spring joins body ${a} to itself.` : 'spring needs two bodies.';
    throw new PhysicsError('E_RANGE', problem, {
      entity,
      field: 'spring.b',
      value: b,
      hint: 'Give the ids of two different bodies as a and b.',
    });
  },
});

/**
 * Units to measure a world in, in place of ours. Nature does not know units: where lengths, masses, times and charges are all
 * measured in others, everything moves as before. Units that are powers of four of ours change no digit, neither of a number
 * nor of its root, so that a constant with a unit that hides anywhere shows in the last bit.
 */

/** Our metre, kilogram, second and coulomb in the other units. */
export const [METRE, KILOGRAM, SECOND, COULOMB] = [2 ** 4, 2 ** -6, 2 ** 2, 2 ** -2] as const;

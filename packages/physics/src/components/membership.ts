// Which components an entity has: bits in two words. Kernels and laws test several components of the first word at
// once; components that only TypeScript asks for may be in the second. The bits that are left in the second belong to the
// components of the user, in the order in which a world was given them.
import { PhysicsError } from '../errors/physics-error.ts';
import { COMPONENT_NAMES, type ComponentName } from './all.ts';

/** Components in the first word: 31, so that every combination of bits is a positive 32-bit number. */
export const FIRST_WORD = 31;

const PLACES = new Map(COMPONENT_NAMES.map((name, place) => [name, place]));

/** Whether the bit of a component is in the first word. */
export function isInFirstWord(name: ComponentName): boolean {
  return (PLACES.get(name) as number) < FIRST_WORD;
}

/** The bit of a component in its word. */
export function bitInWord(name: ComponentName): number {
  return 1 << ((PLACES.get(name) as number) % FIRST_WORD);
}

/**
 * The bit of a component in the first word, which kernels combine.
 * @throws PhysicsError E_RANGE if it is in the second: COMPONENTS must list it earlier
 */
export function bitOf(name: ComponentName): number {
  if (isInFirstWord(name)) return bitInWord(name);
  throw new PhysicsError('E_RANGE', `kernels cannot ask for ${name}: its bit is not in the first word.`, {
    field: name,
    hint: `List it among the first ${FIRST_WORD} components in components/all.ts.`,
  });
}

/** Components in the second word. */
const IN_SECOND_WORD = Math.max(0, COMPONENT_NAMES.length - FIRST_WORD);

/** The bits of the second word that belong to components of the package. */
export const BUILT_IN_BITS = (1 << IN_SECOND_WORD) - 1;

/** How many components of the user have a bit. */
export const MAX_OWN_BITS = FIRST_WORD - IN_SECOND_WORD;

/** The bit of a component of the user in the second word, by its place among those of the world; 0 beyond the last bit. */
export function ownBitAt(place: number): number {
  return place < MAX_OWN_BITS ? 1 << (IN_SECOND_WORD + place) : 0;
}

/** Bits of several components in each of the two words. */
export interface MemberBits {
  readonly first: number;
  readonly second: number;
}

export function bitsOf(names: Iterable<ComponentName>): MemberBits {
  let [first, second] = [0, 0];
  for (const name of names) {
    if (isInFirstWord(name)) first |= bitInWord(name);
    else second |= bitInWord(name);
  }
  return { first, second };
}

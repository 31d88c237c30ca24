import { mustBe } from '../errors/validate.ts';

/**
 * Checks what a function that fills lists is given to write to.
 * @throws PhysicsError E_TYPE unless a call of that function without an argument has made it
 */
export function checkLists(into: object, lists: readonly unknown[], maker: string): void {
  if (!lists.every(Array.isArray) || Object.isFrozen(into))
    throw mustBe(`a list made by ${maker}`, into, `${maker}: into`);
}

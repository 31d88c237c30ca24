// Pairs of bodies that were put into each other and meet in two points. Of the speed at which these are pushed apart one relaxing pass
// leaves a tenth to a third, because what one point takes turns the bodies, which loads the other. So their contact gets more passes,
// until next to nothing is left. In crowds each pass moves the neighbours as well: those have crowds.ts.
import { IS_DEEP_PAIR, RigidContact, contactAt } from '../../collision/narrow-phase/2d/rigid-contact';
import { LANES } from '../../memory/lanes';
import { JOINED, flagsOf, word } from './body';
import * as block from './contact-block';
import { RigidTable } from './rigid-table';

// Additional relaxing passes: each leaves about a third.
export const DEEP_PASSES: i32 = 3;

// Finds whether a deep contact is that of such a pair. Contacts have their colors.
export function noteDeepPair(t: RigidTable, contact: RigidContact): void {
  if (contact.count < 2 || !touchesOnce(t, contact.bodyA) || !touchesOnce(t, contact.bodyB)) return;
  contact.flags |= IS_DEEP_PAIR;
  t.deepPairCount++;
}

function touchesOnce(t: RigidTable, body: i32): bool {
  return popcnt<i32>(word(t.usedColors, body)) == 1 && (flagsOf(t, body) & JOINED) == 0;
}

// The lanes of a block with such pairs. Lanes without a contact have no mass, and nothing happens in them.
export function deepPairLanes(t: RigidTable, at: usize): v128 {
  let lanes = i32x4.splat(0);
  for (let l = LANES - 1; l >= 0; l--) {
    lanes = LANES == 4 ? v128.shuffle<u32>(lanes, lanes, 0, 0, 1, 2) : v128.shuffle<u64>(lanes, lanes, 0, 0);
    const isPair = (contactAt(t, word(at + block.SLOT, l)).flags & IS_DEEP_PAIR) != 0;
    lanes = LANES == 4 ? i32x4.replace_lane(lanes, 0, isPair ? -1 : 0) : i64x2.replace_lane(lanes, 0, isPair ? -1 : 0);
  }
  return lanes;
}

// The bodies that came, moved or changed their shape since trees were made: these do not know where they are now, and a query looks at
// each of them.
import { Columns, columns, get } from '../../../memory/columns';
import { putWord, word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { GROUP } from '../../../solver/2d/settled-rows';

// Copies of four columns of reals and two of words are kept.
const REALS: usize = 4;

// Bytes that the copies take for each row.
// @ts-ignore: decorator
@inline export const REMEMBERED_BLOCK: usize = REALS * sizeof<real>() + 8;

// Where more than one row of so many changed, looking at all of them takes no longer.
const FEW: i32 = 8;

// Keeps where bodies and their shapes are.
export function rememberColumns(t: RigidTable, rows: i32): void {
  const c = columns();
  const length = (rows + GROUP - 1) & -GROUP;
  t.rememberedRows = length;
  t.changedRowCount = 0;
  const reals = <usize>length * sizeof<real>();
  memory.copy(realsOf(t, 0), c.positionX, reals);
  memory.copy(realsOf(t, 1), c.positionY, reals);
  memory.copy(realsOf(t, 2), t.angle, reals);
  memory.copy(realsOf(t, 3), c.radius, reals);
  memory.copy(wordsOf(t, 0), c.shape, (<usize>length) << 2);
  memory.copy(wordsOf(t, 1), c.members, (<usize>length) << 2);
}

// The copy of a column of reals, and of one of words.
// @ts-ignore: decorator
@inline function realsOf(t: RigidTable, i: usize): usize {
  return t.rememberedColumns + i * <usize>t.rememberedRows * sizeof<real>();
}

// @ts-ignore: decorator
@inline function wordsOf(t: RigidTable, i: usize): usize {
  return realsOf(t, REALS) + ((i * <usize>t.rememberedRows) << 2);
}

// Lists the rows that differ from what was kept, ascending; a count of -1 says that they are too many.
export function listChangedRows(t: RigidTable, rows: i32): void {
  const c = columns();
  const most = rows / FEW;
  let count = 0;
  for (let first = 0; first < rows; first += GROUP) {
    const isKept = first < t.rememberedRows;
    if (isKept && !isGroupChanged(c, t, first)) continue;
    const end = min<i32>(first + GROUP, rows);
    for (let row = max<i32>(first, 1); row < end; row++) {
      if (isKept && !isRowChanged(c, t, row)) continue;
      if (count == most) {
        t.changedRowCount = -1;
        return;
      }
      putWord(t.changedRows, count++, row);
    }
  }
  t.changedRowCount = count;
}

function isRowChanged(c: Columns, t: RigidTable, row: i32): bool {
  return (
    get(c.positionX, row) != get(realsOf(t, 0), row) ||
    get(c.positionY, row) != get(realsOf(t, 1), row) ||
    get(t.angle, row) != get(realsOf(t, 2), row) ||
    get(c.radius, row) != get(realsOf(t, 3), row) ||
    word(c.shape, row) != word(wordsOf(t, 0), row) ||
    word(c.members, row) != word(wordsOf(t, 1), row)
  );
}

// Whether the bits of any row of a group differ.
function isGroupChanged(c: Columns, t: RigidTable, first: i32): bool {
  const reals = <usize>first * sizeof<real>();
  const words = (<usize>first) << 2;
  let different = differences(c.positionX + reals, realsOf(t, 0) + reals, sizeof<real>());
  different = v128.or(different, differences(c.positionY + reals, realsOf(t, 1) + reals, sizeof<real>()));
  different = v128.or(different, differences(t.angle + reals, realsOf(t, 2) + reals, sizeof<real>()));
  different = v128.or(different, differences(c.radius + reals, realsOf(t, 3) + reals, sizeof<real>()));
  different = v128.or(different, differences(c.shape + words, wordsOf(t, 0) + words, 4));
  different = v128.or(different, differences(c.members + words, wordsOf(t, 1) + words, 4));
  return v128.any_true(different);
}

// @ts-ignore: decorator
@inline function differences(a: usize, b: usize, bytes: usize): v128 {
  let different = i32x4.splat(0);
  for (let p: usize = 0; p < <usize>GROUP * bytes; p += 16)
    different = v128.or(different, v128.xor(v128.load(a + p), v128.load(b + p)));
  return different;
}

// Whether anyone changed a spring or a mass in place since the rows were read. To compare everything with a copy would
// take as long as to read it: what is compared is a sum of 512 bits, in which the change of one value always shows, and
// that of several with all but certainty.
import { columns } from '../memory/columns';
import { SpringTable } from '../forces/springs';
import { ConstraintTable, word } from './table';

// Rows in which nobody owns anything are looked at, too, up to so many for each that counts.
const SPARSE: i32 = 4;

// The sum, of which each 32 bits know every sixteenth word.
let sum0: v128 = i32x4.splat(0);
let sum1: v128 = i32x4.splat(0);
let sum2: v128 = i32x4.splat(0);
let sum3: v128 = i32x4.splat(0);

// Every step of it is one to one: no change of one word is lost on the way.
// @ts-ignore: decorator
@inline function stir(sum: v128, words: v128): v128 {
  const product = i32x4.mul(v128.xor(sum, words), i32x4.splat(0x01000193));
  return v128.xor(product, i32x4.shr_u(product, 15));
}

function addRows(column: usize, first: i32, last: i32, bytes: i32): void {
  let a = sum0;
  let b = sum1;
  let c = sum2;
  let d = sum3;
  const end = column + <usize>(last * bytes);
  for (let p = column + <usize>(first * bytes); p < end; p += 64) {
    a = stir(a, v128.load(p));
    b = stir(b, v128.load(p, 16));
    c = stir(c, v128.load(p, 32));
    d = stir(d, v128.load(p, 48));
  }
  sum0 = a;
  sum1 = b;
  sum2 = c;
  sum3 = d;
}

// Whether the sum over springs and masses is the one it was, for sub-steps of h seconds; keeps it.
export function areUnchanged(t: ConstraintTable, h: f64): bool {
  const springs = changetype<SpringTable>(t.springs);
  if (springs.count == 0 || t.nodeCount == 0) return false;
  const first = word(springs.ids, 0) & ~15;
  const last = (word(springs.ids, springs.count - 1) + 16) & ~15;
  const firstNode = word(t.nodes, 0) & ~15;
  const lastNode = (word(t.nodes, t.nodeCount - 1) + 16) & ~15;
  if (<i32>(last - first) > 64 + SPARSE * springs.count) return false;
  if (<i32>(lastNode - firstNode) > 64 + SPARSE * t.nodeCount) return false;
  sum0 = i32x4.splat(1);
  sum1 = i64x2.splat(reinterpret<i64>(h));
  sum2 = i32x4.splat(2);
  sum3 = i32x4.splat(3);
  addRows(springs.a, first, last, 4);
  addRows(springs.b, first, last, 4);
  addRows(springs.cord, first, last, 4);
  const bytes = sizeof<real>();
  addRows(springs.length, first, last, bytes);
  addRows(springs.stiffness, first, last, bytes);
  addRows(springs.damping, first, last, bytes);
  addRows(t.breakForce, first, last, bytes);
  addRows(columns().mass, firstNode, lastNode, bytes);
  const before = t.sum;
  const same = v128.or(
    v128.or(v128.xor(v128.load(before), sum0), v128.xor(v128.load(before, 16), sum1)),
    v128.or(v128.xor(v128.load(before, 32), sum2), v128.xor(v128.load(before, 48), sum3)),
  );
  v128.store(before, sum0);
  v128.store(before, sum1, 16);
  v128.store(before, sum2, 32);
  v128.store(before, sum3, 48);
  return !v128.any_true(same);
}

// The next sum is another one.
export function forgetSum(t: ConstraintTable): void {
  memory.fill(t.sum, 0, 64);
}

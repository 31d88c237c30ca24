// Where the columns lie, and what a vector is. Every column begins at an address that the compiler knows, so that a load
// or a store needs one register with the row and none with the column.

// Rows for which there is room, a multiple of 1024; what is not touched takes no memory.
const ROWS: usize = 8_000_512;

// Some lines of the cache more than the rows take: columns an exact power of two apart would share the same few lines.
const STRIDE: usize = ROWS * sizeof<real>() + 320;

const FIRST: usize = 1 << 17;

export const X: usize = FIRST;
export const Y: usize = FIRST + STRIDE;
export const Z: usize = FIRST + 2 * STRIDE;
export const VX: usize = FIRST + 3 * STRIDE;
export const VY: usize = FIRST + 4 * STRIDE;
export const VZ: usize = FIRST + 5 * STRIDE;
export const PREVIOUS_X: usize = FIRST + 6 * STRIDE;
export const PREVIOUS_Y: usize = FIRST + 7 * STRIDE;
export const PREVIOUS_Z: usize = FIRST + 8 * STRIDE;
export const MASS: usize = FIRST + 9 * STRIDE;
export const DRAG: usize = FIRST + 10 * STRIDE;
export const RADIUS: usize = FIRST + 11 * STRIDE;

const END: usize = FIRST + 12 * STRIDE;

// Vectors of which the hits are listed before they rebound, few enough for their columns to be in the cache still.
export const TILE: usize = 256;

// An entry of a list: the offset of the vector, and its velocities along the axis at the start of the step.
export const ENTRY_BYTES: usize = 32;

const LIST_BYTES: usize = (TILE + 2) * ENTRY_BYTES;

// The lists of vectors with a body beyond a wall, one for each axis.
export const HITS_X: usize = 1 << 16;
export const HITS_Y: usize = HITS_X + LIST_BYTES;
export const HITS_Z: usize = HITS_Y + LIST_BYTES;

export const LANES: i32 = 16 / sizeof<real>();

const FULL: i32 = (1 << LANES) - 1;

// Makes room for all columns.
export function reserve(): void {
  memory.grow(<i32>((END + 0xffff) >>> 16) - memory.size());
}

// Where a column begins, in the order above.
export function columnAt(index: i32): usize {
  return FIRST + <usize>index * STRIDE;
}

// @ts-ignore: decorator
@inline export function splat(value: real): v128 {
  return v128.splat<real>(value);
}

// @ts-ignore: decorator
@inline export function add(a: v128, b: v128): v128 {
  return v128.add<real>(a, b);
}

// @ts-ignore: decorator
@inline export function sub(a: v128, b: v128): v128 {
  return v128.sub<real>(a, b);
}

// @ts-ignore: decorator
@inline export function mul(a: v128, b: v128): v128 {
  return v128.mul<real>(a, b);
}

// @ts-ignore: decorator
@inline export function magnitude(value: v128): v128 {
  return v128.and(value, sizeof<real>() == 4 ? i32x4.splat(0x7fffffff) : i64x2.splat(0x7fffffffffffffff));
}

// Whether a comparison holds in all lanes.
// @ts-ignore: decorator
@inline export function isAll(mask: v128): bool {
  return (sizeof<real>() == 4 ? i32x4.bitmask(mask) : i64x2.bitmask(mask)) == FULL;
}

// Largest values by lane, of values that are not negative, as integers of 32 bits: that is an instruction less than a
// comparison, and orders infinity above all numbers and NaN above that. Of 64 bits only the upper half is of use.
// @ts-ignore: decorator
@inline export function largest(most: v128, value: v128): v128 {
  return v128.max<u32>(most, value);
}

// Whether the largest values are below a limit; in f64 one that is less than a millionth below it may count as beyond.
// @ts-ignore: decorator
@inline export function areBelow(most: v128, limit: v128): bool {
  const below = i32x4.bitmask(v128.lt<u32>(most, limit));
  return sizeof<real>() == 4 ? below == 15 : (below & 10) == 10;
}

// The memory of a world's constraints; src/xpbd/constraint-table.ts writes the addresses.
//
// A row is one spring as the solver sees it. Rows stand in this order: first chains, row after row along each; then
// strands of threads that are solved side by side; then groups of four that share no movable body, some filled
// up with rows of nothing; then the few that found no group. Bodies are packed
// as x, y, z, inverse mass.

@unmanaged
export class ConstraintTable {
  // The list of springs: kernels/forces/springs.ts.
  springs: usize;
  breakForce: usize;
  // Ids of the bodies that springs join, ascending.
  nodes: usize;
  // Per body: x, y, z, inverse mass; inverse mass; open groups it is in; number of springs; the first two of them.
  packed: usize;
  inverse: usize;
  masks: usize;
  degree: usize;
  joined: usize;
  // Per spring of the list: whether it has its row.
  state: usize;
  // Per row: id of the spring (0: nothing), its ends, natural length (negative for a cord), gain, softness, tension h^2.
  source: usize;
  a: usize;
  b: usize;
  length: usize;
  gain: usize;
  softness: usize;
  tension: usize;
  // First row of each chain, of each strand, and, after the last, the end of all; next row of each open group.
  chains: usize;
  strands: usize;
  open: usize;
  // The first strand of each layer and, after the last, the end of all; LAYERS + 1 words behind, in which order layers
  // are solved; behind as many again, how hard each pulls.
  layers: usize;
  // What solving keeps of a chain or a strand.
  work: usize;
  // What unchanged.ts knows of the springs.
  sum: usize;
  // Ids of springs pulled beyond their limit.
  broken: usize;
  nodeCount: i32;
  // Bodies that forces can move and no spring joins.
  looseCount: i32;
  chainCount: i32;
  strandCount: i32;
  layerCount: i32;
  // Rows of the longest thread.
  longest: i32;
  // All there is are rods in chains.
  rigid: i32;
  groupsFirst: i32;
  serialFirst: i32;
  rowCount: i32;
  damped: i32;
  breakable: i32;
}

// Groups that are open at once, at most.
export const OPEN_GROUPS: i32 = 64;

// Layers there are; strands beyond them belong to the last.
export const LAYERS: i32 = 15;

// A stiffness from here on is a rod's: src/components/spring.ts stores infinity as 1e30.
export const RIGID: f64 = 1e29;

// @ts-ignore: decorator
@inline export function tableAt(address: usize): ConstraintTable {
  return changetype<ConstraintTable>(address);
}

// @ts-ignore: decorator
@inline export function word(column: usize, row: i32): u32 {
  return load<u32>(column + ((<usize>row) << 2));
}

// @ts-ignore: decorator
@inline export function putWord(column: usize, row: i32, value: u32): void {
  store<u32>(column + ((<usize>row) << 2), value);
}

// Where the x of a body is packed.
// @ts-ignore: decorator
@inline export function packedAt(t: ConstraintTable, body: u32): usize {
  return t.packed + <usize>body * (4 * sizeof<real>());
}

// @ts-ignore: decorator
@inline export function part(packed: usize, index: i32): real {
  return load<real>(packed + <usize>index * sizeof<real>());
}

// @ts-ignore: decorator
@inline export function putPart(packed: usize, index: i32, value: real): void {
  store<real>(packed + <usize>index * sizeof<real>(), value);
}

// @ts-ignore: decorator
@inline export function isCord(length: real): bool {
  return copysign<real>(1, length) < 0;
}

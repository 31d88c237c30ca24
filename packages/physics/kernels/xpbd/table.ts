// The record of a world's constraints; src/xpbd/constraint-table.ts writes the addresses.
//
// A row is one spring as the solver sees it. Rows have this order: the chains, row after row along each; the batches
// of polylines, whose rows are interleaved; the groups of four that share no movable body, padded where a
// group is incomplete; last the few springs that fit into no group. A packed body is x, y, z, inverse mass.

@unmanaged
export class ConstraintTable {
  // The list of springs: kernels/forces/springs.ts.
  springs: usize;
  breakForce: usize;
  // Ids of the nodes, ascending. A node is a body at the end of a spring.
  nodes: usize;
  // Per body: packed x, y, z, inverse mass; inverse mass; bitmask of the open groups that contain it; number of
  // springs; the first two of them.
  packed: usize;
  inverseMass: usize;
  groupMasks: usize;
  degree: usize;
  joined: usize;
  // Per link: 1 if it has a row.
  assigned: usize;
  // Per row: id of the spring (0 is padding), its ends, natural length (negative if tension-only), gain, softness,
  // tension times h^2.
  springIds: usize;
  a: usize;
  b: usize;
  length: usize;
  gain: usize;
  softness: usize;
  tension: usize;
  // First row of each chain and of each batch, each list closed by the end of the last; next free row of each open
  // group.
  chains: usize;
  batches: usize;
  openGroups: usize;
  // The first batch of each pass, closed by the end of the last; from word MAX_PASSES + 1 on, the order in which the
  // passes are solved; from word 2 (MAX_PASSES + 1) on, the mean tension of each.
  passes: usize;
  // Scratch memory of the solver for one chain or one batch.
  scratch: usize;
  // The checksum of the springs: checksum.ts.
  checksum: usize;
  // Ids of the springs that exceed their breaking force.
  broken: usize;
  nodeCount: i32;
  // The number of movable bodies without springs.
  freeBodyCount: i32;
  chainCount: i32;
  batchCount: i32;
  passCount: i32;
  // The length of the longest polyline, in rows.
  longestPolyline: i32;
  // 1 if every spring is a rod in a chain.
  onlyRodChains: i32;
  groupsFirst: i32;
  serialFirst: i32;
  rowCount: i32;
  damped: i32;
  breakable: i32;
}

// The maximum number of groups that are open at once: one bit each in a u64.
export const OPEN_GROUPS: i32 = 64;

// The maximum number of passes; further batches join the last.
export const MAX_PASSES: i32 = 15;

// Minimum stiffness of a rod, N/m: src/components/spring.ts stores infinity as 1e30.
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

// Address of the packed x of a body.
// @ts-ignore: decorator
@inline export function packedAt(t: ConstraintTable, body: u32): usize {
  return t.packed + <usize>body * (4 * sizeof<real>());
}

// @ts-ignore: decorator
@inline export function packedComponent(packed: usize, index: i32): real {
  return load<real>(packed + <usize>index * sizeof<real>());
}

// @ts-ignore: decorator
@inline export function putPackedComponent(packed: usize, index: i32, value: real): void {
  store<real>(packed + <usize>index * sizeof<real>(), value);
}

// @ts-ignore: decorator
@inline export function isTensionOnly(length: real): bool {
  return copysign<real>(1, length) < 0;
}

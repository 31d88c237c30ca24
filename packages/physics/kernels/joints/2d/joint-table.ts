// What joints are kept in: the addresses of the columns of Joint, the list of joints, and what the solver works with. All
// numbers of joints are f64, because long chains with heavy ends need the digits. src/joints/joint-table.ts makes the table.
@unmanaged
export class JointTable {
  // The table of the bodies (solver/2d/rigid-table.ts).
  rigid: usize;
  // Columns of Joint.
  kind: usize;
  a: usize;
  b: usize;
  aGeneration: usize;
  bGeneration: usize;
  ax: usize;
  ay: usize;
  bx: usize;
  by: usize;
  angle: usize;
  axis: usize;
  length: usize;
  pulleyAx: usize;
  pulleyAy: usize;
  pulleyBx: usize;
  pulleyBy: usize;
  ratio: usize;
  isRack: usize;
  hasLimits: usize;
  lower: usize;
  upper: usize;
  hertz: usize;
  dampingRatio: usize;
  maxForce: usize;
  maxCompression: usize;
  motorSpeed: usize;
  maxMotor: usize;
  breakForce: usize;
  breakTorque: usize;
  collide: usize;
  started: usize;
  // Ids of all joints, ascending.
  ids: usize;
  count: i32;
  // By row of a joint: which bodies it kept from colliding when it was listed (list-joints.ts).
  listed: usize;
  // The joints of this step that are solved one by one, class JointWork, and their rows: those of trees in the order of the
  // trees, those that close loops of mechanisms, then the others.
  works: usize;
  rows: usize;
  // What is read of them in every pass, class JointPlace.
  places: usize;
  // Of hinges, class HingeStart.
  starts: usize;
  treeCount: i32;
  workCount: i32;
  // Mechanisms, class Mechanism; the numbers of their trees, and by tree one more than the mechanism to which it belongs; how many joints are in trees or close their loops; the room for
  // matrices, f64, and the number of their elements; and locked directions, class LoopRow.
  mechanisms: usize;
  mechanismCount: i32;
  mechanismTrees: usize;
  mechanismOf: usize;
  closedCount: i32;
  matrices: usize;
  matrixRoom: i32;
  loopRows: usize;
  // How many of them are no plain hinges of trees.
  otherCount: i32;
  // Hinges that close a loop and do nothing else, side by side (loop-block.ts): the blocks, and where each color begins.
  blocks: usize;
  blockCount: i32;
  colors: usize;
  // Indices of the joints that do more than lock directions: with a spring, a motor or limits, and all motor joints,
  // pulleys and gears.
  axes: usize;
  axisCount: i32;
  // Ids of the joints of which a body was removed, and of the broken joints.
  orphans: usize;
  orphanCount: i32;
  broken: usize;
  brokenCount: i32;
  // Impulses by row of the joint, class JointImpulses.
  impulses: usize;
  // Sorted keys of the pairs of bodies that do not collide because of a joint, and room to sort them.
  pairs: usize;
  spare: usize;
  pairCount: i32;
  // The pairs of bodies of all joints of the last step, two rows each, and the ids of these joints.
  links: usize;
  linkIds: usize;
  // The bit of Joint in the membership of an entity.
  jointBit: u32;
  // The joints that act in this step: ids, the rows of both bodies, and again as far as joints move them, what they do
  // (list-active.ts), and which of the two is the parent in a tree; of a hinge in a block, its lane. Then their indices in the
  // order of the trees, parents first, and the first bodies of the trees.
  active: usize;
  ends: usize;
  nodes: usize;
  roles: usize;
  parents: usize;
  activeCount: i32;
  order: usize;
  orderCount: i32;
  roots: usize;
  rootCount: i32;
  // The bodies of the trees, class ArticulatedBody: first the roots, then the child of each joint; their matrices, class
  // ArticulatedMass; and their rows, 0 for one that joints do not move.
  bodies: usize;
  masses: usize;
  bodyRows: usize;
  bodyCount: i32;
  // By row of a body: one more than the number of its tree, 0 for none. The joints of each tree, parents first, and where those
  // of a tree begin among them.
  treeOf: usize;
  treeJoints: usize;
  treeStarts: usize;
  // By tree: how many of its joints let it bend.
  bends: usize;
  // By tree: whether joints close loops in it; and how many of its hinges are torn apart in this step (torn-trees.ts).
  loops: usize;
  tornCount: i32;
  // By tree: in which round of projections it was projected last (project-trees.ts).
  projected: usize;
  projections: i32;
  // What impulses on a body do to its tree (tree-responses.ts): the numbers, real; by row of the body where its own are; by tree how many
  // it has; how many there are together, and how many there is room for by joint.
  responses: usize;
  responseOf: usize;
  responsesIn: usize;
  responseCount: i32;
  responseRoom: i32;
  // By row of a body: class JointedBody, the set it belongs to, its first joint in `next`, which has two entries for each
  // joint, and a mark.
  jointed: usize;
  sets: usize;
  heads: usize;
  next: usize;
  marks: usize;
}

// What a joint has exerted, N s and N m s, on b: by its locked directions, spring, motor and limits. A motor joint has its
// force and torque, and a gear its own, in the places of the locks; a pulley has its tension in `upper`.
@unmanaged
export class JointImpulses {
  lock0: f64;
  lock1: f64;
  lock2: f64;
  // Largest force, N, and torque, N m, in the step.
  force: f64;
  torque: f64;
  spring: f64;
  motor: f64;
  lower: f64;
  upper: f64;
  // A hash of what users set, noted when its bodies fall asleep.
  settings: u32;
  pad: u32;
}

export const REVOLUTE: u32 = 0;
export const DISTANCE: u32 = 1;
export const WELD: u32 = 2;
export const PRISMATIC: u32 = 3;
export const WHEEL: u32 = 4;
export const MOTOR: u32 = 5;
export const PULLEY: u32 = 6;
export const GEAR: u32 = 7;
export const FILTER: u32 = 8;

// A motor joint, pulley or gear is solved by code of its own, and has no spring, motor or limits along a free coordinate.
// @ts-ignore: decorator
@inline export function isSolvedApart(kind: u32): bool {
  return kind == MOTOR || isCoupling(kind);
}

// @ts-ignore: decorator
@inline export function isCoupling(kind: u32): bool {
  return kind == PULLEY || kind == GEAR;
}

export const IMPULSES_SIZE: usize = offsetof<JointImpulses>();

// Where the impulse of the i-th locked direction stands.
// @ts-ignore: decorator
@inline export function lockAddress(impulses: JointImpulses, i: i32): usize {
  return changetype<usize>(impulses) + ((<usize>i) << 3);
}

// @ts-ignore: decorator
@inline export function impulsesOf(t: JointTable, id: i32): JointImpulses {
  return changetype<JointImpulses>(t.impulses + <usize>id * IMPULSES_SIZE);
}

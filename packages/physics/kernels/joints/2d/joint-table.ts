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
  hasLimits: usize;
  lower: usize;
  upper: usize;
  hertz: usize;
  dampingRatio: usize;
  motorSpeed: usize;
  maxMotor: usize;
  breakForce: usize;
  collide: usize;
  started: usize;
  // Ids of all joints, ascending, and the joints of this step in the order of the trees, class JointWork.
  ids: usize;
  count: i32;
  works: usize;
  workCount: i32;
  // Indices of the joints with a spring, a motor or limits.
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
  // The joints that act in this step: ids, the rows of both bodies as far as joints move them, and which of the two is the
  // parent in a tree. Then their indices in the order of the trees, parents first, and the first bodies of the trees.
  active: usize;
  nodes: usize;
  parents: usize;
  activeCount: i32;
  order: usize;
  orderCount: i32;
  roots: usize;
  rootCount: i32;
  // By row of a body: class ArticulatedBody, the set it belongs to, and its first joint in `next`, which has two entries for
  // each joint.
  bodies: usize;
  sets: usize;
  heads: usize;
  next: usize;
}

// What a joint has exerted, N s and N m s, on b: by its locked directions, spring, motor and limits.
@unmanaged
export class JointImpulses {
  lock0: f64;
  lock1: f64;
  lock2: f64;
  spring: f64;
  motor: f64;
  lower: f64;
  upper: f64;
  // Largest force in the step, N.
  force: f64;
}

export const REVOLUTE: u32 = 0;
export const DISTANCE: u32 = 1;
export const WELD: u32 = 2;
export const PRISMATIC: u32 = 3;
export const WHEEL: u32 = 4;

// @ts-ignore: decorator
@inline export function impulsesOf(t: JointTable, id: i32): JointImpulses {
  return changetype<JointImpulses>(t.impulses + ((<usize>id) << 6));
}

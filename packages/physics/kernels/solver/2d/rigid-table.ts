// The record of the rigid-body solver in a world's memory: settings, counters, and the addresses of its lists. Lists "by
// row" have one entry for each entity id. src/solver/rigid-table.ts makes the table.
@unmanaged
export class RigidTable {
  // Length of the step and of a sub-step, s.
  dt: f64;
  h: f64;
  // Recent length of sub-steps, s, and the weight of the impulses of this step in those that contacts keep (scale-impulses.ts).
  recentLength: f64;
  impulseWeight: f64;
  // Contacts as damped springs: frequency, Hz, damping ratio, and the fastest speed at which overlap is pushed out, m/s.
  contactHertz: f64;
  contactDampingRatio: f64;
  contactSpeed: f64;
  // Slower impacts do not bounce, m/s.
  restitutionThreshold: f64;
  // Joints as damped springs: frequency, Hz, and damping ratio.
  jointHertz: f64;
  jointDampingRatio: f64;
  // A body slower than this, m/s, for this long, s, may sleep; a time of 0 keeps all bodies awake.
  sleepSpeed: f64;
  sleepTime: f64;
  // Impacts faster than this are reported, m/s.
  hitSpeed: f64;
  // The table of the joints of this step (joints/2d/joint-table.ts), 0 where there are none.
  joints: usize;
  // Rows in use, from 0, and the addresses of the columns that only this solver reads.
  rows: i32;
  // Rows in use in the last step.
  lastRows: i32;
  generations: usize;
  members: usize;
  forceX: usize;
  forceY: usize;
  torqueZ: usize;
  angle: usize;
  tangentSpeed: usize;
  rollingResistance: usize;
  layers: usize;
  masks: usize;
  sensor: usize;
  bullet: usize;
  oneWay: usize;
  group: usize;
  frictionCombine: usize;
  restitutionCombine: usize;
  // Whether any of these but `bullet` is used in this step, and whether `rollingResistance` is.
  usesColliderFlags: i32;
  usesResistance: i32;
  // Bits of membership: what makes a body dynamic, what lets it turn, and the velocities of what has no mass.
  dynamicBits: u32;
  turningBits: u32;
  velocityBits: u32;
  colliderBit: u32;
  // What makes a body kinematic although it has mass, keeps it awake, and locks motions; then the columns of the locks.
  kinematicBit: u32;
  neverSleepBit: u32;
  lockBit: u32;
  lockX: usize;
  lockY: usize;
  lockAngle: usize;
  // Rows of the bodies that are awake and have locked axes.
  locked: usize;
  lockedCount: i32;
  // Walls (walls.ts): their bits, the record of their columns, and by row the address of the shape.
  segmentWallBit: u32;
  planeWallBit: u32;
  wallColumns: usize;
  wallShapes: usize;
  // Number of sensors in this step, of those of bodies that are not static, and of what may move, but stands.
  sensorCount: i32;
  movingSensorCount: i32;
  mayMoveCount: i32;
  // Parts of compound bodies (parts.ts): the bit of Attachment, its columns, and the ids of all parts, ascending.
  attachmentBit: u32;
  attachmentBody: usize;
  attachmentGeneration: usize;
  attachmentX: usize;
  attachmentY: usize;
  attachmentAngle: usize;
  partIds: usize;
  partCount: i32;
  // By row: the body of a part, 0 of any other; the first part of a body, and the next part of the same body.
  owners: usize;
  firstParts: usize;
  nextParts: usize;
  // By row: class BodyState, class BodyPose, flags (body.ts), fat box, the generation and the filter (collider-flags.ts) these
  // belong to, colors in use.
  states: usize;
  poses: usize;
  flags: usize;
  boxes: usize;
  bodyGenerations: usize;
  filters: usize;
  usedColors: usize;
  // Groups of rows that a step may pass over, class RowGroup (settled-rows.ts).
  rowGroups: usize;
  // By row, of a body that is fast: the fraction of the step at which it was stopped, f32.
  stops: usize;
  // Rows of the bullets among the fast bodies, which are swept after all others.
  bullets: usize;
  // Rows of bodies that the solver moves in this step, ascending.
  awake: usize;
  awakeCount: i32;
  // Rows that sleep.
  asleepCount: i32;
  // What sleep keeps, by row (class Sleeper), and the pairs of bodies that joints connect in this step.
  sleepers: usize;
  links: usize;
  linkCount: i32;
  // The springs that act in this step: id, and the rows of both ends (forces/springs.ts).
  springs: usize;
  springCount: i32;
  // Trees of boxes: the nodes, their number, whether they hold the rows that they should, and a list for making them.
  staticNodes: usize;
  staticNodeCount: i32;
  staticTreeValid: i32;
  // Rows that came and went since the static tree was made.
  staticChanges: i32;
  movingNodes: usize;
  movingNodeCount: i32;
  movingTreeValid: i32;
  treeRows: usize;
  // Half perimeter of all nodes of the moving tree, when it was made.
  builtPerimeter: f64;
  // For queries (collision/queries/2d/query-trees.ts): steps for which they are still prepared, and the longest way of a body in the
  // last step, m. Then what they know the bodies by: the version of what the trees contain, that of the pool of shapes, rows in use,
  // and a checksum of all poses.
  queryPatience: i32;
  rememberedVersion: i32;
  longestPath: f64;
  rememberedLow: u32;
  rememberedHigh: u32;
  rememberedPool: i32;
  checkedRows: i32;
  // A tree that is made for queries where these do not hold (own-tree.ts), and how many looked at all rows since the last step.
  ownNodes: usize;
  ownNodeCount: i32;
  ownTreeHolds: i32;
  looks: i32;
  // Copies of columns after the last step (collision/queries/2d/changed-rows.ts), with their rows; the rows that differ, their number
  // -1 if they are too many.
  rememberedColumns: usize;
  rememberedRows: i32;
  changedRows: usize;
  changedRowCount: i32;
  // How many fat boxes changed in this step, and how many of these are of rows that do not move.
  enlargedCount: i32;
  enlargedStatics: i32;
  // Pairs found in this step, as keys of u64, and as much room to sort them.
  pairs: usize;
  sortedPairs: usize;
  pairCapacity: i32;
  pairCount: i32;
  // Sorted keys of the pairs that joints keep from colliding.
  jointPairs: usize;
  jointPairCount: i32;
  // Contacts: records (class RigidContact), and the used ones sorted by (a, b), with (a, b) as keys beside them (contact-list.ts). Then
  // the free ones.
  contactCapacity: i32;
  contactCount: i32;
  contacts: usize;
  order: usize;
  keys: usize;
  free: usize;
  freeCount: i32;
  droppedCount: u32;
  // The records that were looked at in this step, in the order of (a, b), and whether all have to be, settled or not.
  current: usize;
  currentCount: i32;
  isUnsettled: i32;
  // Blocks of contacts that the solver goes through, and where each color begins and ends among their lanes.
  blocks: usize;
  blockCapacity: i32;
  blockCount: i32;
  touching: usize;
  touchingCount: i32;
  colors: usize;
  colorCounts: usize;
  // Contacts with two points that are hit in this step (solve-contacts.ts).
  hitCount: i32;
  // Contacts with restitution in this step.
  bouncyCount: i32;
  // The contact graph (contact-edges.ts): by row, one more than the first edge; by edge, one more than the next of the same body.
  firstEdges: usize;
  nextEdges: usize;
  // Impacts (impacts/2d): class Impact; by place of a contact, one more than the index of its impact, 0 for none, -1 where the
  // search came to it and nothing bounces, -2 where joints hold its points; indices of those that approach, and of those that are
  // struck in a round.
  impacts: usize;
  impactCapacity: i32;
  impactCount: i32;
  impactOf: usize;
  approaching: usize;
  approachingCount: i32;
  struck: usize;
  struckCount: i32;
  // Passes over what is struck, in all rounds of this step.
  pass: i32;
  // By row: the search or the round that came to a body last, the pass that changed it last, and its fastest approach, m/s.
  visits: usize;
  pushes: usize;
  fastest: usize;
  // Whether impacts are those of landings (landings.ts), and how many contacts were found to land: their places are kept in `struck`.
  isLanding: i32;
  landingCount: i32;
  // Joints that close loops in this step.
  loopCount: i32;
  // Deep contacts with two points of bodies that touch nothing else.
  deepPairCount: i32;
  // Contacts of deep overlap in this step; by row: class Crowd; the rows of the bodies in crowds, ascending (crowds.ts).
  deepCount: i32;
  crowds: usize;
  crowded: usize;
  crowdedCount: i32;
  // Numbers of the records of the contacts that are new in this step, and whether a function of the user decides about them.
  newContacts: usize;
  newPairCount: i32;
  asksUser: i32;
  // Events of the last step: contacts that began, and impacts (class ContactEventList); rows of the shapes that no longer
  // touch; rows of sensors and of what they sense. Then rows of bodies that fell asleep, and that woke.
  begins: usize;
  hits: usize;
  endCount: i32;
  endA: usize;
  endB: usize;
  sensorBeginCount: i32;
  sensorBeginSensors: usize;
  sensorBeginVisitors: usize;
  sensorEndCount: i32;
  sensorEndSensors: usize;
  sensorEndVisitors: usize;
  sleptCount: i32;
  slept: usize;
  wokenCount: i32;
  woken: usize;
  // How many rows have another body or collide otherwise than in the last step, how many bodies are of another kind, and how many have
  // less mass (forget-impulses.ts).
  changedCount: i32;
  changedKindCount: i32;
  lighterCount: i32;
}

// A color for every bit of a word; contacts that found none are in the last one.
export const COLORS: i32 = 32;

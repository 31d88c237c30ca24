// Begins a step: which rows are bodies of the solver, their poses, and their velocities, gathered from the columns.
import { Columns, columns, get } from '../../memory/columns';
import { computeSineCosine, cosine, sine, sineCosine } from '../../math/elementary';
import { CIRCLE, SHAPE_BYTES, Shape } from '../../collision/shapes/2d/shape';
import { shapeOf } from '../../collision/shapes/2d/shape-pool';
import {
  ASLEEP,
  BodyPose,
  COLLIDES,
  DYNAMIC,
  FAST,
  KINEMATIC,
  MOVES,
  ROUND,
  SHIFTED,
  STATIC,
  WAKES,
  flagsOf,
  poseOf,
  putFlags,
  putWord,
  stateOf,
  word,
} from './body';
import { wakeIsland, wasDisturbed } from './islands';
import { RigidTable } from './rigid-table';
import { sleeperOf } from './sleeper';

// What a body keeps from step to step.
const KEPT: u32 = ASLEEP | FAST;

// Where the circle of a body without a shape of the pool is written.
const spare = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));

// Classifies all rows, and lists the bodies that move and are awake. User code may have changed any column between the steps.
export function gatherBodies(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let row = 1; row < t.rows; row++) classify(t, row);
  listAwake(t);
}

// Lists the bodies that move and are awake, with their poses and velocities.
export function listAwake(t: RigidTable): void {
  const c = columns();
  // Row 0 is the world, to which joints may hold a body.
  rest(t, 0);
  poseOf(t, 0).c = 1;
  let awake = 0;
  for (let row = 1; row < t.rows; row++) {
    const flags = flagsOf(t, row);
    if ((flags & (MOVES | STATIC)) == 0 || (flags & ASLEEP) != 0) continue;
    readPose(c, t, row);
    if ((flags & MOVES) == 0) continue;
    readVelocity(c, t, row);
    putWord(t.awake, awake++, row);
  }
  t.awakeCount = awake;
}

function classify(t: RigidTable, row: i32): void {
  const before = flagsOf(t, row);
  const kind = kindOf(columns(), t, row);
  const same = kind != 0 && word(t.bodyGenerations, row) == word(t.generations, row);
  const changed = !same || ((before ^ kind) & KINDS) != 0;
  if ((before & ASLEEP) != 0 && (changed || (before & WAKES) != 0 || wasDisturbed(t, row))) wakeIsland(t, row);
  putFlags(t, row, kind | (changed ? 0 : flagsOf(t, row) & KEPT));
  putWord(t.bodyGenerations, row, word(t.generations, row));
  if (!changed || (before | kind) == 0) return;
  if (((before | kind) & COLLIDES) != 0) t.treesValid = 0;
  forgetBox(t, row);
  sleeperOf(t, row).stillFor = 0;
}

const KINDS: u32 = MOVES | STATIC | COLLIDES;

// @ts-ignore: decorator
@inline function kindOf(c: Columns, t: RigidTable, row: i32): u32 {
  const bits = <u32>word(c.members, row);
  // Position is the first component: its bit is 1.
  if ((bits & 1) == 0) return 0;
  const collides: u32 = (bits & t.colliderBit) != 0 ? COLLIDES : 0;
  if ((bits & t.dynamicBits) == t.dynamicBits && get(c.mass, row) > 0) return DYNAMIC | collides;
  // Without a shape it is still what a joint may hang from.
  return (isDriven(c, row) ? KINEMATIC : STATIC) | collides;
}

// What has no mass moves by its velocity, whatever acts on it.
// @ts-ignore: decorator
@inline function isDriven(c: Columns, row: i32): bool {
  return get(c.velocityX, row) != 0 || get(c.velocityY, row) != 0 || get(c.angularVelocityZ, row) != 0;
}

// A row's fat box is turned inside out, so that no box is inside it and it overlaps nothing.
export function forgetBox(t: RigidTable, row: i32): void {
  const box = t.boxes + <usize>row * (4 * sizeof<real>());
  store<real>(box, <real>Infinity);
  store<real>(box, <real>Infinity, sizeof<real>());
  store<real>(box, -(<real>Infinity), 2 * sizeof<real>());
  store<real>(box, -(<real>Infinity), 3 * sizeof<real>());
}

function rest(t: RigidTable, row: i32): void {
  const state = stateOf(t, row);
  memory.fill(changetype<usize>(state), 0, 8 * sizeof<real>());
  state.dc = 1;
}

export function readPose(c: Columns, t: RigidTable, row: i32): void {
  const pose = poseOf(t, row);
  const flags = flagsOf(t, row);
  turnTo(<f64>get(t.angle, row));
  if ((flags & STATIC) != 0 && hasMoved(c, pose, row)) putFlags(t, row, flags | SHIFTED);
  pose.x = get(c.positionX, row);
  pose.y = get(c.positionY, row);
  pose.c = <real>sineCosine.cosine;
  pose.s = <real>sineCosine.sine;
  pose.inverseMass = 0;
  pose.inverseInertia = 0;
  if ((flags & DYNAMIC) != 0) {
    const inertia = get(c.inertia, row);
    const turns = inertia > 0 && (<u32>word(c.members, row) & t.turningBits) == t.turningBits;
    pose.inverseMass = <real>1 / get(c.mass, row);
    pose.inverseInertia = turns ? <real>1 / inertia : <real>0;
  }
  if ((flags & COLLIDES) == 0) return;
  const shape = shapeOf(row, spare);
  pose.extent = shape.extent;
  pose.minExtent = shape.minExtent;
  if (shape.kind == CIRCLE) putFlags(t, row, flagsOf(t, row) | ROUND);
}

// @ts-ignore: decorator
@inline function hasMoved(c: Columns, pose: BodyPose, row: i32): bool {
  if (get(c.positionX, row) != pose.x || get(c.positionY, row) != pose.y) return true;
  return <real>sineCosine.cosine != pose.c || <real>sineCosine.sine != pose.s;
}

// Sine and cosine of any angle.
// @ts-ignore: decorator
@inline function turnTo(angle: f64): void {
  if (abs<f64>(angle) < 1e6) return computeSineCosine(angle);
  sineCosine.cosine = cosine(angle);
  sineCosine.sine = sine(angle);
}

// Reads the velocities of a body. Kinematic bodies move and turn by them although they have no mass and no inertia.
function readVelocity(c: Columns, t: RigidTable, row: i32): void {
  rest(t, row);
  const state = stateOf(t, row);
  state.vx = get(c.velocityX, row);
  state.vy = get(c.velocityY, row);
  const turns = (flagsOf(t, row) & KINEMATIC) != 0 || poseOf(t, row).inverseInertia > 0;
  state.w = turns ? get(c.angularVelocityZ, row) : <real>0;
}

// Impacts on the walls of a box under forces that depend on position or velocity.
//
// The kernel of the walls finds the time of impact from the mean acceleration of the step, and lets the body go on with the
// same acceleration from there. That is exact for a constant force; but drag and the force of a magnetic field turn with the
// velocity at the impact, and a spring at the wall pulls the body that has turned back otherwise than the one that has not.
// So the step of a body that hit one wall is taken again: with the integrator of the world to the wall, from there with the
// velocity reflected. Each part has the order of the integrator.
//
//   x₁, v₁ = step(x₀, v₀, τ)      τ  time until the impact, corrected by the distance of x₁ from the wall
//   x, v = step(x₁, R v₁, h - τ)  R  reflects the normal velocity, -e; friction is that of the kernel
//
// Bodies that hit two walls in a step, that came to rest or that began the step beyond the wall keep what the kernel gave
// them. Few bodies are at a wall in a step; each takes the scheme twice for its block of rows. Where forces change with time, each
// body is at its own time, so the scheme is taken for one after the other.
import type { RealColumn } from '../components/define.ts';
import { MAX_SPEED } from '../components/velocity.ts';
import { AXES } from '../memory/axes.ts';
import { realBytes } from '../memory/columns.ts';
import { LISTED_VECTOR_BYTES, LISTED_VECTOR_SIZE, WALL_LIST_BYTES, WallListWord } from '../memory/layouts.gen.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { Fusion, PhysicsWorld } from '../world/types.ts';
import type { BoxSystem } from './box-system.ts';
import { type ImpactLoop, impactLoop } from './impact-loop.ts';
import { keptStates, runRow } from './run-row.ts';
import type { Box } from './step-features.ts';

/** The numbers of an impact; after them the velocity without walls and the mean acceleration, per axis. */
const [ROW, AXIS, SIDE, PLANE, AFTER, RESTITUTION, VELOCITY, ACCELERATION, SIZE] = [0, 1, 2, 3, 4, 5, 6, 9, 12];

interface Columns {
  /** The impacts of a list. */
  impacts: Float64Array;
  readonly position: readonly RealColumn[];
  readonly velocity: readonly RealColumn[];
  readonly previous: readonly RealColumn[];
  /** Velocities at the start of the step, where the loop saves them. */
  readonly start: readonly RealColumn[];
  /** All memory as reals, for the velocities in the list. */
  readonly memory: RealColumn;
  readonly radius: RealColumn;
  readonly mass: RealColumn;
  readonly restitution: RealColumn;
  readonly low: readonly number[];
  readonly high: readonly number[];
  readonly wallRestitution: number;
  /** Reals in a vector. */
  readonly lanes: number;
  /** The states of the bodies of a vector. */
  readonly kept: Float64Array;
}

/** The box that the loop of the step tests. */
function boxOf({ internal }: PhysicsWorld): Box {
  const fusion = internal.plan?.fusion as Fusion;
  return (fusion.walls as BoxSystem).box;
}

const columnsOf = cachedWithPlan((world): Columns => {
  const { components, previous, scratch, precision, memory, rows } = world;
  const { Collider, Mass } = components;
  const { low, high, restitution } = boxOf(world);
  const Column = precision === 'f32' ? Float32Array : Float64Array;
  const axes = AXES[world.dimensions];
  return {
    impacts: new Float64Array(64 * SIZE),
    position: axes.map((axis) => components.Position[axis]),
    velocity: axes.map((axis) => components.Velocity[axis]),
    previous: axes.map((axis) => previous.Position[axis]),
    start: axes.map((axis) => new Column(memory.buffer, scratch.at.startVelocity[axis], rows)),
    memory: new Column(memory.buffer),
    radius: Collider.radius,
    mass: Mass.value,
    restitution: Collider.restitution,
    low: axes.map((axis) => low[axis]),
    high: axes.map((axis) => high[axis]),
    wallRestitution: restitution,
    lanes: 16 / realBytes(precision),
    kept: keptStates(world, 16 / realBytes(precision)),
  };
});

/** Finds the bodies of a list that hit one wall, before the walls change them. Returns their number. */
export function findImpacts(
  world: PhysicsWorld,
  list: Uint32Array,
  at: number,
  dt: number,
  savesVelocity: boolean,
): number {
  const loop = impactLoop(world);
  if (loop === undefined) return 0;
  const columns = columnsOf(world);
  const { lanes, radius, mass } = columns;
  const bytes = realBytes(world.precision);
  const end = list[WallListWord.end];
  let count = 0;
  for (let entry = at + WALL_LIST_BYTES; entry < end; entry += LISTED_VECTOR_SIZE) {
    const first = list[(entry - at) >> 2] / bytes;
    const listed = (entry + LISTED_VECTOR_BYTES) / bytes;
    for (let lane = 0; lane < lanes; lane++) {
      const row = first + lane;
      if (!(radius[row] > 0 && mass[row] > 0)) continue;
      const axis = axisHit(columns, row);
      if (axis < 0) continue;
      if (columns.impacts.length < (count + 1) * SIZE) grow(columns);
      const from = savesVelocity ? -1 : listed + lane;
      if (!noteImpact(columns, row, axis, from, dt, count * SIZE)) continue;
      prepareWay(loop, columns, count * SIZE, from, dt);
      count++;
    }
  }
  return count;
}

/** Returns the axis of the only wall beyond which a body is, -1 if there is none or more than one. */
function axisHit({ position, radius, low, high }: Columns, row: number): number {
  const r = radius[row];
  let axis = -1;
  for (let i = 0; i < position.length; i++) {
    const x = position[i][row];
    if (x >= low[i] + r && x <= high[i] - r) continue;
    if (axis >= 0 || !(low[i] + r < high[i] - r)) return -1;
    axis = i;
  }
  return axis;
}

/**
 * Notes an impact. Returns whether it was within the step.
 * @param from index of the velocity at the start of the step in the memory, -1 if that is in a column
 */
function noteImpact(columns: Columns, row: number, axis: number, from: number, dt: number, at: number): boolean {
  const { impacts, position, velocity, radius, restitution, wallRestitution, low, high } = columns;
  const r = radius[row];
  const x = position[axis][row];
  const side = x < low[axis] + r ? 1 : -1;
  const plane = side > 0 ? low[axis] + r : high[axis] - r;
  const speed = -side * velocity[axis][row];
  const acceleration = (side * startVelocity(columns, axis, row, from) + speed) / dt;
  const depth = side * (plane - x);
  const after = (2 * depth) / (Math.sqrt(Math.max(0, speed * speed - 2 * acceleration * depth)) + speed);
  if (!(speed > 0 && after < dt && speed > acceleration * after)) return false;
  impacts[at + ROW] = row;
  impacts[at + AXIS] = axis;
  impacts[at + SIDE] = side;
  impacts[at + PLANE] = plane;
  impacts[at + AFTER] = after;
  impacts[at + RESTITUTION] = Math.max(wallRestitution, restitution[row]);
  return true;
}

function startVelocity({ start, memory, lanes }: Columns, axis: number, row: number, from: number): number {
  return from < 0 ? start[axis][row] : memory[from + axis * lanes];
}

/** Sets the way of a body to the wall. */
function prepareWay(loop: ImpactLoop, columns: Columns, at: number, from: number, dt: number): void {
  const { impacts, velocity, previous } = columns;
  const row = impacts[at + ROW];
  for (let i = 0; i < velocity.length; i++) {
    const v = startVelocity(columns, i, row, from);
    impacts[at + VELOCITY + i] = velocity[i][row];
    impacts[at + ACCELERATION + i] = (velocity[i][row] - v) / dt;
    loop.position[i][row] = previous[i][row];
    loop.velocity[i][row] = v;
  }
  loop.duration[row] = dt - impacts[at + AFTER];
}

function grow(columns: Columns): void {
  const larger = new Float64Array(2 * columns.impacts.length);
  larger.set(columns.impacts);
  columns.impacts = larger;
}

/** Takes the step of the bodies that `findImpacts` found again, after the walls have bounced them. */
export function refineImpacts(world: PhysicsWorld, count: number, dt: number, savesVelocity: boolean): void {
  const loop = impactLoop(world);
  if (loop === undefined || count === 0) return;
  const columns = columnsOf(world);
  loop.block.write(dt, world.time, 0);
  if (loop.isTimed) runBodies(loop, columns, count, world.time, 0);
  else runVectors(loop, columns, count);
  for (let k = 0; k < count; k++) reflect(loop, columns, k * SIZE, dt);
  if (loop.isTimed) runBodies(loop, columns, count, world.time, dt);
  else runVectors(loop, columns, count);
  for (let k = 0; k < count; k++) accept(loop, columns, k * SIZE, savesVelocity);
}

/** Runs the loop once for each vector that has a body of the list, whose rows ascend. */
function runVectors(loop: ImpactLoop, { impacts, lanes }: Columns, count: number): void {
  let done = -1;
  for (let k = 0; k < count; k++) {
    const row = impacts[k * SIZE + ROW];
    const first = row - (row % lanes);
    if (first === done) continue;
    loop.run(first, first + lanes, 0);
    done = first;
  }
}

/**
 * Runs the loop for one body of the list after the other, each at its own time: from `time`, or until `dt` after it where that is
 * not 0.
 */
function runBodies(loop: ImpactLoop, columns: Columns, count: number, time: number, dt: number): void {
  const { impacts, lanes, kept } = columns;
  for (let k = 0; k < count; k++) {
    if (impacts[k * SIZE + AXIS] < 0) continue;
    const row = impacts[k * SIZE + ROW];
    const length = loop.duration[row];
    loop.block.writePart(dt === 0 ? time : time + (dt - length), length);
    runRow(loop, row, lanes, kept);
  }
}

/** Puts a body at the wall, with its velocity reflected, for the rest of the step; its axis becomes -1 if that has no sense. */
function reflect(loop: ImpactLoop, { impacts, velocity }: Columns, at: number, dt: number): void {
  const row = impacts[at + ROW];
  const axis = impacts[at + AXIS];
  const side = impacts[at + SIDE];
  const plane = impacts[at + PLANE];
  const e = impacts[at + RESTITUTION];
  // A rebound too short for the step is rest, and one that has turned back has hit twice: both are left to the kernel.
  const reached = loop.velocity[axis][row];
  const late = (plane - loop.position[axis][row]) / reached;
  const after = impacts[at + AFTER] - late;
  if (!(side * velocity[axis][row] > 0 && side * reached < 0 && e > 0 && after >= 0 && after <= dt)) {
    impacts[at + AXIS] = -1;
    return;
  }
  for (let i = 0; i < loop.position.length; i++) {
    const v = loop.velocity[i][row] + impacts[at + ACCELERATION + i] * late;
    loop.position[i][row] = i === axis ? plane : loop.position[i][row] + v * late;
    const byFriction = velocity[i][row] - impacts[at + VELOCITY + i];
    loop.velocity[i][row] = i === axis ? -e * v : v + byFriction;
  }
  loop.duration[row] = after;
}

/** Takes the state at the end of the step over, if it is on the inner side of the wall. */
function accept(loop: ImpactLoop, columns: Columns, at: number, savesVelocity: boolean): void {
  const { impacts, position, velocity, start } = columns;
  const row = impacts[at + ROW];
  const axis = impacts[at + AXIS];
  if (axis < 0 || !(impacts[at + SIDE] * (loop.position[axis][row] - impacts[at + PLANE]) >= 0)) return;
  for (let i = 0; i < loop.position.length; i++) {
    if (!(Math.abs(loop.velocity[i][row]) <= MAX_SPEED)) return;
  }
  for (let i = 0; i < loop.position.length; i++) {
    const v = loop.velocity[i][row];
    // What follows takes the change since the start of the step for the acceleration.
    if (savesVelocity) start[i][row] += v - velocity[i][row];
    position[i][row] = loop.position[i][row];
    velocity[i][row] = v;
  }
}

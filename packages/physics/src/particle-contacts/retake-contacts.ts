// Impacts of bodies on each other under forces that depend on position or velocity: see impact-list.ts.
//
// Each body goes from impact to impact, in the order of the kernel. Bodies that met a wall in the step, and those that met
// such a body, keep what the kernel gave them.
import { MAX_SPEED } from '../components/velocity.ts';
import { BODY_BYTES, ContactTableWord as Word } from '../memory/layouts.gen.ts';
import { COMPUTED_ANEW, namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { AFTER, FRICTION, goOn, type ImpactWay, listedImpacts, numbersOf, RESTITUTION, wordOf } from './impact-list.ts';

/** Fields of a body in the table, in reals. */
const [X, RADIUS, V, INVERSE_MASS] = [0, 3, 4, 7];

/** What becomes of a body: nothing yet, it is on its way, or it stays where the kernel put it. */
const [UNTOUCHED, ON_WAY, LEFT] = [0, 1, 2];

interface Bodies {
  /** By slot, what becomes of a body, and the time since the start of the step that it has reached. */
  fates: Uint8Array;
  reached: Float64Array;
  /** Position and velocity of the two bodies of an impact, and the normal. */
  readonly stateA: Float64Array;
  readonly stateB: Float64Array;
  readonly normal: Float64Array;
}

const bodiesOf = namedResource(
  COMPUTED_ANEW,
  (): Bodies => ({
    fates: new Uint8Array(64),
    reached: new Float64Array(64),
    stateA: new Float64Array(6),
    stateB: new Float64Array(6),
    normal: new Float64Array(3),
  }),
);

/** Takes the steps of the bodies that collided again. */
export function retakeContacts(world: PhysicsWorld, dt: number): void {
  const way = listedImpacts(world, dt);
  if (way === undefined || !isAnyElastic(way)) return;
  const bodies = bodiesOf(world);
  prepare(way, bodies);
  spread(way, bodies);
  const count = way.words[Word.impactCount];
  for (let k = 0; k < count; k++) {
    const a = wordOf(way, k, 0);
    const b = wordOf(way, k, 1);
    if (bodies.fates[a] === LEFT || bodies.fates[b] === LEFT || meet(world, way, bodies, k, dt)) continue;
    leave(way, bodies, a);
    leave(way, bodies, b);
  }
  spread(way, bodies);
  const { fates } = bodies;
  for (let slot = 0; slot < way.words[Word.bodyCount]; slot++) {
    if (fates[slot] === ON_WAY) finish(world, way, bodies, slot, dt);
  }
}

/** Whether an impact is to keep the energy: where all lose some, what the mean acceleration leaves out is little beside that. */
function isAnyElastic(way: ImpactWay): boolean {
  for (let k = 0; k < way.words[Word.impactCount]; k++) {
    if (way.reals[numbersOf(way, k) + RESTITUTION] >= 1) return true;
  }
  return false;
}

/** Marks the bodies that met a wall. */
function prepare({ words, integers, reals, bytes }: ImpactWay, bodies: Bodies): void {
  const slots = words[Word.bodyCount];
  if (bodies.fates.length < slots) {
    bodies.fates = new Uint8Array(2 * slots);
    bodies.reached = new Float64Array(2 * slots);
  }
  const { fates, reached } = bodies;
  fates.fill(UNTOUCHED, 0, slots);
  reached.fill(0, 0, slots);
  const slotAt = words[Word.wallSlot] / 4;
  const impulseAt = words[Word.wallImpulse] / bytes;
  for (let w = 0; w < words[Word.wallCount]; w++) {
    const slot = integers[slotAt + w] | 0;
    if (slot >= 0 && reals[impulseAt + w] > 0) fates[slot] = LEFT;
  }
}

/** Leaves the bodies that met one that is left. */
function spread(way: ImpactWay, bodies: Bodies): void {
  const { fates } = bodies;
  const count = way.words[Word.impactCount];
  for (let isChanged = true; isChanged; ) {
    isChanged = false;
    for (let k = 0; k < count; k++) {
      const a = wordOf(way, k, 0);
      const b = wordOf(way, k, 1);
      if (fates[a] !== LEFT && fates[b] !== LEFT) continue;
      isChanged = leave(way, bodies, a) || isChanged;
      isChanged = leave(way, bodies, b) || isChanged;
    }
  }
}

/** Leaves a body, unless it cannot move. Returns whether that is new. */
function leave(way: ImpactWay, { fates }: Bodies, slot: number): boolean {
  if (fates[slot] === LEFT || !(way.reals[bodyAt(way, slot) + INVERSE_MASS] > 0)) return false;
  fates[slot] = LEFT;
  return true;
}

/** Index of a body of the table in `reals`. */
function bodyAt({ words, bytes }: ImpactWay, slot: number): number {
  return words[Word.bodies] / bytes + slot * (BODY_BYTES[bytes === 4 ? 'f32' : 'f64'] / bytes);
}

function rowOf({ words, integers }: ImpactWay, slot: number): number {
  return integers[words[Word.bodyRows] / 4 + slot];
}

/** Takes two bodies to their impact, and changes their velocities there. Returns whether that has a sense. */
function meet(world: PhysicsWorld, way: ImpactWay, bodies: Bodies, k: number, dt: number): boolean {
  const { reals } = way;
  const at = numbersOf(way, k);
  const a = wordOf(way, k, 0);
  const b = wordOf(way, k, 1);
  const { reached, stateA, stateB, normal } = bodies;
  const earliest = Math.max(reached[a], reached[b]);
  const reach = reals[bodyAt(way, a) + RADIUS] + reals[bodyAt(way, b) + RADIUS];
  let time = Math.max(earliest, dt - reals[at + AFTER]);
  advance(world, way, bodies, a, time, dt, stateA);
  advance(world, way, bodies, b, time, dt, stateB);
  let distance = separation(bodies);
  let closing = closingSpeed(bodies);
  if (!(closing > 0 && distance > 0)) return false;
  const late = (distance - reach) / closing;
  if (time + late >= earliest && time + late <= dt) {
    time += late;
    advance(world, way, bodies, a, time, dt, stateA);
    advance(world, way, bodies, b, time, dt, stateB);
    distance = separation(bodies);
    closing = closingSpeed(bodies);
    if (!(closing > 0 && distance > 0)) return false;
  }
  const wa = reals[bodyAt(way, a) + INVERSE_MASS];
  const wb = reals[bodyAt(way, b) + INVERSE_MASS];
  const impulse = ((1 + reals[at + RESTITUTION]) * closing) / (wa + wb);
  if (wa > 0) push(way, a, -wa, impulse, normal, at);
  if (wb > 0) push(way, b, wb, impulse, normal, at);
  return true;
}

/** Takes a body on until `time`, and reads its state there. */
function advance(
  world: PhysicsWorld,
  way: ImpactWay,
  { fates, reached }: Bodies,
  slot: number,
  time: number,
  dt: number,
  state: Float64Array,
): void {
  const { loop, reals } = way;
  const axes = loop.position.length;
  const at = bodyAt(way, slot);
  if (!(reals[at + INVERSE_MASS] > 0)) {
    for (let i = 0; i < axes; i++) {
      state[i] = reals[at + X + i] - reals[at + V + i] * (dt - time);
      state[3 + i] = reals[at + V + i];
    }
    return;
  }
  const row = rowOf(way, slot);
  if (fates[slot] === UNTOUCHED) begin(way, row);
  fates[slot] = ON_WAY;
  goOn(world, way, row, reached[slot], time - reached[slot]);
  reached[slot] = time;
  for (let i = 0; i < axes; i++) {
    state[i] = loop.position[i][row];
    state[3 + i] = loop.velocity[i][row];
  }
}

/** Sets a body to the start of the step. */
function begin({ loop, previous, start }: ImpactWay, row: number): void {
  for (let i = 0; i < previous.length; i++) {
    loop.position[i][row] = previous[i][row];
    loop.velocity[i][row] = start[i][row];
  }
}

/** Returns the distance of two bodies, and sets the normal from the first to the second. */
function separation({ stateA: a, stateB: b, normal }: Bodies): number {
  const x = b[0] - a[0];
  const y = b[1] - a[1];
  const z = b[2] - a[2];
  const distance = Math.sqrt(x * x + y * y + z * z);
  normal[0] = x / distance;
  normal[1] = y / distance;
  normal[2] = z / distance;
  return distance;
}

function closingSpeed({ stateA: a, stateB: b, normal }: Bodies): number {
  return (a[3] - b[3]) * normal[0] + (a[4] - b[4]) * normal[1] + (a[5] - b[5]) * normal[2];
}

/** Changes the velocity of a body by an impulse along the normal and by that of friction. */
function push(way: ImpactWay, slot: number, by: number, impulse: number, normal: Float64Array, at: number): void {
  const { loop, reals } = way;
  const row = rowOf(way, slot);
  for (let i = 0; i < loop.velocity.length; i++) {
    loop.velocity[i][row] += by * (impulse * normal[i] + reals[at + FRICTION + i]);
  }
}

/** Takes a body to the end of the step, and its state there over. */
function finish(
  world: PhysicsWorld,
  way: ImpactWay,
  { reached, stateA: state }: Bodies,
  slot: number,
  dt: number,
): void {
  const { loop, reals, position, velocity } = way;
  const row = rowOf(way, slot);
  const axes = position.length;
  goOn(world, way, row, reached[slot], dt - reached[slot]);
  for (let i = 0; i < axes; i++) {
    if (!(Math.abs(loop.velocity[i][row]) <= MAX_SPEED)) return;
    state[i] = loop.position[i][row];
    state[3 + i] = loop.velocity[i][row];
  }
  // Systems after the integrator may have changed the body, which stays.
  begin(way, row);
  goOn(world, way, row, 0, dt);
  const at = bodyAt(way, slot);
  for (let i = 0; i < axes; i++) {
    reals[at + X + i] = state[i] + (position[i][row] - loop.position[i][row]);
    reals[at + V + i] = state[3 + i] + (velocity[i][row] - loop.velocity[i][row]);
  }
}

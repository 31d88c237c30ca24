// Impacts on wall entities and of bodies under forces that depend on position or velocity.
//
// The kernels find the time of impact from the mean acceleration of the step, and let the bodies go on with the same from
// there. That is exact for a constant force only: the force of a magnetic field turns with the velocity, and a trap pulls
// otherwise on the bodies that have parted. So the kernels list their impacts, and the steps of these bodies are taken
// again, as dynamics/refine-impacts.ts does at boxes: with the integrator of the world to the impact, and from there with the
// velocity after it. The energy is then kept as well as the integrator keeps it.

import type { RealColumn } from '../components/define.ts';
import { type ImpactLoop, impactLoop } from '../dynamics/impact-loop.ts';
import { keptStates, runRow } from '../dynamics/run-row.ts';
import { readsMotion } from '../laws/structure.ts';
import { AXES } from '../memory/axes.ts';
import { realBytes } from '../memory/columns.ts';
import { ContactTableWord as Word } from '../memory/layouts.gen.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { contactTable } from './contact-table.ts';

/** An entry (kernels/particle-contacts/impact-list.ts): two words, then these numbers. */
export const [RESTITUTION, AFTER, FRICTION, NORMAL, START, HEIGHT] = [0, 1, 2, 5, 8, 11];
const [NUMBERS, WORDS_BYTES] = [12, 8];

/** What is needed to take the step of a body again. */
export interface ImpactWay {
  readonly loop: ImpactLoop;
  readonly words: Uint32Array;
  /** All memory of the world. */
  readonly reals: RealColumn;
  readonly integers: Uint32Array;
  /** Reals in a vector, and bytes of one. */
  readonly lanes: number;
  readonly bytes: number;
  readonly capacity: number;
  readonly kept: Float64Array;
  readonly position: readonly RealColumn[];
  readonly velocity: readonly RealColumn[];
  readonly previous: readonly RealColumn[];
  /** Velocities at the start of the step. */
  readonly start: readonly RealColumn[];
}

/** Undefined where the kernels need no correction, and where the step is not one loop. */
const impactWay = cachedWithPlan((world): ImpactWay | undefined => {
  const loop = impactLoop(world);
  if (loop === undefined) return undefined;
  const { components, previous, scratch, precision, memory, rows, dimensions } = world;
  const { words } = contactTable(world);
  const axes = AXES[dimensions];
  const bytes = realBytes(precision);
  const Column = precision === 'f32' ? Float32Array : Float64Array;
  return {
    loop,
    words,
    reals: new Column(memory.buffer),
    integers: new Uint32Array(memory.buffer),
    lanes: 16 / bytes,
    bytes,
    capacity: Math.floor((8 * bytes * words[Word.capacity]) / (WORDS_BYTES + NUMBERS * bytes)),
    kept: keptStates(world, 16 / bytes),
    position: axes.map((axis) => components.Position[axis]),
    velocity: axes.map((axis) => components.Velocity[axis]),
    previous: axes.map((axis) => previous.Position[axis]),
    start: axes.map((axis) => new Column(memory.buffer, scratch.at.startVelocity[axis], rows)),
  };
});

/** Whether a force depends on position or velocity, or may. */
const isUneven = cachedWithPlan(({ integrator: { scheme }, forces }): boolean => {
  if (scheme !== undefined && scheme.parameters.length > 0) return true;
  return forces.some(({ law }) => law === undefined || readsMotion(law));
});

/** Lets the kernels list the impacts that follow, where they are to be taken again. */
export function beginImpacts(world: PhysicsWorld): void {
  // Without contacts the kernels list nothing, and there may be no table.
  if (!world.internal.recordsContacts) return;
  const { words } = contactTable(world);
  words[Word.impactCount] = 0;
  words[Word.impactCapacity] = impactWay(world)?.capacity ?? 0;
  words[Word.isUneven] = isUneven(world) ? 1 : 0;
}

/** Returns the way of bodies through the step if impacts were listed, all of them. */
export function listedImpacts(world: PhysicsWorld, dt: number): ImpactWay | undefined {
  const way = world.internal.recordsContacts ? impactWay(world) : undefined;
  if (way === undefined) return undefined;
  const count = way.words[Word.impactCount];
  if (count === 0 || count > way.capacity) return undefined;
  way.loop.block.write(dt, world.time, 0);
  return way;
}

/** The first or second word of entry k. */
export function wordOf({ words, integers, bytes }: ImpactWay, k: number, index: 0 | 1): number {
  return integers[(words[Word.blocks] + k * (WORDS_BYTES + NUMBERS * bytes)) / 4 + index];
}

/** Index of the first number of entry k in `reals`. */
export function numbersOf({ words, bytes }: ImpactWay, k: number): number {
  return (words[Word.blocks] + k * (WORDS_BYTES + NUMBERS * bytes) + WORDS_BYTES) / bytes;
}

/** Takes a body on by `length` seconds, from a time after the start of the step. */
export function goOn(world: PhysicsWorld, way: ImpactWay, row: number, after: number, length: number): void {
  const { loop, lanes, kept } = way;
  if (length === 0) return;
  if (loop.isTimed) loop.block.writePart(world.time + after, length);
  loop.duration[row] = length;
  runRow(loop, row, lanes, kept);
}

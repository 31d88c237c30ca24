// The f64 values that a fused loop reads: length and time of the step, and the parameters of its laws for every stage
// at whose time they are evaluated.
import { allocate } from '../memory/arena.ts';
import { namedResource } from '../memory/resource.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { Parameter, ParameterSource, PhysicsWorld, Plan } from '../world/types.ts';

/** An owner of parameters: a law at its index in the list of forces, or an integrator. */
export interface ParameterOwner {
  readonly parameters: readonly Parameter[];
  readonly sources: readonly ParameterSource[];
  readonly names?: readonly string[];
}

/** Everything of an owner's parameters that the code depends on, which excludes their values. */
export function variantOf({ sources }: ParameterOwner): unknown {
  return sources.map(({ when, zeros }) => [when, zeros]);
}

/** Indices of the header values that precede the parameters. */
const [DT, TIME, TICK, LAST_DT, PART, HEADER] = [0, 1, 2, 3, 4, 5];

const HEADER_NOTES = [
  'length of the step',
  'time',
  'number of the step',
  'length of the last step',
  'length of the part of the step',
];

/** Initial capacity for a world's parameters, in f64; more is allocated when needed. */
const REGION_DOUBLES = 512;

/** The memory that the blocks of the present plan share. */
const regionOf = namedResource('parameter region', (world) => ({
  at: allocateDoubles(world, REGION_DOUBLES),
  doubles: REGION_DOUBLES,
}));

/** Number of f64 in use; a new plan starts at zero. */
const usageOf = cachedWithPlan(() => ({ doubles: 0 }));

function allocateDoubles(world: PhysicsWorld, doubles: number): number {
  return allocate(world.internal.arena, 8 * doubles, 'parameters of laws');
}

function reserveDoubles(world: PhysicsWorld, doubles: number): number {
  const region = regionOf(world);
  const usage = usageOf(world);
  if (usage.doubles + doubles > region.doubles) {
    region.doubles = Math.max(doubles, 2 * region.doubles);
    region.at = allocateDoubles(world, region.doubles);
    usage.doubles = 0;
  }
  const at = region.at + 8 * usage.doubles;
  usage.doubles += doubles;
  (world.internal.plan as Plan).made++;
  return at;
}

interface Writer {
  readonly source: ParameterSource;
  readonly index: number;
  readonly fraction: number;
  /** Whether the value is that of the stage, instead of the step. */
  readonly isOfStage: boolean;
}

/** The addresses of the parameters of one loop. */
export class ParameterBlock {
  readonly at: number;
  readonly #values: Float64Array;
  readonly #starts = new Map<ParameterOwner, readonly number[]>();
  readonly #writers: Writer[] = [];
  readonly #stages: readonly number[];

  /**
   * @param stages fractions of the step at which the laws are evaluated
   */
  constructor(
    readonly world: PhysicsWorld,
    owners: readonly ParameterOwner[],
    stages: readonly number[],
  ) {
    this.#stages = stages;
    let size = HEADER;
    for (const owner of owners) {
      const starts = owner.parameters.map((parameter, p) => {
        const start = size;
        size += parameter.size * (owner.sources[p].when === 'stage' ? stages.length : 1);
        return start;
      });
      this.#starts.set(owner, starts);
    }
    this.at = reserveDoubles(world, size);
    this.#values = new Float64Array(world.memory.buffer, this.at, size);
    for (const owner of owners) this.#addWriters(owner);
  }

  get dt(): number {
    return this.at + 8 * DT;
  }
  get time(): number {
    return this.at + 8 * TIME;
  }
  get tick(): number {
    return this.at + 8 * TICK;
  }
  get lastDt(): number {
    return this.at + 8 * LAST_DT;
  }
  /** Length of the part of the step that is taken: all of it after `write`. */
  get part(): number {
    return this.at + 8 * PART;
  }

  /** Describes the value at an address of the block, for printed loops. */
  noteOf(address: number): string | undefined {
    const index = (address - this.at) / 8;
    if (index < HEADER) return HEADER_NOTES[index];
    for (const [{ parameters, sources, names }, starts] of this.#starts) {
      const p = starts.findLastIndex((start) => start <= index);
      if (p < 0) continue;
      const copies = sources[p].when === 'stage' ? this.#stages.length : 1;
      if (index < starts[p] + parameters[p].size * copies) return names?.[p];
    }
    return undefined;
  }

  /** Address of one number of a parameter, at a stage. */
  addressOf(owner: ParameterOwner, parameter: Parameter, index: number, stage: number): number {
    const p = owner.parameters.indexOf(parameter);
    const start = (this.#starts.get(owner) as readonly number[])[p];
    const copy = owner.sources[p].when === 'stage' ? stage : 0;
    return this.at + 8 * (start + copy * parameter.size + index);
  }

  /** Writes the values that change from step to step; the step begins at `time`. */
  write(dt: number, time: number, lastDt: number): void {
    const values = this.#values;
    values[DT] = dt;
    values[TIME] = time;
    values[TICK] = this.world.tick;
    values[LAST_DT] = lastDt;
    values[PART] = dt;
    const writers = this.#writers;
    for (let w = 0; w < writers.length; w++) {
      const { source, index, fraction } = writers[w];
      source.write(this.world, values, index, time + fraction * dt);
    }
  }

  /** Writes the values that change within the step, for a part of it that begins at `time`. */
  writePart(time: number, length: number): void {
    const values = this.#values;
    values[TIME] = time;
    values[PART] = length;
    const writers = this.#writers;
    for (let w = 0; w < writers.length; w++) {
      const { source, index, fraction, isOfStage } = writers[w];
      if (isOfStage) source.write(this.world, values, index, time + fraction * length);
    }
  }

  #addWriters(owner: ParameterOwner): void {
    const starts = this.#starts.get(owner) as readonly number[];
    owner.sources.forEach((source, p) => {
      if (source.when === 'once') source.write(this.world, this.#values, starts[p], 0);
      else if (source.when === 'step') {
        this.#writers.push({ source, index: starts[p], fraction: 0, isOfStage: false });
      } else {
        this.#stages.forEach((fraction, stage) => {
          const index = starts[p] + stage * owner.parameters[p].size;
          this.#writers.push({ source, index, fraction, isOfStage: true });
        });
      }
    });
  }
}

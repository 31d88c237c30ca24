// The common part of gravity and the Coulomb force between all bodies: participants, summation method, and a report of
// the last evaluation. kernels/n-body computes the forces, in separate memory in the world's arena.
import { bitOf } from '../components/membership.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkChoice, checkKeys, checkNumber, checkWhole } from '../errors/validate.ts';
import { unsigned } from '../memory/arena.ts';
import { forceMemory } from '../memory/force-memory.ts';
import { N_BODY_BYTES, NBodyNumber, NBodyWord as Word } from '../memory/layouts.gen.ts';
import { recordAt } from '../memory/record.ts';
import type { Force, ForceParameter, PhysicsWorld } from '../world/types.ts';
import { nBodyKernels } from './kernels.ts';

/**
 * Dependence of the force on distance: 'inverse-square' 1/r², or 'inverse-distance' 1/r, which in 2D is the field of
 * parallel lines (logarithmic potential, ln of metres).
 */
export type DistanceLaw = 'inverse-square' | 'inverse-distance';

/**
 * 'direct' sums all pairs, 'tree' uses the Barnes-Hut algorithm, 'auto' selects the faster one by the numbers of sources and
 * test particles.
 */
export type SumMethod = 'auto' | 'direct' | 'tree';

/** Options of all mutual forces. */
export interface MutualOptions {
  /** Plummer softening length ε, m: the force is proportional to r/(r² + ε²)^(3/2), or r/(r² + ε²). Default 0. */
  readonly softening?: number;
  /** Default 'inverse-square'. */
  readonly law?: DistanceLaw;
  /**
   * Permitted RMS relative error of the tree's forces; default 0.005. It is measured periodically at a sample of
   * bodies, and the tree adapts. 0 opens every cell: direct summation through the tree. An f32 world resolves about
   * 1e-5.
   */
  readonly relativeError?: number;
  /** Default 'auto'. */
  readonly method?: SumMethod;
}

/** Statistics of the last evaluation. */
export interface MutualForceReport {
  /** Number of participating bodies. */
  readonly bodies: number;
  readonly method: 'direct' | 'tree';
  /** Target-source pairs with a cell as source, and with a body as source. */
  readonly cellPairs: number;
  readonly bodyPairs: number;
  /** Nodes of the tree, and the deepest level split. */
  readonly nodes: number;
  readonly depth: number;
  /** RMS relative error of the last measurement, and the permitted error of a cell relative to the field. */
  readonly error: number;
  readonly tolerance: number;
  /** Number of evaluations. Evaluations for unchanged positions are skipped and not counted. */
  readonly evaluations: number;
}

/** A force between all bodies. */
export interface MutualForce extends Force {
  potential(world: PhysicsWorld): number;
  /** Returns the statistics of the last evaluation in a world. */
  report(world: PhysicsWorld): MutualForceReport;
  /** Returns the RMS relative error of the present forces against direct summation, at up to 1024 bodies. */
  rmsError(world: PhysicsWorld, samples?: number): number;
}

interface MutualSpec {
  readonly name: string;
  readonly equation: string;
  readonly parameters: Readonly<Record<string, ForceParameter>>;
  /** The component whose `value` is the source strength. */
  readonly strength: 'Mass' | 'Charge';
  /** N m²/strength² (N m/strength² for 1/r); positive if equal signs attract. */
  readonly coefficient: number;
  /** Strengths may have both signs. */
  readonly signed: boolean;
  readonly options: MutualOptions;
}

/** Number of bodies above which the tree is faster, by precision and dimensions; measured at an error of 0.5 %. */
const TREE_FROM = { f32: { 2: 1200, 3: 2600 }, f64: { 2: 800, 3: 2200 } } as const;

const SAMPLES = 1024;

/** Validates the options common to all mutual forces. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function checkMutualOptions(name: string, options: MutualOptions, own: readonly string[]): void {
  checkKeys(options, name, [...own, 'softening', 'law', 'relativeError', 'method']);
  checkNumber(options.softening ?? 0, `${name}.softening`, { min: 0, max: 1e12 });
  checkNumber(options.relativeError ?? 0, `${name}.relativeError`, { min: 0, max: 0.5 });
  if (options.law !== undefined) checkChoice(options.law, `${name}.law`, ['inverse-square', 'inverse-distance']);
  checkChoice(options.method ?? 'auto', `${name}.method`, ['auto', 'direct', 'tree']);
}

/** Creates a force from validated options. */
export function createMutualForce(spec: MutualSpec): MutualForce {
  const sum = createSum(spec);
  return {
    name: spec.name,
    equation: spec.equation,
    parameters: spec.parameters,
    reads: ['Position', spec.strength],
    local: false,
    readsOfOthers: [spec.strength],
    evaluationWork: sum.evaluationWork,
    prepare(world) {
      sum.workOf(world);
    },
    releaseMemory: sum.release,
    memory: sum.memory,
    accumulate(world) {
      const work = sum.evaluate(world);
      const { force } = world.scratch.at;
      const fz = world.dimensions === 3 ? force.z : 0;
      const column = world.addresses[spec.strength].value;
      nBodyKernels(world).nBodyScatter(work, column, force.x, force.y, fz, spec.coefficient, sum.power);
    },
    potential(world) {
      const work = sum.evaluate(world);
      const column = world.addresses[spec.strength].value;
      return -spec.coefficient * nBodyKernels(world).nBodyPotential(work, column, world.dimensions, sum.power);
    },
    report: (world) => reportOf(world, sum.workOf(world)),
    rmsError(world, samples = SAMPLES) {
      checkWhole(samples, 'rmsError.samples', 1, SAMPLES);
      return nBodyKernels(world).nBodyError(sum.evaluate(world), sum.power, samples);
    },
  };
}

/** Work for a pair of bodies (1 ns), and for a body in the tree (some 1.5 µs), in evaluations of a simple force. */
const PAIR_WORK = 0.05;
const TREE_WORK = 75;

/**
 * Cost of the direct sum, in half of the pairs of sources, which act on each other. A pair of a source and a test particle takes four
 * times as much against the tree, which test particles do not make deeper: it is faster from a quarter of as many sources on (measured
 * with 5000 and 50 000 test particles).
 */
function directCost(sources: number, tests: number): number {
  return sources * (sources + 4 * tests);
}

/** Allocates the working memory in each world, and updates the results in it. */
function createSum(spec: MutualSpec) {
  const { softening = 0, law = 'inverse-square', relativeError = 0.005, method = 'auto' } = spec.options;
  const power = law === 'inverse-square' ? 2 : 1;
  const required = (bitOf('Position') | bitOf(spec.strength)) >>> 0;
  const treeFrom = (world: PhysicsWorld) => TREE_FROM[world.precision][world.dimensions];
  const {
    of: workOf,
    release,
    key,
  } = forceMemory((world, take) => {
    if (world.dimensions === 3 && power === 1) {
      throw new PhysicsError('E_RANGE', `${spec.name}: the law inverse-distance requires a 2D world.`, {
        field: 'law',
        value: law,
        hint: 'Create the world with `dimensions: 2`, or use inverse-square.',
      });
    }
    const hasTree = method === 'tree' || (method === 'auto' && world.capacity >= treeFrom(world)) ? 1 : 0;
    const kernels = nBodyKernels(world);
    const bytes = unsigned(kernels.nBodyBytes(world.capacity, hasTree));
    const work = take(bytes, spec.name);
    kernels.nBodyBegin(work, world.capacity, hasTree);
    return work;
  });
  const usesTree = (world: PhysicsWorld, bodies: number): boolean => {
    if (method !== 'auto') return method === 'tree';
    const tests = Math.min(bodies, world.internal.counts.TestParticle);
    return directCost(bodies - tests, tests) >= treeFrom(world) * bodies;
  };
  return {
    power,
    workOf,
    release,
    // The tree adapts to the error measured last, and results are reused while nothing moves: both change what follows.
    memory: { key, form: `${method} ${law} ${relativeError}` },
    evaluationWork(world: PhysicsWorld): number {
      const bodies = world.internal.counts[spec.strength];
      if (usesTree(world, bodies)) return TREE_WORK * bodies;
      const sources = bodies - Math.min(bodies, world.internal.counts.TestParticle);
      return PAIR_WORK * sources * bodies;
    },
    evaluate(world: PhysicsWorld): number {
      const work = workOf(world);
      const kernels = nBodyKernels(world);
      const column = world.addresses[spec.strength].value;
      const rows = world.lastId + 1;
      const bodies = kernels.nBodyGather(work, column, required, bitOf('TestParticle'), softening, rows);
      const tree = usesTree(world, bodies) ? 1 : 0;
      kernels.nBodyEvaluate(work, world.dimensions, power, spec.signed ? 1 : 0, tree, relativeError);
      return work;
    },
  };
}

function reportOf(world: PhysicsWorld, work: number): MutualForceReport {
  const { words, numbers } = recordAt(world.memory, work, N_BODY_BYTES);
  const hasNodes = words[Word.treeValid] !== 0;
  return {
    bodies: words[Word.bodies],
    method: words[Word.resultsByTree] === 1 ? 'tree' : 'direct',
    cellPairs: numbers[NBodyNumber.cellPairs],
    bodyPairs: numbers[NBodyNumber.bodyPairs],
    error: numbers[NBodyNumber.error],
    tolerance: numbers[NBodyNumber.tolerance],
    nodes: hasNodes ? words[Word.nodeCount] : 0,
    depth: hasNodes ? words[Word.maxDepth] : 0,
    evaluations: words[Word.evaluations],
  };
}

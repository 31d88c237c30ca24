// Springs as constraints: extended position-based dynamics in small steps, an integrator that solves every Spring itself.
//
//   v += F/m h/2        x += v h        correct x by the springs, v by the correction over h        v += F/m h/2
//
// For a spring of stiffness k and length L between bodies of inverse masses w_a and w_b, C = d - L, the correction is
// the backward Euler step of Hooke's law: the tension that holds at the end of the sub-step,
//
//   dT = (C - T/(k h²)) / (w_a + w_b + 1/(k h²))        x_a += w_a n dT        x_b -= w_b n dT        (T in N s² = kg m)
//
// so no stiffness is too stiff for the step. An infinite one makes a rod, and with `cord` an inextensible string. Damping
// c is implicit, once a sub-step. A string that becomes taut takes the speed along it: it does not bounce.
//
// Where all springs of a world are rods in chains (no body joined to more than two others, no ring), as in pendulums,
// this is RATTLE: the chains are solved to rounding, the velocities along the rods as well, second order, symplectic
// until a rod turns by more than 37 degrees in a sub-step. A chain so taut that waves across it outrun the sub-step (N links
// hanging: N g h² above half a link) is solved implicitly instead, places and tensions together: unstretched and stable, at
// first order. Otherwise bodies at springs get their whole kick before the
// correction, which makes it first order there: it loses the energy of oscillations whose ω h is not small. What is no
// chain is solved by Gauss-Seidel, from part to part of the network. A part is a thread, four or more springs made one
// after the other, each from the body where the last one ended: it is solved as a whole, as taut chains implicitly
// (kernels/xpbd/polyline-batches.ts). Threads that cross take turns, those that pulled hardest in the sub-step before first,
// and further turns, up to twenty, as long as one is off its length by more than one in 250. So the threads of a cloth do
// not stretch, however many nodes it has. Springs that belong to no thread are parts of their own: a
// stiff network of these is left stretched by the load of a few sub-steps. Its error falls with the square of h, and
// sub-steps serve better than iterations at the same cost.
//
// Momentum is conserved to rounding, angular momentum by RATTLE to rounding too, otherwise to the order of the step. Bodies without mass are anchors.
// `springs()` in the list of forces then gives the potential only. Walls and contacts come after the whole step.
//
// Sources: Macklin, Müller, Chentanez: XPBD (MIG 2016); Macklin et al.: Small Steps in Physics Simulation (SCA 2019);
// Andersen: RATTLE (J. Comput. Phys. 52, 1983). Cost: a square root and a division a spring and iteration.

import { drift, kick } from '../dynamics/drift-kick.ts';
import { quarantineBadForces } from '../dynamics/validate-state.ts';
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { ConstraintTableWord as Word } from '../memory/layouts.gen.ts';
import type { EvaluateForces, Integrator, PhysicsWorld, Ranges } from '../world/types.ts';
import { type ConstraintTable, constraintTable, refreshConstraints } from './constraint-table.ts';
import { constraintKernels } from './kernels.ts';

export interface XpbdOptions {
  /** Sub-steps of a step; default 1. Error and damping fall with their number. */
  readonly substeps?: number;
  /**
   * Times the springs are gone through in each; default 10. For cloths 1 with four or five sub-steps is best: threads that
   * are off their lengths after that are gone through again, up to twenty times.
   */
  readonly iterations?: number;
}

/**
 * Solves springs as constraints, of any stiffness up to Infinity.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function xpbd(options: XpbdOptions = {}): Integrator {
  checkKeys(options, 'xpbd', ['substeps', 'iterations']);
  const bounds = { min: 1, max: 10_000, integer: true };
  const substeps = checkNumber(options.substeps ?? 1, 'xpbd.substeps', bounds);
  const iterations = checkNumber(options.iterations ?? 10, 'xpbd.iterations', bounds);
  let times = timesOf(Number.NaN, substeps);
  return {
    name: 'XPBD',
    order: 2,
    symplectic: false,
    evaluations: substeps + 1,
    wholeWorld: true,
    solvesSprings: true,
    prepare(world, dt) {
      if (times.dt !== dt) times = timesOf(dt, substeps);
      if (world.internal.counts.Spring > 0) refreshConstraints(world, times.list[H] as number);
    },
    advance(world, ranges, dt, evaluateForces) {
      if (times.dt !== dt) times = timesOf(dt, substeps);
      const { list } = times;
      const table = world.internal.counts.Spring > 0 ? constraintTable(world) : undefined;
      if (table !== undefined && table.words[Word.rigid] === 0 && table.words[Word.looseCount] === 0) {
        for (let s = 0; s < substeps; s++) moveNodes(world, ranges, table, list, iterations, evaluateForces, s);
        return;
      }
      force(world, ranges, evaluateForces, 0);
      for (let s = 0; s < substeps; s++) subStep(world, ranges, list, iterations, evaluateForces, s);
    },
  };
}

/** The times of a step. In a list that holds something else as well, reading a number makes no garbage. */
function timesOf(dt: number, substeps: number) {
  const h = dt / substeps;
  const list: (number | undefined)[] = [undefined, h, h / 2, -h / 2];
  for (let s = 0; s <= substeps; s++) list.push(s * h);
  return { dt, list };
}

const [H, HALF, BACK, STARTS] = [1, 2, 3, 4];

/** A sub-step where all that forces move are nodes of springs, and not in chains only: the whole kick comes first. */
function moveNodes(
  world: PhysicsWorld,
  ranges: Ranges,
  table: ConstraintTable,
  times: readonly (number | undefined)[],
  iterations: number,
  evaluateForces: EvaluateForces,
  s: number,
): void {
  const h = times[H] as number;
  force(world, ranges, evaluateForces, times[STARTS + s] as number);
  kick(world, ranges, h);
  drift(world, ranges, h);
  correctPositions(world, table, h, iterations);
}

function subStep(
  world: PhysicsWorld,
  ranges: Ranges,
  times: readonly (number | undefined)[],
  iterations: number,
  evaluateForces: EvaluateForces,
  s: number,
): void {
  const h = times[H] as number;
  const half = times[HALF] as number;
  kick(world, ranges, half);
  drift(world, ranges, h);
  const table = world.internal.counts.Spring > 0 ? constraintTable(world) : undefined;
  const rigid = table === undefined || table.words[Word.rigid] === 1;
  if (!rigid) kickNodes(world, table, half, h);
  if (table !== undefined) correctPositions(world, table, h, iterations);
  force(world, ranges, evaluateForces, times[STARTS + s + 1] as number);
  kick(world, ranges, half);
  if (!rigid) kickNodes(world, table, times[BACK] as number, 0);
  else if (table !== undefined) constraintKernels(world).solveChainVelocities(table.at);
}

/**
 * Among springs of finite stiffness a velocity is what the sub-step made of the position, with the whole kick before it:
 * a half of the kick behind it would leave what hangs at rest with a speed.
 */
function kickNodes(world: PhysicsWorld, { at }: ConstraintTable, h: number, way: number): void {
  const { x, y, z } = world.scratch.at.force;
  constraintKernels(world).kickNodes(at, x, y, world.dimensions === 3 ? z : 0, h, way);
}

/** Bad forces are dropped at once, because constraints would carry them on. */
function force(world: PhysicsWorld, ranges: Ranges, evaluateForces: EvaluateForces, offset: number): void {
  evaluateForces(world, ranges, world.time + offset);
  if (world.internal.plan?.forcesLocal !== true) return;
  for (let r = 0; r < ranges.count; r++) quarantineBadForces(world, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
}

function correctPositions(world: PhysicsWorld, table: ConstraintTable, h: number, iterations: number): void {
  const kernels = constraintKernels(world);
  const { at } = table;
  kernels.packBodies(at);
  kernels.solveChains(at, iterations, h);
  kernels.sweepConstraints(at, iterations);
  kernels.unpackBodies(at, h);
  if (table.words[Word.damped] > 0) kernels.dampConstraints(at, h);
  table.substep[0] = h;
}

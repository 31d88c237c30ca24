// Springs as constraints: extended position-based dynamics (XPBD) in small steps. This integrator solves every Spring
// itself.
//
//   v += F/m h/2        x += v h        correct x by the springs, v by the correction over h        v += F/m h/2
//
// For a spring of stiffness k and length L between bodies of inverse masses w_a and w_b, C = d - L, the correction is
// the backward Euler step of Hooke's law, with the tension at the end of the sub-step:
//
//   dT = (C - T/(k h²)) / (w_a + w_b + 1/(k h²))        x_a += w_a n dT        x_b -= w_b n dT        (T in N s² = kg m)
//
// It is stable at any stiffness. An infinite stiffness makes a rod, and with `tensionOnly` an inextensible string.
// Damping c is implicit, once per sub-step. A string that becomes taut stops the motion along it: the impact is
// inelastic.
//
// If all springs of a world are rods in chains (no body joins more than two, no closed ring), as in pendulums, this
// is RATTLE: positions and velocities of the chains are solved to rounding; second order, and symplectic until a rod
// turns by more than 37 degrees in a sub-step. If transverse waves cross a link within the sub-step (N hanging links:
// N g h² above half a link), the chain is solved implicitly for positions and tensions together: unstretched and
// stable, at first order.
//
// In all other worlds, bodies with springs get their whole velocity change before the correction, which makes the
// scheme first order there: implicit Euler divides the energy of an oscillation by 1 + ω² h² in every sub-step, so that
// exp(-ω² h t) of it is left after the time t. Springs outside chains are solved by
// Gauss-Seidel iteration over polylines and single springs. A polyline is a run of four or more springs made in
// sequence, each from the body where the previous one ended. It is solved directly, and implicitly if taut
// (kernels/xpbd/polyline-batches.ts). Crossing polylines are solved in passes, the pass with the highest tension of
// the previous sub-step first, and iterated up to twenty more times while any length is off by more than 0.4 %. So a
// cloth does not stretch, however many nodes it has. Stiff springs outside polylines keep a stretch from the load of
// a few sub-steps. This error falls with the square of h, so sub-steps are more effective than iterations at the same
// cost.
//
// Momentum is conserved to rounding; angular momentum to rounding under RATTLE, otherwise to the order of the step.
// Bodies without mass are anchors. `springs()` in the list of forces then gives only the potential. Walls and
// contacts are solved after the whole step.
//
// Sources: Macklin, Müller, Chentanez: XPBD (MIG 2016); Macklin et al.: Small Steps in Physics Simulation (SCA 2019);
// Andersen: RATTLE (J. Comput. Phys. 52, 1983). Cost: a square root and a division per spring and iteration.

import { drift, kick } from '../dynamics/drift-kick.ts';
import { quarantineBadForces } from '../dynamics/validate-state.ts';
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { ConstraintTableWord as Word } from '../memory/layouts.gen.ts';
import type { EvaluateForces, Integrator, PhysicsWorld, Ranges } from '../world/types.ts';
import { type ConstraintTable, constraintTable, currentConstraints, refreshConstraints } from './constraint-table.ts';
import { constraintKernels } from './kernels.ts';

/** Options of `xpbd`. */
export interface XpbdOptions {
  /** Sub-steps per step; default 1. Error and numerical damping decrease with their number. */
  readonly substeps?: number;
  /**
   * Gauss-Seidel iterations per sub-step; default 10. Cloths do best with 1 and four or five sub-steps: polylines
   * that exceed the length tolerance are iterated further, up to twenty times.
   */
  readonly iterations?: number;
}

/**
 * Solves springs as constraints, of any stiffness up to Infinity. Springs of finite stiffness are damped: about
 * exp(-4π² h/T) of the energy of an oscillation is left after a period T, with h = dt / substeps.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function xpbd(options: XpbdOptions = {}): Integrator {
  checkKeys(options, 'xpbd', ['substeps', 'iterations']);
  const bounds = { min: 1, max: 10_000, integer: true };
  const substeps = checkNumber(options.substeps ?? 1, 'xpbd.substeps', bounds);
  const iterations = checkNumber(options.iterations ?? 10, 'xpbd.iterations', bounds);
  return {
    name: 'XPBD',
    order: 2,
    symplectic: false,
    evaluations: substeps + 1,
    wholeWorld: true,
    solvesSprings: true,
    prepare(world, dt) {
      if (world.internal.counts.Spring > 0) refreshConstraints(world, dt / substeps);
    },
    advance(world, ranges, dt, evaluateForces) {
      const h = dt / substeps;
      const table = world.internal.counts.Spring > 0 ? currentConstraints(world, h) : undefined;
      if (table !== undefined && table.words[Word.onlyRodChains] === 0 && table.words[Word.freeBodyCount] === 0) {
        for (let s = 0; s < substeps; s++) moveNodes(world, ranges, table, h, iterations, evaluateForces, s * h);
        return;
      }
      evaluate(world, ranges, evaluateForces, 0);
      for (let s = 1; s <= substeps; s++) subStep(world, ranges, h, iterations, evaluateForces, s * h);
    },
  };
}

/**
 * A sub-step in which all movable bodies have springs, not all in chains: the whole velocity change precedes the
 * correction. `start` is the time of the sub-step since the start of the step, s.
 */
function moveNodes(
  world: PhysicsWorld,
  ranges: Ranges,
  table: ConstraintTable,
  h: number,
  iterations: number,
  evaluateForces: EvaluateForces,
  start: number,
): void {
  evaluate(world, ranges, evaluateForces, start);
  kick(world, ranges, h);
  drift(world, ranges, h);
  correctPositions(world, table, h, iterations);
}

/** A sub-step in general; the forces at its start were evaluated before. `end` is in s since the start of the step. */
function subStep(
  world: PhysicsWorld,
  ranges: Ranges,
  h: number,
  iterations: number,
  evaluateForces: EvaluateForces,
  end: number,
): void {
  const table = world.internal.counts.Spring > 0 ? constraintTable(world) : undefined;
  const springs = table !== undefined && table.words[Word.onlyRodChains] === 0 ? table : undefined;
  const rods = springs === undefined ? table : undefined;
  kick(world, ranges, h / 2);
  drift(world, ranges, h);
  if (springs !== undefined) kickNodes(world, springs, h / 2, h);
  if (table !== undefined) correctPositions(world, table, h, iterations);
  evaluate(world, ranges, evaluateForces, end);
  kick(world, ranges, h / 2);
  if (springs !== undefined) kickNodes(world, springs, -h / 2, 0);
  if (rods !== undefined) constraintKernels(world).solveChainVelocities(rods.at, h);
}

/**
 * With springs of finite stiffness, the velocity is the change of position over h, with the whole velocity change
 * before it: a half after it would leave a hanging body at rest with a velocity.
 */
function kickNodes(world: PhysicsWorld, { at }: ConstraintTable, h: number, driftTime: number): void {
  const { x, y, z } = world.scratch.at.force;
  constraintKernels(world).kickNodes(at, x, y, world.dimensions === 3 ? z : 0, h, driftTime);
}

/** Evaluates the forces and quarantines non-finite ones at once, before constraints could spread them. */
function evaluate(world: PhysicsWorld, ranges: Ranges, evaluateForces: EvaluateForces, offset: number): void {
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

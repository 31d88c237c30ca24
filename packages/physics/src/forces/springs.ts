// Damped springs: every entity with Spring pulls or pushes the two bodies that it names, along the line between them.
//
//   F on b = -(k (d - L) + c ḋ) n        F on a = -F on b        potential  U = k (d - L)² / 2
//
//   d  distance of the ends, m    n  unit vector from a to b     L  natural length, m
//   k  stiffness, N/m             c  damping, N s/m              ḋ  rate of change of d, m/s
//
// Hooke's law (1678) with viscous damping in line: extensions small enough for the material to stay linear. A
// tension-only spring (Spring.tensionOnly = 1) pulls when longer than L and never pushes. Bodies without mass are
// anchors. Coincident ends are pushed apart along x: finite and reproducible. The two forces of a pair are equal and
// opposite to the last bit.
//
// Integrators are explicit, so a spring too stiff for the step would gain energy without bound. `step` refuses it
// with E_STIFF before anything moves. The limit is that of the single spring, k/μ dt² with the reduced mass μ of its
// ends; the step that the error names suits the whole network. A network needs shorter steps than its springs, and
// while only each of these by itself is slow enough, a warning says so. dt < 2/ω is short enough for all with
//
//   ω² = max over springs of  S_a/m_a + S_b/m_b        S: sum of the stiffnesses at a node
//
// With equal springs and masses that is √n times shorter than for one spring where n of them meet: √2 in a rope, √8
// in a cloth with shear, √6 in the ball of a soft body. Cost: one square root and one division per spring and force
// evaluation, without SIMD, because springs share bodies.

import { assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { inverseMass, longestStep, type NetworkSpring, networkSpring } from '../math/spring-network.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import {
  activeSprings,
  removeDanglingSprings,
  type SpringTable,
  scanSprings,
  springTable,
} from './support/spring-table.ts';

/** The force of all springs: see the component `Spring`. */
export function springs(): Force {
  return {
    name: 'springs',
    equation: 'F = -(k (d - L) + c ḋ) n',
    reads: ['Position', 'Velocity'],
    local: false,
    readsOfOthers: [],
    prepare(world, dt) {
      if (world.integrator.solvesSprings === true) return;
      const table = scanSprings(world);
      assertStable(world, table, dt);
      removeDanglingSprings(world, table);
    },
    accumulate(world) {
      if (world.internal.counts.Spring === 0 || world.integrator.solvesSprings === true) return;
      const { x, y, z } = world.scratch.at.force;
      const { at } = springsOfNow(world);
      if (world.dimensions === 2) world.kernels.springForces2d(at, x, y);
      else world.kernels.springForces3d(at, x, y, z);
    },
    potential(world) {
      if (world.internal.counts.Spring === 0) return 0;
      return world.kernels.springPotential(scanSprings(world).at);
    },
  };
}

/**
 * Between steps, where forces are only read, nothing has looked for springs; and in a step a force that was prepared after this
 * one may have removed bodies.
 */
function springsOfNow(world: PhysicsWorld): SpringTable {
  const table = springTable(world);
  const isListed = world.state !== 'idle' && table.entityList.version === world.versions.membership;
  return isListed ? table : scanSprings(world);
}

const NONE: readonly number[] = Object.freeze([]);

/**
 * Returns the springs that were removed before the last step because one of their bodies is gone. Their entity ids
 * are free.
 * @throws PhysicsError E_DESTROYED
 */
export function removedSprings(world: PhysicsWorld): readonly number[] {
  assertUsable(world);
  const { removed, removedIn } = springTable(world);
  const isInStep = world.state === 'preparing' || world.state === 'stepping';
  return removedIn === (isInStep ? world.tick : world.tick - 1) ? removed : NONE;
}

/** Tests the two maxima first; only if they fail together is every spring tested. */
function assertStable(world: PhysicsWorld, table: SpringTable, dt: number): void {
  const { isStable } = world.integrator;
  if (isStable === undefined) return;
  const { maxima, passed } = table;
  // The last test passed with the same values and integrator: to skip it boxes no number.
  const isUnchanged = passed[0] === maxima[0] && passed[1] === maxima[1] && passed[2] === dt;
  if (isUnchanged && table.passedBy === world.integrator) return;
  if (isStable(maxima[0] * dt * dt, maxima[1] * dt)) {
    passed[0] = maxima[0];
    passed[1] = maxima[1];
    passed[2] = dt;
    table.passedBy = world.integrator;
    return;
  }
  const { Spring, Mass } = world.components;
  const links = activeSprings(world, table);
  // The stiffest counts: an error about the first would be followed by one about the next.
  let [worst, fastest] = [0, 0];
  for (let i = 0; i < links.length; i += 3) {
    const [spring, a, b] = [links[i], links[i + 1], links[i + 2]];
    const inverse = inverseMass(Mass.value[a]) + inverseMass(Mass.value[b]);
    const [stiffness, damping] = [Spring.stiffness[spring] * inverse, Spring.damping[spring] * inverse];
    const rate = stiffness * dt + 2 * damping;
    if (rate <= fastest || isStable(stiffness * dt * dt, damping * dt)) continue;
    [worst, fastest] = [spring, rate];
  }
  if (worst === 0) return;
  throw Spring.stiffness[worst] >= ROD ? rodError(world, worst) : stiffError(world, worst, networkOf(world, table), dt);
}

function networkOf(world: PhysicsWorld, table: SpringTable): NetworkSpring[] {
  const links = activeSprings(world, table);
  return Array.from({ length: links.length / 3 }, (_, i) =>
    networkSpring(world, links[3 * i], links[3 * i + 1], links[3 * i + 2]),
  );
}

/** The stiffness that stands for infinity in the column. */
const ROD = 1e30;

function rodError({ integrator, components }: PhysicsWorld, spring: number): PhysicsError {
  const instead = integrator.solvesWalls === true ? 'joints, such as distance({ … }),' : 'the integrator xpbd()';
  return new PhysicsError(
    'E_STIFF',
    `spring ${spring} is a rod or a string, which no step of ${integrator.name} resolves.`,
    {
      entity: spring,
      field: 'spring.stiffness',
      value: components.Spring.stiffness[spring],
      hint: `Use ${instead} or a finite stiffness.`,
    },
  );
}

function stiffError(
  { integrator, components }: PhysicsWorld,
  spring: number,
  network: readonly NetworkSpring[],
  dt: number,
): PhysicsError {
  const maxStep = longestStep(integrator, network, dt);
  const steps = Math.ceil((dt / maxStep) * integrator.evaluations);
  const instead =
    integrator.solvesWalls === true
      ? `joints with springs, or more sub-steps, softStep({ substeps: ${steps} })`
      : 'the integrator xpbd()';
  return new PhysicsError('E_STIFF', `spring ${spring} is too stiff or too strongly damped for steps of ${dt} s.`, {
    entity: spring,
    field: 'spring.stiffness',
    value: components.Spring.stiffness[spring],
    hint: `Use steps of at most ${maxStep} s, a softer spring, heavier bodies or ${instead}.`,
  });
}

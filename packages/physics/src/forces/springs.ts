// Damped springs: every entity with Spring pulls or pushes the two bodies it names, along the line between them.
//
//   F on b = -(k (d - L) + c ḋ) n        F on a = -F on b        potential  U = k (d - L)² / 2
//
//   d  distance of the ends, m    n  unit vector from a to b     L  natural length, m
//   k  stiffness, N/m             c  damping, N s/m              ḋ  rate of change of d, m/s
//
// Hooke's law (1678) with viscous damping in line: extensions small enough for the material to stay linear. A cord
// (Spring.cord = 1) pulls when longer than L and never pushes. Bodies without mass are anchors. Ends in one place push
// apart along x: finite, the same each time. The two forces of a pair are equal and opposite to the last bit.
//
// Integrators are explicit, so a spring too stiff for the step would gain energy without bound. `step` refuses it with
// E_STIFF before anything moves. The limit is that of the single spring, k/μ dt² with the reduced mass μ of its ends:
// beyond it the net it belongs to is unstable as well; but a net can need steps up to some three times shorter.
// Cost: one square root and one division a spring and force evaluation; springs share bodies, so no lanes.

import { assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { activeSprings, removeLost, type SpringTable, scanSprings, springTable } from './support/spring-table.ts';

/** Springs between bodies: see `Spring`. */
export function springs(): Force {
  return {
    name: 'springs',
    equation: 'F = -(k (d - L) + c ḋ) n',
    reads: ['Position', 'Velocity'],
    local: false,
    prepare(world, dt) {
      if (world.integrator.solvesSprings === true) return;
      const table = scanSprings(world);
      refuseStiff(world, table, dt);
      removeLost(world, table);
    },
    accumulate(world) {
      if (world.internal.counts.Spring === 0 || world.integrator.solvesSprings === true) return;
      const { x, y, z } = world.scratch.at.force;
      const { at } = springTable(world);
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
 * The springs that were removed before the last step because one of their bodies is gone. Their entity ids are free.
 * @throws PhysicsError E_DESTROYED
 */
export function removedSprings(world: PhysicsWorld): readonly number[] {
  assertUsable(world);
  return springTable(world).removed;
}

/** The two maxima decide almost always; only when they fail together is every spring looked at. */
function refuseStiff(world: PhysicsWorld, table: SpringTable, dt: number): void {
  const { isStable } = world.integrator;
  if (isStable === undefined) return;
  const { stiffest, passed } = table;
  // The same springs, step and integrator as the last time: nothing is asked, and no number is boxed.
  const isKnown = passed[0] === stiffest[0] && passed[1] === stiffest[1] && passed[2] === dt;
  if (isKnown && table.passedBy === world.integrator) return;
  if (isStable(stiffest[0] * dt * dt, stiffest[1] * dt)) {
    passed[0] = stiffest[0];
    passed[1] = stiffest[1];
    passed[2] = dt;
    table.passedBy = world.integrator;
    return;
  }
  const { Spring, Mass } = world.components;
  const links = activeSprings(world, table);
  for (let i = 0; i < links.length; i += 3) {
    const [spring, a, b] = [links[i], links[i + 1], links[i + 2]];
    const inverse = inverseMass(Mass.value[a]) + inverseMass(Mass.value[b]);
    const [stiff, damped] = [Spring.stiffness[spring] * inverse, Spring.damping[spring] * inverse];
    if (!isStable(stiff * dt * dt, damped * dt)) throw stiffError(spring, Spring.stiffness[spring], stiff, damped, dt);
  }
}

function inverseMass(mass: number): number {
  return mass > 0 ? 1 / mass : 0;
}

function stiffError(spring: number, stiffness: number, stiff: number, damped: number, dt: number): PhysicsError {
  // The root of ω² dt² + 2 γ dt = 4: stable for every integrator of ours.
  const most = 4 / (damped + Math.sqrt(damped * damped + 4 * stiff));
  return new PhysicsError('E_STIFF', `spring ${spring} is too stiff or too damped for steps of ${dt} s.`, {
    entity: spring,
    field: 'spring.stiffness',
    value: stiffness,
    hint: `Use steps of at most ${most.toPrecision(2)} s, a softer spring, heavier bodies or the integrator xpbd().`,
  });
}

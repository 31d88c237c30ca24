import { integrate } from '../dynamics/integrate.ts';
import { beginStep, validateState } from '../dynamics/validate-state.ts';
import { assertPresetWorld } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { breakJoints } from '../joints/create-joint.ts';
import { JOINT_BYTES_PER_ENTITY } from '../joints/joint-table.ts';
import { jointSpringEnergy } from '../joints/spring-energy.ts';
import type { Precision } from '../kernels/instantiate.ts';
import { refuseUnsupported } from '../solver/refuse-unsupported.ts';
import { rigidBytesPerEntity, rigidTable } from '../solver/rigid-table.ts';
import { softStep } from '../solver/soft-step.ts';
import { dispatchFaultEvents } from '../world/event-handlers.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import { nameSystem } from '../world/name-system.ts';
import type { PhysicsWorld, Preset } from '../world/types.ts';

/**
 * Rigid bodies of two dimensions with shapes: they fall, stack, slide, roll and bounce. Bodies with a Collider and no Mass
 * are static, or kinematic where they have a Velocity. The integrator is `softStep()`, which takes its own sub-steps and
 * evaluates the forces of the world in each; pass `integrator: softStep({ … })` for other settings.
 */
export const rigidBodies: Preset = /* @__PURE__ */ Object.assign(fill, {
  // The default memory is added, because other features may need it.
  bytesPerEntity: (_dimensions: 2 | 3, precision: Precision) =>
    256 + rigidBytesPerEntity(precision) + JOINT_BYTES_PER_ENTITY,
});

function fill(world: PhysicsWorld): void {
  assertPresetWorld(world, 'rigidBodies');
  // Allocates the memory immediately, so that a world too small for contacts fails at its creation.
  refuseUnsupported(world);
  // Velocity Verlet is what a world has that was given no integrator.
  if (world.integrator === velocityVerlet) world.integrator = softStep();
  assertWorld(world);
  rigidTable(world);
  const { phases } = world;
  phases.begin.push(beginStep);
  phases.integrate.push(integrate);
  const potential = jointSpringEnergy;
  phases.finish.push(validateState, nameSystem('break joints', Object.assign(breakJoints, { potential, assertWorld })));
  phases.events.push(dispatchFaultEvents);
}

/** @throws PhysicsError E_RANGE for an integrator that moves bodies through each other, also where it was set later */
function assertWorld({ integrator }: PhysicsWorld): void {
  if (isSoftStep(integrator)) return;
  throw new PhysicsError('E_RANGE', `rigid bodies are not solved by ${integrator.name}.`, {
    field: 'integrator',
    hint: 'Leave `integrator` out, or pass softStep({ substeps: 8 }).',
  });
}

import { assertUsable, whenIdle } from '../../ecs/guards.ts';
import { mustBe, unknownName } from '../../errors/validate.ts';
import { checkForce, releaseForce } from '../../world/execution-plan.ts';
import type { Force, PhysicsWorld } from '../../world/types.ts';

/**
 * Replaces a force, for example to change gravity by a slider at run time: `replaceForce(world, uniformGravity({ y:
 * -slider.value }))`. Forces are immutable, so the values are validated before this call, and an invalid value
 * leaves the world unchanged. During a step it takes effect when the step ends. The memory of the old force goes to the
 * new one, so that a force can be replaced any number of times.
 * @param force the new force
 * @param old the force to replace; by default the first with the same name
 * @throws PhysicsError E_UNKNOWN if there is none, E_TYPE, E_DESTROYED
 */
export function replaceForce(world: PhysicsWorld, force: Force, old?: Force): void {
  assertUsable(world);
  checkForce(force, 'replaceForce: force', world.dimensions);
  indexOfForce(world, force, old);
  whenIdle(world, () => {
    const index = indexOfForce(world, force, old);
    const replaced = world.forces[index];
    world.forces[index] = force;
    releaseForce(world, replaced);
  });
}

function indexOfForce({ forces }: PhysicsWorld, force: Force, old: Force | undefined): number {
  const index = forces.findIndex((each) => (old === undefined ? each.name === force.name : each === old));
  if (index >= 0) return index;
  if (old !== undefined) throw mustBe('in world.forces; the new force comes first', old.name, 'old', 'E_UNKNOWN');
  const names = forces.map(({ name }) => name);
  throw unknownName('this world', 'force', force.name, names);
}

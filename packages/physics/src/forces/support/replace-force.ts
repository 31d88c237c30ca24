import { assertUsable, whenIdle } from '../../ecs/guards.ts';
import { unknownName } from '../../errors/validate.ts';
import { checkForce } from '../../world/execution-plan.ts';
import type { Force, PhysicsWorld } from '../../world/types.ts';

/**
 * Puts a force in the place of another: how a slider changes gravity while the world runs,
 * `replaceForce(world, uniformGravity({ y: -slider.value }))`. Forces themselves never change, so the values are
 * checked before this is called, and a refused value leaves the world with the force it had. In a step it takes effect
 * when the step ends.
 * @param force the new one
 * @param old the one it replaces; left out, the first with the same name
 * @throws PhysicsError E_UNKNOWN when there is none, E_TYPE, E_DESTROYED
 */
export function replaceForce(world: PhysicsWorld, force: Force, old?: Force): void {
  assertUsable(world);
  checkForce(force, 'replaceForce: force', world.dimensions);
  placeOf(world, force, old);
  whenIdle(world, () => {
    world.forces[placeOf(world, force, old)] = force;
  });
}

function placeOf({ forces }: PhysicsWorld, force: Force, old: Force | undefined): number {
  const place = forces.findIndex((each) => (old === undefined ? each.name === force.name : each === old));
  if (place >= 0) return place;
  const names = forces.map(({ name }) => name);
  throw unknownName('this world', 'force', (old ?? force).name, names);
}

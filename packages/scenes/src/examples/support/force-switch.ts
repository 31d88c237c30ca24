/** A force that a key turns on and off. */
import { type Force, keepState, type PhysicsWorld } from '@principia/physics';

export interface ForceSwitch {
  isOn: boolean;
}

/** Lists the force of the world only while the switch is on. */
export function addSwitch(world: PhysicsWorld, force: Force, isOn = false): ForceSwitch {
  const state = { isOn };
  keepState(world, state);
  listWhile(world, force, () => state.isOn);
  return state;
}

/** Lists the force of the world in steps at whose start `isOn` holds. */
export function listWhile(world: PhysicsWorld, force: Force, isOn: () => boolean): void {
  world.phases.input.push(() => {
    const index = world.forces.indexOf(force);
    if (isOn() && index < 0) world.forces.push(force);
    if (!isOn() && index >= 0) world.forces.splice(index, 1);
  });
}

/** A force that a key turns on and off. */
import { type Force, keepState, type PhysicsWorld } from '@principia/physics';

export interface ForceSwitch {
  isOn: boolean;
}

/** Lists the force of the world only while the switch is on. */
export function addSwitch(world: PhysicsWorld, force: Force, isOn = false): ForceSwitch {
  const state = { isOn };
  keepState(world, state);
  world.phases.input.push(() => {
    const index = world.forces.indexOf(force);
    if (state.isOn && index < 0) world.forces.push(force);
    if (!state.isOn && index >= 0) world.forces.splice(index, 1);
  });
  return state;
}

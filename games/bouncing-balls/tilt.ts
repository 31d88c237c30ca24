/** Gravity of a strength that the panel sets and of a direction that a tilted device gives. */
import { keepState, type PhysicsWorld, replaceForce, uniformGravity } from '@principia/physics';

export interface Tilt {
  /** Changes the strength, m/s². */
  setStrength(strength: number): void;
  /** Changes the direction: downwards is (0, −1, 0). In 2D only its part in the plane acts, as on a tilted table. */
  turn(direction: { readonly x: number; readonly y: number; readonly z: number }): void;
}

export function addTilt(world: PhysicsWorld, strength: number): Tilt {
  const state = { strength, x: 0, y: -1, z: 0 };
  keepState(world, state);
  const apply = () => {
    const { strength: g, x, y, z } = state;
    replaceForce(world, uniformGravity({ x: g * x, y: g * y, ...(world.dimensions === 3 ? { z: g * z } : {}) }));
  };
  return {
    setStrength(to) {
      state.strength = to;
      apply();
    },
    turn({ x, y, z }) {
      Object.assign(state, { x, y, z });
      apply();
    },
  };
}

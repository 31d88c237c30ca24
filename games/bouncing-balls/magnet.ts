/** A magnet that the player holds over the room. It pulls every ball as a uniform sphere of great mass would. */
import { keepState, type PhysicsWorld, replaceForce, uniformSphereGravity } from '@principia/physics';

/**
 * The pull is μ/r² outside the radius and falls to zero at the centre, where balls come to hang: 111 m/s² at its
 * strongest, and that of the Earth at 4 m.
 */
const MAGNET = { mu: 160, radius: 1.2 } as const;

export interface Magnet {
  /** Switches it on at a point, m. */
  attract(point: { readonly x: number; readonly y: number; readonly z: number }): void;
  release(): void;
  readonly isOn: boolean;
}

export function addMagnet(world: PhysicsWorld): Magnet {
  const at = ({ x, y, z }: { x: number; y: number; z: number }, mu: number) =>
    uniformSphereGravity({ mu, radius: MAGNET.radius, centre: world.dimensions === 3 ? { x, y, z } : { x, y } });
  world.forces.push(at({ x: 0, y: 0, z: 0 }, 0));
  const state = { isOn: false };
  keepState(world, state);
  return {
    attract(point) {
      state.isOn = true;
      replaceForce(world, at(point, MAGNET.mu));
    },
    release() {
      state.isOn = false;
      replaceForce(world, at({ x: 0, y: 0, z: 0 }, 0));
    },
    get isOn() {
      return state.isOn;
    },
  };
}

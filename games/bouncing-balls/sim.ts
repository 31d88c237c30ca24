/** The simulation: the scene, and the settings that a running world can apply. It needs no display. */
import { contacts, replaceForce, uniformGravity } from '@principia/physics';
import { type BouncingBalls, ballDrag, bouncingBalls } from '@principia/scenes';

/** The settings of the balls. */
export interface BallValues {
  readonly count: number;
  readonly gravity: number;
  readonly restitution: number;
  readonly drag: number;
  readonly friction: number;
  readonly collisions: boolean;
}

export interface BallOptions {
  readonly values: BallValues;
  readonly seed: number;
  readonly dimensions: 2 | 3;
}

export const { parameters } = bouncingBalls;

export function createBalls({ values, seed, dimensions }: BallOptions): BouncingBalls {
  const { count, gravity, restitution, drag, friction } = values;
  const collisions = values.collisions ? 1 : 0;
  return bouncingBalls.create({ seed, dimensions, count, gravity, restitution, drag, friction, collisions });
}

/** Applies a changed setting to the running world; false if the setting requires a new world. */
export function applyValue(sim: BouncingBalls, name: string, values: BallValues): boolean {
  const { world, radius } = sim;
  const { Collider, QuadraticDrag } = world.components;
  const last = world.lastId + 1;
  if (name === 'gravity') replaceForce(world, uniformGravity({ y: -values.gravity }));
  else if (name === 'restitution') Collider.restitution.fill(values.restitution, 1, last);
  else if (name === 'friction') Collider.friction.fill(values.friction, 1, last);
  else if (name === 'drag') QuadraticDrag.coefficient.fill(ballDrag(values.drag, radius), 1, last);
  else if (name === 'collisions') sim.setCollisions(values.collisions);
  else return false;
  return true;
}

/** Contacts between balls in the last step; undefined if collisions are off. */
export function countContacts({ world }: BouncingBalls): number | undefined {
  return world.phases.collide.length === 0 ? undefined : contacts(world).count;
}

/** Returns a function that clamps the target of a dragged ball to the room, in place. */
export function clampToRoom({ room, radius }: BouncingBalls) {
  return (point: { x: number; y: number; z: number }): void => {
    for (const axis of ['x', 'y', 'z'] as const) {
      const low = Math.min(room.min[axis] + radius, 0.5 * (room.min[axis] + room.max[axis]));
      const high = Math.max(room.max[axis] - radius, 0.5 * (room.min[axis] + room.max[axis]));
      point[axis] = Math.min(high, Math.max(low, point[axis]));
    }
  };
}

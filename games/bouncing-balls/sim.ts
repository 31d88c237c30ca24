/** The simulation: the scene, and the settings that a running world can apply. It needs no display. */
import { contacts } from '@principia/physics';
import { type BouncingBalls, ballDrag, bouncingBalls, type InputLog, type LoggedInput } from '@principia/scenes';
import { type BallInput, takeInputs } from './inputs.ts';
import { addMagnet } from './magnet.ts';
import { addSpout } from './spout.ts';
import { addTilt, type Tilt } from './tilt.ts';

/** The settings of the balls. */
export interface BallValues {
  readonly count: number;
  readonly gravity: number;
  readonly restitution: number;
  readonly drag: number;
  readonly friction: number;
  readonly collisions: boolean;
  readonly wrap: boolean;
}

export interface BallOptions {
  readonly values: BallValues;
  readonly seed: number;
  readonly dimensions: 2 | 3;
  /** Inputs of an earlier run to replay. */
  readonly log?: readonly LoggedInput<BallInput>[];
}

export const { parameters } = bouncingBalls;

/** Balls, and what the player does to them. */
export interface BallsRun extends BouncingBalls {
  /** The inputs so far; with the seed they give the same run, unless balls were dragged or settings changed. */
  readonly log: InputLog<BallInput>;
  readonly tilt: Tilt;
  /** Whether the player holds time still. */
  readonly time: { isFrozen: boolean };
  /** Closes the spout and switches off the magnet that a restored moment has on. */
  letGo(): void;
}

export function createBalls({ values, seed, dimensions, log }: BallOptions): BallsRun {
  const { count, gravity, restitution, drag, friction } = values;
  const collisions = values.collisions ? 1 : 0;
  const wrap = values.wrap ? 1 : 0;
  const balls = bouncingBalls.create({
    seed,
    dimensions,
    count,
    gravity,
    restitution,
    drag,
    friction,
    collisions,
    wrap,
  });
  const { world } = balls;
  const tilt = addTilt(world, gravity);
  const parts = { spout: addSpout(balls), magnet: addMagnet(world), tilt };
  const inputs = takeInputs(balls, parts, log);
  const letGo = () => {
    if (parts.spout.isOpen) inputs.add({ kind: 'pour', isOpen: false });
    if (parts.magnet.isOn) inputs.add({ kind: 'magnet off' });
  };
  return { ...balls, log: inputs, tilt, time: { isFrozen: false }, letGo };
}

/** Applies a changed setting to the running world; false if the setting requires a new world. */
export function applyValue(sim: BallsRun, name: string, values: BallValues): boolean {
  const { world, radius } = sim;
  const { Collider, QuadraticDrag } = world.components;
  const last = world.lastId + 1;
  if (name === 'gravity') sim.tilt.setStrength(values.gravity);
  else if (name === 'restitution') Collider.restitution.fill(values.restitution, 1, last);
  else if (name === 'friction') Collider.friction.fill(values.friction, 1, last);
  else if (name === 'drag') QuadraticDrag.coefficient.fill(ballDrag(values.drag, radius), 1, last);
  else if (name === 'collisions') sim.setCollisions(values.collisions);
  else return false;
  return true;
}

/** Contacts between balls in the last step; undefined if collisions are off. */
export function countContacts({ world }: BallsRun): number | undefined {
  return world.phases.collide.length === 0 ? undefined : contacts(world).count;
}

/** Returns a function that clamps the target of a dragged ball to the room, in place. */
export function clampToRoom({ room, radius }: BallsRun) {
  return (point: { x: number; y: number; z: number }): void => {
    for (const axis of ['x', 'y', 'z'] as const) {
      const low = Math.min(room.min[axis] + radius, 0.5 * (room.min[axis] + room.max[axis]));
      const high = Math.max(room.max[axis] - radius, 0.5 * (room.min[axis] + room.max[axis]));
      point[axis] = Math.min(high, Math.max(low, point[axis]));
    }
  };
}

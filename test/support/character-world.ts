// Worlds with a character, and what a player does to it.
import {
  box,
  type CharacterMotion,
  type CharacterOptions,
  capsule,
  moveCharacter,
  type PhysicsWorld,
  spawn,
  step,
} from '@principia/physics';
import { DT, G, rigidWorld } from './rigid-world.ts';

/** Radius of a character, and half of its height, m. */
export const [RADIUS, HALF] = [0.3, 0.7];

/** The distance that it keeps, m. */
export const MARGIN = RADIUS / 30;

/** Height of its centre above the floor that it stands on, m. */
export const STANDS = HALF + MARGIN;

/** An upright, kinematic body. */
export const BODY = { rotation: { angle: Math.PI / 2 }, velocity: {}, kinematic: {} };

/** The shape of a character that is wider by `more`. */
export function capsuleOf(more = 0) {
  return capsule(2 * (HALF - RADIUS), RADIUS + more);
}

/** What a player wants in a step, m/s. */
export interface Controls {
  readonly x?: number;
  /** Speed upwards. */
  readonly jump?: number;
}

/** A walk: what came of its last step, where it ended, and the heights and whether it was grounded after each step. */
export interface Walk {
  readonly motion: CharacterMotion;
  readonly x: number;
  readonly y: number;
  readonly heights: number[];
  readonly grounded: boolean[];
}

/** A world with a floor at y = 0. */
export function worldWithFloor(options: object): PhysicsWorld {
  const world = rigidWorld(options);
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(200, 1), friction: 0.6 } });
  return world;
}

/** Adds a character. */
export function addCharacter(world: PhysicsWorld, x: number, y: number, collider: object = {}): number {
  return spawn(world, { ...BODY, position: { x, y }, collider: { shape: capsuleOf(), density: 100, ...collider } });
}

/** Moves a character for some steps, under gravity. */
export function walk(
  world: PhysicsWorld,
  id: number,
  steps: number,
  controls: (step: number) => Controls = () => ({}),
  options: CharacterOptions = {},
): Walk {
  const { Position } = world.components;
  let velocity = { x: 0, y: 0 };
  let motion: CharacterMotion | undefined;
  const [heights, grounded]: [number[], boolean[]] = [[], []];
  for (let i = 0; i < steps; i++) {
    const { x = 0, jump } = controls(i);
    motion = moveCharacter(world, id, { x, y: jump ?? velocity.y - G * DT }, DT, options);
    velocity = motion.velocity;
    step(world, DT);
    heights.push(Position.y[id]);
    grounded.push(motion.grounded);
  }
  return { motion: motion as CharacterMotion, x: Position.x[id], y: Position.y[id], heights, grounded };
}

/** Controls that only walk. */
export function right(speed: number): () => Controls {
  return () => ({ x: speed });
}

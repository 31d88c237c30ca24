/** The simulation: a build of rigid bodies on the ground, and what the player adds to it. It needs no display. */
import {
  asleepCount,
  bodies,
  box,
  createPhysicsWorld,
  explode,
  type PhysicsWorld,
  replaceForce,
  rgba,
  rigidBodies,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { query } from 'bitecs';
import { build } from './builds.ts';
import { buildScene, type SavedScene } from './saved-scene.ts';

/** The settings of a build. */
export interface StackingValues {
  readonly build: string;
  readonly count: number;
  readonly gravity: number;
  readonly friction: number;
  readonly restitution: number;
}

export interface StackingRun {
  readonly world: PhysicsWorld;
  readonly dt: number;
  readonly ground: number;
  /** The region to be shown, m. */
  readonly bounds: { readonly minX: number; readonly minY: number; readonly maxX: number; readonly maxY: number };
}

/** Bit of the layer of the ground, which pointers do not take; all others are on layer 1. */
const GROUND_LAYER = 2;
/** Bodies that a player may add. */
const SPARE = 2000;

interface StackingOptions {
  readonly values: StackingValues;
  readonly seed: number;
  /** A scene from a link, in place of a build. */
  readonly scene?: SavedScene | undefined;
}

export function createSim({ values, seed, scene }: StackingOptions): StackingRun {
  const { count, gravity, friction, restitution } = values;
  const world = createPhysicsWorld({
    capacity: 3 * count + 200 + SPARE,
    seed,
    precision: 'f32',
    preset: rigidBodies,
    forces: [uniformGravity({ y: -gravity })],
  });
  const material = { friction, restitution };
  if (scene === undefined) build(world, values.build, count, material);
  else buildScene(world, scene, material);
  const { x: width, y: height } = extentOf(world);
  const ground = spawn(world, {
    position: { y: -6 },
    collider: { shape: box(4 * width + 60, 12), friction, restitution, layers: GROUND_LAYER },
    appearance: { color: GROUND_COLOR },
  });
  const reach = Math.max(6, 1.25 * width);
  return {
    world,
    dt: 1 / 60,
    ground,
    bounds: { minX: -reach, minY: -1.5, maxX: reach, maxY: Math.max(5, 1.15 * height) },
  };
}

const GROUND_COLOR = rgba(0.2, 0.24, 0.42);

/** Half the width and the height of all bodies, m. */
function extentOf(world: PhysicsWorld): { x: number; y: number } {
  const { Position } = world.components;
  const { ids, count } = bodies(world);
  let [x, y] = [0, 0];
  for (let i = 0; i < count; i++) {
    x = Math.max(x, Math.abs(Position.x[ids[i]]));
    y = Math.max(y, Position.y[ids[i]]);
  }
  return { x, y };
}

/** Applies a changed setting to the running world; false if the setting requires a new world. */
export function applyValue({ world }: StackingRun, name: string, values: StackingValues): boolean {
  const { Collider } = world.components;
  if (name === 'gravity') replaceForce(world, uniformGravity({ y: -values.gravity }));
  else if (name === 'friction' || name === 'restitution') {
    const { ids, count } = bodies(world);
    for (let i = 0; i < count; i++) Collider[name][ids[i]] = values[name];
  } else return name === 'layer';
  return true;
}

/** Throws a heavy ball at the build from the left. */
export function throwBall({ world, bounds }: StackingRun): void {
  const reach = bounds.maxX;
  const speed = 6 + 1.5 * reach;
  spawnExtra(world, {
    position: { x: bounds.minX, y: 0.35 * bounds.maxY },
    velocity: { x: speed, y: 0.15 * speed },
    rotation: 0,
    collider: { radius: 0.05 * reach + 0.1, density: 400, friction: 0.6 },
    appearance: { color: rgba(1, 0.35, 0.3) },
  });
}

/** Drops a block on the middle. */
export function dropBlock({ world, bounds }: StackingRun): void {
  spawnExtra(world, {
    position: { x: 0, y: bounds.maxY },
    rotation: 0.2,
    collider: { shape: box(1, 1), density: 120, friction: 0.6 },
    appearance: { color: rgba(1, 0.8, 0.35) },
  });
}

/** Blows up what stands in the middle. */
export function blast({ world, bounds }: StackingRun): void {
  explode(world, { centre: { y: -0.3 }, impulse: 60 * bounds.maxX, radius: 0.9 * bounds.maxX });
}

/** Nothing is added once the world is full. */
function spawnExtra(world: PhysicsWorld, body: Parameters<typeof spawn>[1]): void {
  if (bodies(world).count + 2 < world.capacity) spawn(world, body);
}

export function report({ world }: StackingRun): {
  readonly bodies: number;
  readonly asleep: number;
  readonly joints: number;
} {
  const { Joint } = world.components;
  return { bodies: bodies(world).count, asleep: asleepCount(world), joints: query(world, [Joint]).length };
}

// Rigid bodies as Box2D's benchmark arranges them: one large pyramid, many small ones, a net of joints, and a drum in which
// boxes tumble. Worlds of two dimensions; `dimensions: 3` is ignored.
import {
  box,
  createJoint,
  createPhysicsWorld,
  type PhysicsWorld,
  type Precision,
  revolute,
  rigidBodies,
  softStep,
  spawn,
  uniformGravity,
  weld,
} from '@principia/physics';
import { countOf, defineScene, type SceneRun } from './scene.ts';
import { seededUniforms } from './seeded.ts';

const MATERIAL = { density: 1, friction: 0.6 };
/** Edge of a box, m, and the largest distance by which boxes start apart from where they rest. */
const EDGE = 1;
const GAP = 0.01;

/** A parameter of all rigid scenes: other engines are compared while nothing sleeps. */
const sleeping = { about: '1 lets bodies sleep', unit: '', initial: 1, min: 0, max: 1, integer: true };

interface WorldSetup {
  readonly precision: Precision;
  readonly seed: number;
  readonly parameters: { readonly sleeping: number };
}

function rigidWorld({ precision, seed, parameters }: WorldSetup, capacity: number): PhysicsWorld {
  const integrator = parameters.sleeping === 1 ? {} : { integrator: softStep({ sleepTime: 0 }) };
  return createPhysicsWorld({
    preset: rigidBodies,
    ...integrator,
    precision,
    seed,
    capacity,
    forces: [uniformGravity()],
  });
}

const runOf = (world: PhysicsWorld): SceneRun => ({
  world,
  dt: 1 / 60,
  losesEnergy: 'friction and collisions dissipate energy',
});

/** Height of the triangle of at most `count` boxes, at least 1. */
const heightOf = (count: number) => Math.max(1, Math.floor((Math.sqrt(8 * count + 1) - 1) / 2));

function addPyramid(world: PhysicsWorld, height: number, x: number, y: number, shift: Float64Array): void {
  for (let row = 0, i = 0; row < height; row++) {
    for (let column = 0; column < height - row; column++, i++) {
      const position = { x: x + EDGE * (column + 0.5 * row) + shift[i % shift.length], y: y + EDGE * (row + 0.5) };
      spawn(world, { position, collider: { shape: box(EDGE, EDGE), ...MATERIAL } });
    }
  }
}

export const pyramid = defineScene({
  name: 'pyramid',
  description: 'a pyramid of boxes',
  precision: 'f32',
  parameters: { count: countOf('boxes', 5050, 100_000), sleeping },
  build(setup) {
    const { seed, parameters } = setup;
    const height = heightOf(parameters.count);
    const world = rigidWorld(setup, parameters.count + 2);
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(4 * height + 20, 1), friction: 0.6 } });
    addPyramid(world, height, -0.5 * height, 0, seededUniforms(seed, 64)(-GAP, GAP));
    return runOf(world);
  },
});

/** Height of each of the small pyramids. */
const SMALL = 10;
const SMALL_COUNT = (SMALL * (SMALL + 1)) / 2;

export const manyPyramids = defineScene({
  name: 'many-pyramids',
  description: 'pyramids of 55 boxes, each on a ground of its own',
  precision: 'f32',
  parameters: { count: countOf('boxes', 22_000, 200_000), sleeping },
  build(setup) {
    const { seed, parameters } = setup;
    const pyramids = Math.max(1, Math.floor(parameters.count / SMALL_COUNT));
    const columns = Math.ceil(Math.sqrt(pyramids));
    const world = rigidWorld(setup, pyramids * (SMALL_COUNT + 1));
    const shift = seededUniforms(seed, 64)(-GAP, GAP);
    for (let p = 0; p < pyramids; p++) {
      const x = (p % columns) * (SMALL + 4);
      const y = Math.floor(p / columns) * (SMALL + 4);
      spawn(world, {
        position: { x: x + 0.5 * SMALL, y: y - 0.5 },
        collider: { shape: box(SMALL + 3, 1), friction: 0.6 },
      });
      addPyramid(world, SMALL, x, y, shift);
    }
    return runOf(world);
  },
});

export const jointGrid = defineScene({
  name: 'joint-grid',
  description: 'a net of discs and hinges that hangs by seven of them',
  precision: 'f32',
  parameters: { count: countOf('discs', 10_000, 100_000), sleeping },
  build(setup) {
    const { seed, parameters } = setup;
    const edge = Math.max(1, Math.floor(Math.sqrt(parameters.count)));
    const world = rigidWorld(setup, 3 * edge * edge);
    const collider = { radius: 0.4, mask: 0 };
    const ids: number[] = [];
    const spin = seededUniforms(seed, edge * edge)(-0.1, 0.1);
    for (let i = 0; i < edge * edge; i++) {
      const [column, row] = [Math.floor(i / edge), i % edge];
      const position = { x: column, y: -row };
      const held = row === 0 && Math.abs(column - Math.floor(edge / 2)) <= 3 && edge > 1;
      const moving = { angularVelocity: spin[i], collider: { ...collider, density: 1 } };
      const body = spawn(world, { position, rotation: 0, ...(held ? { collider } : moving) });
      if (row > 0) createJoint(world, revolute({ a: ids[i - 1], b: body, anchor: { x: column, y: 0.5 - row } }));
      if (column > 0) createJoint(world, revolute({ a: ids[i - edge], b: body, anchor: { x: column - 0.5, y: -row } }));
      ids.push(body);
    }
    return runOf(world);
  },
});

/** Angular speed of the drum, rad/s, and thickness of its walls, m: those of Box2D's tumbler. */
const DRUM_SPEED = 0.4363323129985824;
const WALL = 0.5;

export const tumbler = defineScene({
  name: 'tumbler',
  description: 'boxes that tumble in a square drum turned by a motor',
  precision: 'f32',
  parameters: { count: countOf('boxes', 2025, 20_000), sleeping },
  build(setup) {
    const { seed, parameters } = setup;
    const { count } = parameters;
    const edge = Math.ceil(Math.sqrt(count));
    const size = 0.25;
    const half = Math.max(2, 0.8 * size * edge);
    const world = rigidWorld(setup, count + 20);
    addDrum(world, half);
    const shift = seededUniforms(seed, 64)(-GAP, GAP);
    for (let i = 0; i < count; i++) {
      const [x, y] = [i % edge, Math.floor(i / edge)].map((place) => (place - 0.5 * (edge - 1)) * size * 1.05);
      const collider = { shape: box(size, size), ...MATERIAL };
      spawn(world, { position: { x: x + 0.1 * shift[i % 64], y }, collider });
    }
    return runOf(world);
  },
});

/** Four walls, welded to a hub that a motor turns. */
function addDrum(world: PhysicsWorld, half: number): void {
  const pivot = spawn(world, { position: {}, rotation: 0, collider: { radius: 0.1, mask: 0 } });
  const heavy = { rotation: 0, angularVelocity: 0, mass: 1000, inertia: 1000 };
  const hub = spawn(world, { position: {}, ...heavy });
  createJoint(world, revolute({ a: pivot, b: hub, anchor: {}, motor: { speed: DRUM_SPEED, max: 1e8 } }));
  const across = box(2 * half + 2 * WALL, WALL);
  const along = box(WALL, 2 * half + 2 * WALL);
  const place = half + 0.5 * WALL;
  for (const [x, y, shape] of [
    [0, place, across],
    [0, -place, across],
    [place, 0, along],
    [-place, 0, along],
  ] as const) {
    const wall = spawn(world, { position: { x, y }, collider: { shape, density: 50, friction: 0.6 } });
    createJoint(world, weld({ a: hub, b: wall, anchor: { x, y } }));
  }
}

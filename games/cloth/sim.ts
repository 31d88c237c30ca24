/** The simulation: a cloth of breakable threads that hangs by its upper edge in a breeze. It needs no display. */
import {
  breakSprings,
  brokenSprings,
  type Cloth,
  createCloth,
  createPhysicsWorld,
  despawn,
  type PhysicsWorld,
  replaceForce,
  springs,
  uniformGravity,
  xpbd,
} from '@principia/physics';
import { query } from 'bitecs';
import { breeze } from './breeze.ts';
import { TearRecord } from './tear-record.ts';

/** The settings of the cloth. */
export interface ClothValues {
  readonly gravity: number;
  readonly wind: number;
  readonly strength: number;
}

export interface ClothRun {
  readonly world: PhysicsWorld;
  readonly dt: number;
  readonly cloth: Cloth;
  /** The last seconds, to watch a tear again. */
  readonly tears: TearRecord;
}

/** Mass of the cloth in kg; drag of a node by its mass, 1/s: a loose thread falls at 6.5 m/s. */
export const CLOTH = { columns: 64, rows: 40, spacing: 0.05, mass: 1.5, drag: 1.5 } as const;

/** Stiffness and damping of a knitted thread, N/m and N s/m: a thread of 5 cm doubles its length under 3 N. */
const THREAD = { structural: 60, damping: 0.01 } as const;

/** Stiffness against shear in 3D, N/m: without it the cloth would be a net and show creases of single threads. */
const SHEAR = 10;

/** Air drag on a node, N s/m. */
const NODE_DRAG = (CLOTH.mass / (CLOTH.columns * CLOTH.rows)) * CLOTH.drag;

interface ClothOptions {
  readonly values: ClothValues;
  readonly seed: number;
  readonly dimensions: 2 | 3;
}

export function createSim({ values, seed, dimensions }: ClothOptions): ClothRun {
  const { columns, rows, spacing, mass } = CLOTH;
  const world = createPhysicsWorld({
    capacity: 5 * columns * rows,
    dimensions,
    seed,
    integrator: xpbd({ substeps: 8, iterations: 1 }),
    forces: [uniformGravity({ y: -values.gravity }), breeze({ speed: values.wind }), springs()],
  });
  // Broken threads are removed at the end of the step.
  world.phases.finish.push(breakSprings);
  const cloth = createCloth(world, {
    columns,
    rows,
    spacing,
    mass,
    ...THREAD,
    shear: dimensions === 3 ? SHEAR : 0,
    corner: { x: (-spacing * (columns - 1)) / 2, y: (spacing * (rows - 1)) / 2 },
    breakForce: values.strength,
    components: { linearDrag: NODE_DRAG, collider: { radius: 0.3 * spacing } },
  });
  return { world, dt: 1 / 60, cloth, tears: new TearRecord(world, cloth) };
}

/** Applies a changed setting to the running world; false if the setting requires a new world. */
export function applyValue({ world }: ClothRun, name: string, values: ClothValues): boolean {
  if (name === 'gravity') replaceForce(world, uniformGravity({ y: -values.gravity }));
  else if (name === 'wind') replaceForce(world, breeze({ speed: values.wind }));
  else if (name === 'strength') world.components.Spring.breakForce.fill(values.strength, 1, world.lastId + 1);
  else return false;
  return true;
}

/** Number of threads that broke since the world was created. */
export function brokenThreads({ world }: ClothRun): number {
  return brokenSprings(world).total;
}

/** Number of threads that are left. */
export function threadCount({ world }: ClothRun): number {
  return query(world, [world.components.Spring]).length;
}

type Point = { readonly x: number; readonly y: number };

/**
 * Cuts every thread that a swipe crosses. @param place position of a node on the screen, in any unit
 * @returns the number of threads cut
 */
export function cutAlong({ world }: ClothRun, place: (node: number) => Point, from: Point, to: Point): number {
  const { Spring } = world.components;
  const crossed = [...query(world, [Spring])].filter((thread) =>
    cross(place(Spring.a[thread]), place(Spring.b[thread]), from, to),
  );
  for (const thread of crossed) despawn(world, thread);
  return crossed.length;
}

/** Whether the segments from `a` to `b` and from `p` to `q` cross. */
function cross(a: Point, b: Point, p: Point, q: Point): boolean {
  return side(a, b, p) * side(a, b, q) < 0 && side(p, q, a) * side(p, q, b) < 0;
}

/** Positive if `c` lies to the left of the line from `a` to `b`. */
function side(a: Point, b: Point, c: Point): number {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

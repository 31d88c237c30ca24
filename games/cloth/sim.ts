/** The simulation: a cloth of breakable threads that hangs by its upper edge in a wind. It needs no display. */
import {
  breakSprings,
  brokenSprings,
  type Cloth,
  createCloth,
  createPhysicsWorld,
  gusts,
  linearDrag,
  type PhysicsWorld,
  replaceForce,
  springs,
  uniformGravity,
  xpbd,
} from '@principia/physics';

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
}

export const CLOTH = { columns: 64, rows: 40, spacing: 0.05, mass: 0.4 } as const;

/** Stiffness and damping of a knitted thread, N/m and N s/m: a thread of 5 cm doubles its length under 3 N. */
const THREAD = { structural: 60, damping: 0.01 } as const;

/** Air drag on a node, N s/m: a loose thread falls at 2.5 m/s. */
const NODE_DRAG = (CLOTH.mass / (CLOTH.columns * CLOTH.rows)) * 4;

export function createSim({ values, seed }: { values: ClothValues; seed: number }): ClothRun {
  const { columns, rows, spacing } = CLOTH;
  const world = createPhysicsWorld({
    capacity: 5 * columns * rows,
    seed,
    integrator: xpbd({ substeps: 8, iterations: 1 }),
    forces: [uniformGravity({ y: -values.gravity }), linearDrag(windGusts(values.wind, seed)), springs()],
  });
  // Broken threads are removed at the end of the step.
  world.phases.finish.push(breakSprings);
  const cloth = createCloth(world, {
    ...CLOTH,
    ...THREAD,
    corner: { x: (-spacing * (columns - 1)) / 2, y: (spacing * (rows - 1)) / 2 },
    breakForce: values.strength,
    components: { linearDrag: NODE_DRAG, collider: { radius: 0.3 * spacing } },
  });
  return { world, dt: 1 / 60, cloth };
}

/** Applies a changed setting to the running world; false if the setting requires a new world. */
export function applyValue({ world }: ClothRun, name: string, values: ClothValues): boolean {
  if (name === 'gravity') replaceForce(world, uniformGravity({ y: -values.gravity }));
  else if (name === 'wind') replaceForce(world, linearDrag(windGusts(values.wind, world.seed)));
  else if (name === 'strength') world.components.Spring.breakForce.fill(values.strength, 1, world.lastId + 1);
  else return false;
  return true;
}

/** Number of threads that broke since the world was created. */
export function brokenThreads({ world }: ClothRun): number {
  return brokenSprings(world).total;
}

function windGusts(speed: number, seed: number) {
  return gusts({ mean: { x: speed }, spread: { x: 0.6 * speed, y: 0.3 * speed }, interval: 0.4, seed });
}

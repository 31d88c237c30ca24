/** The simulation: a cloth of threads that break, hung by its upper edge in a wind. Needs no screen. */
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

/** What the player may change about the cloth. */
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

/** Of a knitted cloth, N/m and N s/m: a thread of 5 cm doubles its length under 3 N. */
const GIVE = { structural: 60, damping: 0.01 } as const;

/** Drag of the air on a node, N s/m: a loose thread falls at 2.5 m/s. */
const NODE_DRAG = (CLOTH.mass / (CLOTH.columns * CLOTH.rows)) * 4;

export function createSim({ values, seed }: { values: ClothValues; seed: number }): ClothRun {
  const { columns, rows, spacing } = CLOTH;
  const world = createPhysicsWorld({
    capacity: 5 * columns * rows,
    seed,
    integrator: xpbd({ substeps: 8, iterations: 1 }),
    forces: [uniformGravity({ y: -values.gravity }), linearDrag(breeze(values.wind, seed)), springs()],
  });
  // Threads that broke are taken out when the step is over.
  world.phases.finish.push(breakSprings);
  const cloth = createCloth(world, {
    ...CLOTH,
    ...GIVE,
    corner: { x: (-spacing * (columns - 1)) / 2, y: (spacing * (rows - 1)) / 2 },
    breakForce: values.strength,
    components: { linearDrag: NODE_DRAG, collider: { radius: 0.3 * spacing } },
  });
  return { world, dt: 1 / 60, cloth };
}

/** Gives the running world a changed value; false where only a new world can have it. */
export function applyValue({ world }: ClothRun, name: string, values: ClothValues): boolean {
  if (name === 'gravity') replaceForce(world, uniformGravity({ y: -values.gravity }));
  else if (name === 'wind') replaceForce(world, linearDrag(breeze(values.wind, world.seed)));
  else if (name === 'strength') world.components.Spring.breakForce.fill(values.strength, 1, world.lastId + 1);
  else return false;
  return true;
}

/** Threads that broke since the world was made. */
export function brokenThreads({ world }: ClothRun): number {
  return brokenSprings(world).total;
}

function breeze(speed: number, seed: number) {
  return gusts({ mean: { x: speed }, spread: { x: 0.6 * speed, y: 0.3 * speed }, interval: 0.4, seed });
}

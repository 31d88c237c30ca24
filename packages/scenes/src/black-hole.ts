// A ship of mass 1 among black holes that are fixed or move on circles. Units are metres; y points up. This is the
// world of the game without its rules.
import {
  attractors,
  createPhysicsWorld,
  createRandom,
  despawn,
  keepState,
  markImmutable,
  type PhysicsWorld,
  type Random,
  spawn,
  thrust,
  velocityVerlet,
} from '@principia/physics';
import { BLACK_HOLE, drawHoles, holeMu, holePosition } from './black-hole-layout.ts';
import type { Hole } from './black-hole-types.ts';
import { countOf, defineScene, type SceneRun } from './scene.ts';
import { teleport } from './teleport.ts';

/** A ship among black holes. */
export interface BlackHole extends SceneRun {
  /** Id of the ship; write its `Thrust` to steer. */
  readonly ship: number;
  /** The present layout. */
  readonly holes: readonly Hole[];
  /** Ids of the holes, in the order of the layout. */
  readonly holeIds: readonly number[];
  /** Whether gravity follows Paczyński and Wiita: μ/(d - r)² instead of μ/d². */
  readonly isSteep: boolean;
  /** Time of the moving holes on their orbits, s. */
  readonly holeTime: number;
  /**
   * Draws another layout, and moves, creates and removes holes accordingly.
   * @param moving number of holes that move
   * @param suits the layout must satisfy this, unless many layouts in a row do not
   */
  redraw(count: number, moving: number, suits?: (holes: readonly Hole[]) => boolean): void;
  /** Resets the random sequence: the next layouts are the first of the seed. */
  rewind(): void;
  /** Teleports the ship, at rest and without interpolation. */
  placeShip(x: number, y: number): void;
}

/** A ship among black holes whose discs are their horizons. */
export const blackHole = defineScene({
  name: 'black-hole',
  description: 'a ship among black holes whose discs are their horizons',
  parameters: {
    count: countOf('black holes', 1, BLACK_HOLE.most),
    moving: { about: 'holes on circles', unit: '', initial: 0, min: 0, max: BLACK_HOLE.most, integer: true },
    steep: { about: '1 for a pull after Paczyński and Wiita', unit: '', initial: 0, min: 0, max: 1, integer: true },
  },
  build({ dimensions, precision, seed, parameters }): BlackHole {
    const { count, moving } = parameters;
    const isSteep = parameters.steep === 1;
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: 2 * BLACK_HOLE.most + 1,
      integrator: velocityVerlet,
      forces: [attractors(isSteep ? { lightSpeed: BLACK_HOLE.lightSpeed } : {}), thrust()],
    });
    const ship = spawn(world, {
      position: BLACK_HOLE.start,
      velocity: {},
      mass: 1,
      collider: { radius: 6 },
      thrust: {},
      appearance: {},
    });
    const dt = 1 / 120;
    const sky = new MovingHoles(world, seed, dt, isSteep);
    world.phases.input.push(() => sky.drive());
    sky.redraw(count, moving);
    const placeShip = (x: number, y: number) => teleport(world, ship, { x, y });
    return {
      world,
      dt,
      ship,
      placeShip,
      isSteep,
      ...(moving > 0 ? { losesEnergy: 'moving holes give energy to the ship and take it' } : {}),
      get holes() {
        return sky.holes;
      },
      get holeIds() {
        return sky.ids;
      },
      get holeTime() {
        return sky.time;
      },
      redraw: (holes, onCircles, suits) => sky.redraw(holes, onCircles, suits),
      rewind: () => sky.rewind(),
    };
  },
});

/** The holes of a world and their motion. */
class MovingHoles {
  holes: readonly Hole[] = [];
  readonly ids: number[] = [];
  readonly #dt: number;
  /** Time on the orbits, s. A typed array, because snapshots copy it without garbage. */
  readonly #time = new Float64Array(1);
  readonly #world: PhysicsWorld;
  readonly #seed: number;
  readonly #isSteep: boolean;
  readonly #random: Random;
  readonly #place = { x: 0, y: 0 };

  constructor(world: PhysicsWorld, seed: number, dt: number, isSteep: boolean) {
    this.#world = world;
    this.#seed = seed;
    this.#random = layoutRandom(seed);
    this.#dt = dt;
    this.#isSteep = isSteep;
    keepState(world, this, this.#time, this.#random.state);
  }

  get time(): number {
    return this.#time[0];
  }

  rewind(): void {
    this.#random.state.set(layoutRandom(this.#seed).state);
  }

  redraw(count: number, moving: number, suits?: (holes: readonly Hole[]) => boolean): void {
    this.holes = markImmutable(drawHoles(this.#random, count, moving, this.#isSteep, suits));
    this.#time[0] = 0;
    while (this.ids.length > count) despawn(this.#world, this.ids.pop() as number);
    for (const [i, hole] of this.holes.entries()) this.#put(i, hole);
  }

  /** Gives every moving hole the velocity that leads to its next position, so that forces see it. */
  drive(): void {
    const { Position, Velocity } = this.#world.components;
    const dt = this.#dt;
    this.#time[0] += dt;
    for (let i = 0; i < this.holes.length; i++) {
      if (this.holes[i].orbit === 0) continue;
      const next = holePosition(this.holes[i], this.#time[0], this.#place);
      Velocity.x[this.ids[i]] = (next.x - Position.x[this.ids[i]]) / dt;
      Velocity.y[this.ids[i]] = (next.y - Position.y[this.ids[i]]) / dt;
    }
  }

  #put(index: number, hole: Hole): void {
    const { x, y } = holePosition(hole, 0, this.#place);
    const mu = holeMu(hole.radius);
    const id = this.ids[index];
    if (id === undefined) {
      const values = { position: { x, y }, velocity: {}, attractor: { mu }, collider: { radius: hole.radius } };
      this.ids.push(spawn(this.#world, { ...values, appearance: {} }));
      return;
    }
    const { Attractor, Collider } = this.#world.components;
    Attractor.mu[id] = mu;
    Collider.radius[id] = hole.radius;
    teleport(this.#world, id, { x, y });
  }
}

/**
 * The first outputs of the generator depend weakly on small seeds; without skipping them, the first hole would be
 * nearly at the same place for every seed.
 */
function layoutRandom(seed: number): Random {
  const random = createRandom(seed, 1);
  for (let i = 0; i < 8; i++) random.word();
  return random;
}

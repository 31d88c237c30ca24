// Shells on their way up: a fixed number of bodies, thrown from mortars on the ground with a fuse that ends at the top.
import { createEmitter, keepState, markImmutable, type PhysicsWorld, rgba, setRate, spawn } from '@principia/physics';
import { type Air, aim } from './aim.ts';
import type { Place } from './place.ts';
import { GLOW } from './stars.ts';

/** A shell of 8 cm that weighs 0.3 kg: ρ C_d A / 2m, 1/m. */
export const SHELL_DRAG = 0.0047;
const SHELL_MASS = 0.3;
const SHELL_SIZE = 0.36;
/** A mortar stands this part of the way out from the middle to below the place it throws to. */
const MORTAR = 0.62;
/** Sparks of a tail a second, and how many there can be of one. */
const TAIL_RATE = 130;
const TAIL_CAPACITY = 80;

/** A shell as ordered. */
export interface ShellOrder {
  /** Where it is to burst, m; `y` above the ground. */
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** Number of its kind and of its colour. */
  readonly kind: number;
  readonly color: number;
  /** 0 to 1: how large. */
  readonly power: number;
}

interface Rocket {
  readonly id: number;
  readonly light: (lit: boolean) => void;
  order: ShellOrder | undefined;
}

export class Rockets {
  readonly #rockets: readonly Rocket[];
  /** World time at which each bursts, s: in cells, which snapshots copy without garbage. */
  readonly #ends: Float64Array;
  readonly #world: PhysicsWorld;
  readonly #air: Air;
  readonly #dt: number;

  constructor(world: PhysicsWorld, count: number, dt: number, air: Air) {
    this.#world = world;
    this.#dt = dt;
    this.#air = air;
    this.#rockets = Array.from({ length: count }, () => createRocket(world));
    this.#ends = new Float64Array(count);
    for (const rocket of this.#rockets) this.#park(rocket);
    keepState(world, this.#rockets, this.#ends);
  }

  get flying(): number {
    let count = 0;
    for (let i = 0; i < this.#rockets.length; i++) if (this.#rockets[i].order !== undefined) count++;
    return count;
  }

  /** Entities an emitter of tails and a rocket take. */
  static readonly entities = TAIL_CAPACITY + 1;

  /** Throws a shell. @returns where its mortar stands; undefined when all shells are in the air */
  launch(order: ShellOrder): Place | undefined {
    const index = this.#rockets.findIndex((each) => each.order === undefined);
    if (index < 0) return undefined;
    const rocket = this.#rockets[index];
    const from = { x: MORTAR * order.x, y: 0, z: MORTAR * order.z };
    const way = { x: order.x - from.x, y: order.y, z: order.z - from.z };
    const { velocity, fuse } = aim(way, this.#air, this.#dt);
    const { Mass, Appearance, Velocity } = this.#world.components;
    rocket.order = markImmutable(order);
    this.#ends[index] = this.#world.time + fuse;
    this.#place(rocket.id, from);
    for (const axis of ['x', 'y', 'z'] as const) Velocity[axis][rocket.id] = velocity[axis];
    Mass.value[rocket.id] = SHELL_MASS;
    Appearance.size[rocket.id] = SHELL_SIZE;
    this.#world.versions.style++;
    rocket.light(true);
    return from;
  }

  /** Calls `burst` for every shell whose fuse has come to its end. */
  burn(burst: (order: ShellOrder, position: Place, velocity: Place) => void): void {
    const { components, time } = this.#world;
    const { Position, Velocity } = components;
    for (let i = 0; i < this.#rockets.length; i++) {
      const rocket = this.#rockets[i];
      const { order, id } = rocket;
      // Half a step early or late: times are sums of steps.
      if (order === undefined || time < this.#ends[i] - 0.5 * this.#dt) continue;
      burst(
        order,
        { x: Position.x[id], y: Position.y[id], z: Position.z[id] },
        { x: Velocity.x[id], y: Velocity.y[id], z: Velocity.z[id] },
      );
      this.#park(rocket);
    }
  }

  /** A body without mass, speed and size: nothing moves or draws it. */
  #park(rocket: Rocket): void {
    const { Mass, Appearance, Velocity } = this.#world.components;
    rocket.order = undefined;
    rocket.light(false);
    Mass.value[rocket.id] = 0;
    Appearance.size[rocket.id] = 0;
    for (const axis of ['x', 'y', 'z'] as const) Velocity[axis][rocket.id] = 0;
    this.#world.versions.style++;
  }

  #place(id: number, place: Place): void {
    const { components, previous, versions } = this.#world;
    for (const axis of ['x', 'y', 'z'] as const) {
      components.Position[axis][id] = place[axis];
      // Pictures between two steps would else show it on the way here.
      previous.Position[axis][id] = place[axis];
    }
    versions.pose++;
  }
}

function createRocket(world: PhysicsWorld): Rocket {
  const id = spawn(world, {
    position: {},
    velocity: {},
    mass: SHELL_MASS,
    quadraticDrag: SHELL_DRAG * SHELL_MASS,
    appearance: { color: rgba(1, 0.85, 0.55, 0.9), shape: GLOW, size: SHELL_SIZE },
  });
  const tail = createEmitter(world, {
    entity: id,
    capacity: TAIL_CAPACITY,
    lifetime: [0.2, 0.6],
    speed: [0, 2.2],
    inheritVelocity: 0.25,
    mass: 0.0002,
    quadraticDrag: 0.0002 * 0.3,
    size: [0.2, 0.16, 0.04],
    shape: GLOW,
    whenFull: 'oldest',
    color: [rgba(1, 0.8, 0.5, 0.5), rgba(1, 0.55, 0.2, 0.35), rgba(0.8, 0.25, 0.05, 0.02)],
  });
  return { id, light: (lit) => setRate(tail, lit ? TAIL_RATE : 0), order: undefined };
}

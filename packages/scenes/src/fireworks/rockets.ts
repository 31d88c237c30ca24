// Ascending shells: a fixed number of bodies, launched from mortars on the ground with a fuse that burns to the apex.
import { createEmitter, keepState, markImmutable, type PhysicsWorld, rgba, setRate, spawn } from '@principia/physics';
import { type Air, aim } from './aim.ts';
import type { Point3 } from './place.ts';
import { GLOW } from './stars.ts';

/** Drag of a shell of 8 cm and 0.3 kg: ρ C_d A / 2m, 1/m. */
export const SHELL_DRAG = 0.0047;
const SHELL_MASS = 0.3;
const SHELL_SIZE = 0.36;
/** Position of a mortar as a fraction of the horizontal distance from the centre to the target. */
const MORTAR = 0.62;
/** Sparks of a tail per second, and the capacity of a tail. */
const TAIL_RATE = 130;
const TAIL_CAPACITY = 80;

/** The parameters of a shell. */
export interface ShellOrder {
  /** Target of the burst, m; `y` above the ground. */
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** Index of its kind and of its colour. */
  readonly kind: number;
  readonly color: number;
  /** Size of the burst, 0 to 1. */
  readonly power: number;
  /**
   * A text that the stars form, instead of the form of the kind: for each star x and y within the unit circle, and the index
   * of its colour, −1 for that of the shell; at most `MAX_TEXT_STARS`. Default none.
   */
  readonly points?: readonly number[];
}

interface Rocket {
  readonly id: number;
  readonly light: (lit: boolean) => void;
  order: ShellOrder | undefined;
}

export class Rockets {
  readonly #rockets: readonly Rocket[];
  /** World time of each burst, s. A typed array, because snapshots copy it without garbage. */
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

  /** Number of entities of a tail's emitter and a rocket. */
  static readonly entities = TAIL_CAPACITY + 1;

  /** Launches a shell. @returns position of its mortar; undefined if all shells are in the air */
  launch(order: ShellOrder): Point3 | undefined {
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

  /** Calls `burst` for every shell whose fuse has burnt down. */
  burn(burst: (order: ShellOrder, position: Point3, velocity: Point3) => void): void {
    const { components, time } = this.#world;
    const { Position, Velocity } = components;
    for (let i = 0; i < this.#rockets.length; i++) {
      const rocket = this.#rockets[i];
      const { order, id } = rocket;
      // Half a step of tolerance absorbs the rounding of summed steps.
      if (order === undefined || time < this.#ends[i] - 0.5 * this.#dt) continue;
      burst(
        order,
        { x: Position.x[id], y: Position.y[id], z: Position.z[id] },
        { x: Velocity.x[id], y: Velocity.y[id], z: Velocity.z[id] },
      );
      this.#park(rocket);
    }
  }

  /** Without mass, speed and size, a parked body neither moves nor is drawn. */
  #park(rocket: Rocket): void {
    const { Mass, Appearance, Velocity } = this.#world.components;
    rocket.order = undefined;
    rocket.light(false);
    Mass.value[rocket.id] = 0;
    Appearance.size[rocket.id] = 0;
    for (const axis of ['x', 'y', 'z'] as const) Velocity[axis][rocket.id] = 0;
    this.#world.versions.style++;
  }

  #place(id: number, place: Point3): void {
    const { components, previous, versions } = this.#world;
    for (const axis of ['x', 'y', 'z'] as const) {
      components.Position[axis][id] = place[axis];
      // Prevents interpolation from the previous position.
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

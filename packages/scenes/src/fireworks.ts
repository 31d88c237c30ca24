// Fireworks: shells launched from mortars burst into stars that glow, fall, drift with the wind and gyrate in a
// magnetic field; and a barrage that keeps a given number of sparks alive. No entity is created or removed while it
// runs.
import {
  aliveCount,
  boris,
  buoyancy,
  burst,
  createEmitter,
  createPattern,
  createPhysicsWorld,
  createRandom,
  type Emitter,
  keepState,
  type PhysicsWorld,
  quadraticDrag,
  type Random,
  replaceForce,
  setEmitter,
  uniformGravity,
} from '@principia/physics';
import type { Air } from './fireworks/aim.ts';
import { STAR_COLORS, STAR_RGB } from './fireworks/colors.ts';
import { FAMILY_BODIES } from './fireworks/families.ts';
import { formVelocities } from './fireworks/forms.ts';
import { EventRing, type FireworksEvent } from './fireworks/news.ts';
import { ORIGIN, type Point3 } from './fireworks/place.ts';
import { Rockets, SHELL_DRAG, type ShellOrder } from './fireworks/rockets.ts';
import { heldStars, SHELLS } from './fireworks/shells.ts';
import { AIR_DENSITY, GLOW, rampsOf, STAR_MASS, StarPools } from './fireworks/stars.ts';
import { countOf, defineScene, type SceneRun } from './scene.ts';

/** The part of the sky in which the barrage and a cross-hair burst shells, m: half its width and depth, and its lowest and highest point. */
export const FIREWORKS_SKY = { halfWidth: 48, halfDepth: 16, lowest: 12, highest: 50 } as const;

/**
 * The part of the sky that shells reach, m: all that a window shows, from phones held upright, which show 100 m of height,
 * to the widest. The highest shell takes 4 s.
 */
export const FIREWORKS_REACH = { halfWidth: 80, halfDepth: 80, lowest: 6, highest: 100 } as const;

/** A running fireworks scene. */
export interface Fireworks extends SceneRun {
  /** Audible and visible events. */
  readonly events: EventRing;
  /** Sparks and stars alive now. */
  readonly alive: number;
  /** Stars of shells and swarms born so far. */
  readonly born: number;
  /** Shells in the air. */
  readonly flying: number;
  /**
   * Launches a shell in the next step, or ignites a swarm at its target; false if no shell is left on the ground or the
   * swarm was held for less than a second.
   */
  launch(order: ShellOrder): boolean;
  /** Sets the wind along x, m/s. */
  setWind(speed: number): void;
  /** @param colors eight, as 0xRRGGBB; living stars change too */
  setColors(colors: readonly number[]): void;
  /** Continues the barrage or lets it run out. */
  setBarrage(on: boolean): void;
}

const DT = 1 / 60;
const GRAVITY = 9.80665;
/** Magnetic flux density along z, T; fictitious, for the charged stars. */
const FIELD = 1;

/** Shells that burst into glowing stars; a barrage keeps a number of sparks alive. */
export const fireworks = defineScene({
  name: 'fireworks',
  description: 'shells that burst into glowing stars; a barrage keeps a number of sparks alive',
  precision: 'f32',
  parameters: {
    count: countOf('sparks that a barrage keeps alive', 100_000, 4_000_000, 0),
    shells: { about: 'shells in the air at most', unit: '', initial: 0, min: 0, max: 200, integer: true },
    wind: { about: 'wind along x', unit: 'm/s', initial: 0, min: -30, max: 30 },
  },
  build({ dimensions, precision, seed, parameters }): Fireworks {
    const { count, shells } = parameters;
    const room = memoryFor(count, shells);
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: room.bodies,
      arenaBytes: room.bytes,
      integrator: boris({ field: { z: FIELD } }),
      forces: [
        uniformGravity({ y: -GRAVITY }),
        quadraticDrag({ x: parameters.wind }),
        ...(shells > 0 ? [buoyancy({ density: AIR_DENSITY, gravity: { y: -GRAVITY } })] : []),
      ],
    });
    const random = createRandom(seed, 1);
    const events = new EventRing();
    // A typed array, because snapshots copy it without garbage.
    const wind = new Float64Array([parameters.wind]);
    const air = {
      drag: SHELL_DRAG,
      gravity: GRAVITY,
      get wind() {
        return wind[0];
      },
    };
    const setWind = (speed: number) => {
      if (speed !== wind[0]) replaceForce(world, quadraticDrag({ x: speed }));
      wind[0] = speed;
    };
    const show = shells > 0 ? createShow(world, random, events, shells, air) : undefined;
    const barrage = count > 0 ? new Barrage(world, random, count) : undefined;
    keepState(world, random.state, events, wind);
    world.phases.input.push(() => {
      show?.run();
      barrage?.run();
    });
    return {
      world,
      dt: DT,
      events,
      losesEnergy: 'sparks are born and expire',
      get alive() {
        return (show?.stars.alive ?? 0) + (barrage?.alive ?? 0);
      },
      get born() {
        return show?.stars.born ?? 0;
      },
      get flying() {
        return show?.rockets.flying ?? 0;
      },
      launch: (order) => show?.launch(order) ?? false,
      setWind,
      setColors(colors) {
        show?.stars.setColors(colors);
        barrage?.setColors(colors);
      },
      setBarrage(on) {
        barrage?.setOn(on);
      },
    };
  },
});

/** Bodies and bytes of all pools: a pool takes up to 92 bytes per star, and an emitter 40 KB. */
function memoryFor(count: number, shells: number): { bodies: number; bytes: number } {
  const stars = shells > 0 ? SHELLS.reduce((sum, { capacity }) => sum + capacity, FAMILY_BODIES) : 0;
  const bodies = barrageCapacity(count) + stars + shells * Rockets.entities + 1;
  return { bodies, bytes: 2 ** 21 + 512 * bodies + 49_152 * (shells + SHELLS.length + 1) };
}

function createShow(world: PhysicsWorld, random: Random, events: EventRing, shells: number, air: Air) {
  const stars = new StarPools(world, random);
  const rockets = new Rockets(world, shells, DT, air);
  const emit = (type: FireworksEvent['type'], { x, y, z }: Point3, kind = 0, color = 0, power = 0) => {
    const record = events.next();
    record.type = type;
    record.x = x;
    record.y = y;
    record.z = z;
    record.time = world.time;
    record.kind = kind;
    record.color = color;
    record.power = power;
  };
  const onCrackle = (place: Point3) => emit('crackle', place);
  const burst = (order: ShellOrder, position: Point3, velocity: Point3) => {
    if (order.points === undefined) stars.break(order.kind, order.color, order.power, position, velocity);
    else stars.write(order.points, order.color, order.power, position, velocity);
    emit('burst', position, order.kind, order.color, order.power);
  };
  return {
    stars,
    rockets,
    launch(order: ShellOrder): boolean {
      const kind = SHELLS[order.kind];
      if (kind.isHeld) {
        if (heldStars(kind, order.power) === 0) return false;
        burst(order, { x: order.x, y: order.y, z: order.z }, ORIGIN);
        return true;
      }
      const from = rockets.launch(order);
      if (from !== undefined) emit('launch', from, order.kind, order.color, order.power);
      return from !== undefined;
    },
    run() {
      stars.follow(onCrackle);
      rockets.burn(burst);
    },
  };
}

const BARRAGE_LIFE = 2.4;
const BARRAGE_SPEED = 24;

/** Capacity for random fluctuations and for the burst of a step. */
function barrageCapacity(count: number): number {
  return count === 0 ? 0 : count + Math.ceil(4 * Math.sqrt(count)) + burstSize(count);
}

/** Sparks per burst: more if there would be more than a hundred bursts at a time. */
function burstSize(count: number): number {
  return Math.max(Math.min(count, 400), Math.ceil(count / 100));
}

/** Random bursts without shells, at the rate that keeps the number of sparks. */
class Barrage {
  /** Whether the barrage continues, and the number of steps so far. */
  readonly #state = { isOn: true, steps: 0 };
  /** Accumulated number of sparks to emit. A typed array, because snapshots copy it without garbage. */
  readonly #due = new Float64Array(1);
  readonly #emitter: Emitter;
  readonly #random: Random;
  readonly #patterns;
  readonly #size: number;
  /** Sparks born per step. */
  readonly #rate: number;
  readonly #place = { x: 0, y: 0, z: 0 };
  /** The parameters of a burst, reused. */
  readonly #order;
  readonly #depth: number;

  constructor(world: PhysicsWorld, random: Random, count: number) {
    this.#random = random;
    this.#size = burstSize(count);
    this.#rate = (count * DT) / BARRAGE_LIFE;
    this.#depth = world.dimensions === 3 ? FIREWORKS_SKY.halfDepth : 0;
    const kind = { ...SHELLS[0], slowest: 0.35 };
    this.#patterns = Array.from({ length: 8 }, () =>
      createPattern(world, formVelocities(kind, world.dimensions, random)),
    );
    // The first sparks have random remaining lifetimes, so the number is steady from the first step.
    this.#emitter = createEmitter(world, {
      capacity: barrageCapacity(count),
      lifetime: [1e-6, BARRAGE_LIFE],
      speed: 0,
      mass: STAR_MASS,
      size: [0.16, 0.2, 0.15, 0.05],
      shape: GLOW,
      color: rampsOf(STAR_RGB),
      whenFull: 'oldest',
      quadraticDrag: 0.08 * STAR_MASS,
    });
    this.#order = { position: this.#place, ramp: 0, pattern: this.#patterns[0], scale: 1 };
    keepState(world, this.#state, this.#due);
    for (let left = count; left > 0; left -= this.#size) this.#burst(Math.min(left, this.#size));
  }

  get alive(): number {
    return aliveCount(this.#emitter);
  }

  setColors(colors: readonly number[]): void {
    setEmitter(this.#emitter, { color: rampsOf(colors) });
  }

  setOn(on: boolean): void {
    this.#state.isOn = on;
  }

  run(): void {
    const state = this.#state;
    // The first step emits the first sparks; all later sparks have the full lifetime.
    if (state.steps++ === 0) return;
    if (state.steps === 2) setEmitter(this.#emitter, { lifetime: BARRAGE_LIFE });
    if (!state.isOn) return;
    const due = this.#due;
    for (due[0] += this.#rate; due[0] >= this.#size; due[0] -= this.#size) this.#burst(this.#size);
  }

  #burst(count: number): void {
    const random = this.#random;
    const { halfWidth, lowest, highest } = FIREWORKS_SKY;
    const place = this.#place;
    place.x = random.uniform(-halfWidth, halfWidth);
    place.y = random.uniform(lowest, highest);
    place.z = random.uniform(-1, 1) * this.#depth;
    const order = this.#order;
    order.pattern = this.#patterns[random.integer(0, this.#patterns.length - 1)];
    order.ramp = random.integer(0, STAR_COLORS.length - 1);
    order.scale = BARRAGE_SPEED * random.uniform(0.6, 1);
    burst(this.#emitter, count, order);
  }
}

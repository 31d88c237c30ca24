/** The simulation: a submarine with a ballast tank in a sea with a bed and currents. It needs no display. */
import {
  boxWalls,
  buoyancy,
  cos,
  createPhysicsWorld,
  defineForce,
  keepState,
  markImmutable,
  on,
  type PhysicsWorld,
  particleContacts,
  sin,
  spawn,
  thrust,
  uniformGravity,
  wallContacts,
} from '@principia/physics';
import { DENSITY, GRAVITY, HULL } from './hull.ts';
import { type Pitch, stepPitch } from './pitch.ts';
import { createSea, currentAt, type Sea, SHIP, WIDTH } from './sea.ts';

/** Mass of the water whose place the hull takes, kg. Empty, the boat weighs half of it; a full tank adds as much again. */
const DISPLACED = DENSITY * HULL.volume;
/** Change of the filled fraction of the tank while a key is held, 1/s. */
const FILL_RATE = 0.22;
/** The hull is pressed together: fraction of its volume by m of depth. Deeper, it carries less. */
const COMPRESSION = 6e-5;
/** Compressed air, m³ at the pressure of the surface, and what a second at the surface gives back. */
export const AIR = { full: 1500, refill: 300 } as const;
/** Depth at which the tower is out of the water, m. */
const SURFACED = 2.6;
/** Fraction of the hull that a second 10 m below the limit costs, and a knock of 1 m/s beyond the first. */
const CRUSH = 0.08;
const KNOCK = { free: 0.9, cost: 0.11 } as const;
const GRAB = 7;
/** Seconds of breath below the surface: from the sixth level on the crates are not more, only deeper. */
export const breathOf = (level: number): number => 230 + 80 * Math.min(level, 5) + 40 * Math.max(0, level - 5);
/** Speed of the sound, m/s, and seconds that an echo stays and that lie between two pings. */
export const PING = { speed: 90, life: 6, pause: 1.5 } as const;

export type Ending = 'none' | 'won' | 'crushed' | 'wrecked' | 'suffocated';

/** What is saved with the world. */
interface Boat {
  /** Filled fraction of the tank, and −1 to blow, 1 to flood. */
  fill: number;
  valve: number;
  /** −1 astern, 1 ahead. */
  engine: number;
  air: number;
  /** 1 whole, 0 lost. */
  hull: number;
  breath: number;
  collected: number;
  ending: Ending;
  /** When and where the last ping was sent, s and m. */
  pingTime: number;
  pingX: number;
  pingY: number;
}

export interface SubmarineOptions {
  readonly values: { readonly level: number };
  readonly seed: number;
}

export class SubmarineGame {
  readonly world: PhysicsWorld;
  readonly dt = 1 / 60;
  readonly sea: Sea;
  readonly level: number;
  readonly sub: number;
  readonly boat: Boat;
  readonly tilt: Pitch = { pitch: 0, rate: 0, planes: 0, facing: 1 };
  /** 1 for each crate that is aboard. */
  readonly taken: Uint8Array;
  readonly #speeds = new Float64Array(1);
  readonly #place = { depth: 0, volume: 0, speed: 0 };

  constructor({ values: { level }, seed }: SubmarineOptions) {
    this.level = level;
    this.sea = markImmutable(createSea(level, seed));
    this.taken = new Uint8Array(this.sea.crates.length / 2);
    this.boat = {
      fill: 0.4,
      valve: 0,
      engine: 0,
      air: AIR.full,
      hull: 1,
      breath: breathOf(level),
      collected: 0,
      ending: 'none',
      pingTime: -100,
      pingX: 0,
      pingY: 0,
    };
    this.world = this.#createWorld();
    this.sub = spawn(this.world, {
      position: { x: SHIP.x, y: -1.76 },
      velocity: {},
      mass: massOf(0.4),
      collider: { radius: HULL.halfHeight, restitution: 0.15, friction: 0.2 },
      hull: { volume: HULL.volume, halfHeight: HULL.halfHeight, shape: 1 },
      thrust: {},
    });
    keepState(this.world, this.boat, this.tilt, this.taken, this.#speeds);
    this.world.phases.input.push((_, dt) => this.#steer(dt));
    this.world.phases.events.push((_, dt) => this.#judge(dt));
    on(this.world, 'wallContact', (i) => this.#knock(wallContacts(this.world).impulse[i]));
  }

  get depth(): number {
    return -this.world.components.Position.y[this.sub];
  }

  /** Pressure of the water, in those of the air at the surface. */
  get pressure(): number {
    return 1 + (DENSITY * GRAVITY * Math.max(0, this.depth)) / 101_325;
  }

  /** Mass by that of the displaced water: 1 hovers. */
  get ratio(): number {
    return this.world.components.Mass.value[this.sub] / (DENSITY * volumeAt(this.depth));
  }

  get isOver(): boolean {
    return this.boat.ending !== 'none';
  }

  press(name: string): void {
    const { boat } = this;
    if (name === 'up' || name === 'down') boat.valve = name === 'up' ? -1 : 1;
    else if (name === 'left' || name === 'right') boat.engine = name === 'left' ? -1 : 1;
    else this.ping();
  }

  release(name: string): void {
    if (name === 'up' || name === 'down') this.boat.valve = 0;
    if (name === 'left' || name === 'right') this.boat.engine = 0;
  }

  /** Takes the direction in which a pointer lies, as fractions, y up: it holds the keys of the nearest of eight ways. */
  steer(x: number, y: number): void {
    this.boat.engine = wayOf(x);
    this.boat.valve = -wayOf(y);
  }

  /** Sends a sound whose echo shows the bed. */
  ping(): void {
    const { world, boat, sub } = this;
    if (world.time - boat.pingTime < PING.pause) return;
    boat.pingTime = world.time;
    boat.pingX = world.components.Position.x[sub];
    boat.pingY = world.components.Position.y[sub];
  }

  score(): number {
    const { boat, level } = this;
    const won = boat.ending === 'won' ? 200 * level + 2 * Math.round(boat.breath) + Math.round(100 * boat.hull) : 0;
    return 50 * boat.collected + won;
  }

  #createWorld(): PhysicsWorld {
    const { bed } = this.sea;
    const walls = [boxWalls({ min: { x: 4 }, max: { x: WIDTH - 4 } })];
    const water = { density: DENSITY, gravity: { y: -GRAVITY }, level: 0 };
    const forces = [uniformGravity({ y: -GRAVITY }), buoyancy(water), thrust(), this.#drag()];
    const world = createPhysicsWorld({ capacity: bed.length, preset: particleContacts, forces, walls });
    for (let i = 0; i + 3 < bed.length; i += 2) {
      spawn(world, { segmentWall: { ax: bed[i], ay: bed[i + 1], bx: bed[i + 2], by: bed[i + 3] } });
    }
    return world;
  }

  /** Quadratic drag of the immersed part, relative to the current: F = −f k |w| w. */
  #drag() {
    return defineForce({
      name: 'drag in the current',
      equation: 'F = -f k |w| w',
      reads: ['Position', 'Velocity'],
      local: false,
      accumulate: ({ components: { Position, Velocity }, scratch: { force } }) => {
        const depth = -Position.y[this.sub];
        const fraction = Math.min(1, Math.max(0, 0.5 + (0.5 * depth) / HULL.halfHeight));
        const wx = Velocity.x[this.sub] - currentAt(this.sea, depth);
        const wy = Velocity.y[this.sub];
        const pull = fraction * HULL.drag * Math.sqrt(wx * wx + wy * wy);
        force.x[this.sub] -= pull * wx;
        force.y[this.sub] -= pull * wy;
      },
    });
  }

  #steer(dt: number): void {
    const { boat, world, sub } = this;
    const { Mass, Hull, Thrust } = world.components;
    if (boat.valve > 0 && !this.isOver) boat.fill = Math.min(1, boat.fill + FILL_RATE * dt);
    if (boat.valve < 0 && boat.air > 0 && !this.isOver) {
      const blown = Math.min(boat.fill, FILL_RATE * dt);
      boat.fill -= blown;
      // Air that drives water out has the pressure of the depth.
      boat.air = Math.max(0, boat.air - blown * HULL.volume * this.pressure);
    }
    // A wreck fills with water.
    if (boat.ending === 'crushed' || boat.ending === 'wrecked') boat.fill = Math.min(1, boat.fill + 0.3 * dt);
    Mass.value[sub] = massOf(boat.fill);
    Hull.volume[sub] = volumeAt(this.depth);
    const isWet = this.depth > -0.5 * HULL.halfHeight;
    this.#tilt(dt);
    const { facing, pitch } = this.tilt;
    const push = isWet && !this.isOver && boat.engine !== 0 ? HULL.thrust : 0;
    Thrust.x[sub] = push * facing * cos(pitch);
    Thrust.y[sub] = push * sin(pitch);
  }

  /** Turns the planes with the valve, and the boat with them. */
  #tilt(dt: number): void {
    const { boat, world, sub } = this;
    const { tilt } = this;
    const place = this.#place;
    if (boat.engine !== 0) tilt.facing = boat.engine;
    const { Velocity, Hull } = world.components;
    const through = Velocity.x[sub] - currentAt(this.sea, this.depth);
    place.depth = this.depth;
    place.volume = Hull.volume[sub];
    place.speed = tilt.facing * through * cos(tilt.pitch) + Velocity.y[sub] * sin(tilt.pitch);
    stepPitch(tilt, this.isOver ? 0 : -boat.valve, place, dt);
  }

  #judge(dt: number): void {
    const { boat, sea } = this;
    if (this.isOver) return;
    const isUp = this.depth < SURFACED;
    if (isUp) boat.air = Math.min(AIR.full, boat.air + AIR.refill * dt);
    // At the surface the hatch is open: the air to breathe lasts, but is not renewed, so that waiting gains nothing.
    else boat.breath = Math.max(0, boat.breath - dt);
    const beyond = this.depth - sea.crushDepth;
    if (beyond > 0) boat.hull -= (CRUSH * dt * beyond) / 10 + CRUSH * dt;
    this.#collect();
    const { x } = this.world.components.Position;
    const isHome = isUp && Math.abs(x[this.sub] - SHIP.x) < SHIP.reach;
    if (boat.hull <= 0) boat.ending = beyond > 0 ? 'crushed' : 'wrecked';
    else if (boat.collected === this.taken.length && isHome) boat.ending = 'won';
    else if (boat.breath <= 0) boat.ending = 'suffocated';
    boat.hull = Math.max(0, boat.hull);
  }

  #collect(): void {
    const { crates } = this.sea;
    const { x, y } = this.world.components.Position;
    for (let i = 0; i < this.taken.length; i++) {
      if (this.taken[i] === 1) continue;
      const [dx, dy] = [crates[2 * i] - x[this.sub], crates[2 * i + 1] - y[this.sub]];
      if (dx * dx + dy * dy > GRAB * GRAB) continue;
      this.taken[i] = 1;
      this.boat.collected++;
    }
  }

  /** A knock against bed or shore. @param impulse N s */
  #knock(impulse: number): void {
    if (this.isOver) return;
    const speed = impulse / this.world.components.Mass.value[this.sub];
    if (speed > KNOCK.free) this.boat.hull -= KNOCK.cost * (speed - KNOCK.free);
  }
}

/** −1, 0 or 1: beyond the sine of 22.5° a fraction counts. */
const wayOf = (fraction: number): number => (Math.abs(fraction) > 0.38 ? Math.sign(fraction) : 0);

/** Mass with a fraction of the tank filled, kg. */
export const massOf = (fill: number): number => DISPLACED * (0.5 + fill);

/** Volume of the hull at a depth, m³. */
export const volumeAt = (depth: number): number => HULL.volume * (1 - COMPRESSION * Math.max(0, depth));

export function createGame(options: SubmarineOptions): SubmarineGame {
  return new SubmarineGame(options);
}

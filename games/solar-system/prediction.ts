/** The flight ahead: probes without mass among the bodies of a track, in a world of their own. */
import {
  createPhysicsWorld,
  defineForce,
  destroyWorld,
  type PhysicsWorld,
  rungeKutta4,
  spawn,
  step,
} from '@principia/physics';
import { BODY_NAMES } from '@principia/scenes';
import { closestIn, encounterInterval, RADII, type State } from './flight.ts';
import { DAY } from './solar-clock.ts';
import { TRACKED, TRACKED_GM, type Track } from './track.ts';
import { type Vector, vector } from './vectors.ts';

/** Limits of a step, s. */
const MIN_STEP = 300;
const MAX_STEP = 3 * DAY;
const MAX_POINTS = 4000;

export class Prediction {
  /** Points of the path relative to the Sun, km, their dates, s since 2000, and their number. */
  readonly path = new Float64Array(3 * MAX_POINTS);
  readonly dates = new Float64Array(MAX_POINTS);
  count = 0;
  /** Closest approach to each body of `TRACKED`, km, and its date, s since 2000. */
  readonly closest = new Float64Array(TRACKED.length);
  readonly closestAt = new Float64Array(TRACKED.length);
  isDone = true;
  /** What the path of a single probe hits, where it ends: index in `TRACKED`; −1 without. */
  hit = -1;
  readonly #world: PhysicsWorld;
  readonly #probes: readonly number[];
  readonly #track: Track;
  readonly #body = new Float64Array(6);
  #start = 0;
  #end = 0;

  /** @param count number of probes; the first has the path */
  constructor(track: Track, count = 1) {
    this.#track = track;
    const at = new Float64Array(6);
    const gravity = defineForce({
      name: 'gravity of a track',
      equation: 'F = Σ G m M r / r³',
      reads: ['Position', 'Mass'],
      local: false,
      accumulate: ({ components: { Position, Mass }, scratch: { force } }, first, last, time) => {
        for (let body = 0; body < TRACKED.length; body++) {
          track.at(body, this.#start + time, at);
          for (let id = Math.max(1, first); id < last; id++) {
            const [dx, dy, dz] = [at[0] - Position.x[id], at[1] - Position.y[id], at[2] - Position.z[id]];
            const r2 = dx * dx + dy * dy + dz * dz;
            const pull = (Mass.value[id] * TRACKED_GM[body]) / (r2 * Math.sqrt(r2));
            force.x[id] += pull * dx;
            force.y[id] += pull * dy;
            force.z[id] += pull * dz;
          }
        }
      },
    });
    this.#world = createPhysicsWorld({
      dimensions: 3,
      precision: 'f64',
      capacity: count,
      integrator: rungeKutta4,
      forces: [gravity],
    });
    this.#probes = Array.from({ length: count }, () => spawn(this.#world, { position: {}, velocity: {}, mass: 1 }));
  }

  /** Starts probes from a place with different velocities, at a date and until another, s since 2000. */
  start(position: Vector, velocities: readonly Vector[], date: number, end: number): void {
    const { Position, Velocity } = this.#world.components;
    for (const [i, id] of this.#probes.entries()) {
      for (const axis of ['x', 'y', 'z'] as const) {
        Position[axis][id] = position[axis];
        Velocity[axis][id] = velocities[i][axis];
      }
    }
    this.#start = date - this.#world.time;
    this.#end = end;
    this.count = 0;
    this.hit = -1;
    this.isDone = false;
    this.closest.fill(Number.POSITIVE_INFINITY);
    this.#record(date, 0);
  }

  /** Goes on by some steps, as far as the track is known. @returns whether the path has reached its end */
  advance(steps: number): boolean {
    for (let i = 0; i < steps && !this.isDone; i++) {
      const now = this.#start + this.#world.time;
      const interval = Math.min(this.#stepLength(now), this.#end - now);
      if (now + interval > this.#track.end) return false;
      if (!(interval > 1e-3) || this.count === MAX_POINTS) {
        this.isDone = true;
        break;
      }
      step(this.#world, interval);
      this.#record(this.#start + this.#world.time, interval);
      if (this.hit >= 0) this.isDone = true;
    }
    return this.isDone;
  }

  /** Position and velocity of a probe. */
  probe(index = 0): State {
    const { Position, Velocity } = this.#world.components;
    const id = this.#probes[index];
    return {
      position: vector(Position.x[id], Position.y[id], Position.z[id]),
      velocity: vector(Velocity.x[id], Velocity.y[id], Velocity.z[id]),
    };
  }

  destroy(): void {
    destroyWorld(this.#world);
  }

  #stepLength(now: number): number {
    let length = MAX_STEP;
    for (let body = 0; body < TRACKED.length; body++) {
      const [separation, velocity] = this.#relative(body, now);
      length = Math.min(length, 0.6 * encounterInterval(separation, velocity));
    }
    return Math.max(MIN_STEP, length);
  }

  /** Position and velocity of the first probe relative to a body. */
  #relative(body: number, now: number): [Vector, Vector] {
    const at = this.#body;
    this.#track.at(body, now, at);
    const { position: p, velocity: v } = this.probe();
    return [vector(p.x - at[0], p.y - at[1], p.z - at[2]), vector(v.x - at[3], v.y - at[4], v.z - at[5])];
  }

  #record(now: number, interval: number): void {
    for (let body = 0; body < TRACKED.length; body++) {
      const [{ x, y, z }, velocity] = this.#relative(body, now);
      if (body === 0) this.path.set([x, y, z], 3 * this.count);
      const { distance, ago } = closestIn({ x, y, z }, velocity, interval);
      if (this.#probes.length === 1 && distance < RADII[BODY_NAMES.indexOf(TRACKED[body])]) this.hit = body;
      if (distance >= this.closest[body]) continue;
      this.closest[body] = distance;
      this.closestAt[body] = now - ago;
    }
    this.dates[this.count++] = now;
  }
}

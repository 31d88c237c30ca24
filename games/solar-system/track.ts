/**
 * Where Sun and planets will be: computed ahead by the same gravity, with Earth and Moon as one body, and kept as a state
 * for every second day. Between two of them a cubic with the right velocities at both ends errs by less than 100 km.
 */
import { destroyWorld, gaussRadau, step } from '@principia/physics';
import { BODY_NAMES, type BodyName, buildSolarSystem, SOLAR_STATES, type SolarSystem } from '@principia/scenes';
import type { SolarGame } from './sim.ts';
import { DAY } from './solar-clock.ts';
import { scaled, sum, type Vector } from './vectors.ts';

/** The bodies of a track. */
export const TRACKED: readonly BodyName[] = BODY_NAMES.filter((name) => name !== 'moon');
const SPACING = 2 * DAY;
/** Longest track, in samples: 14 years. */
const MAX_SAMPLES = 2600;
const NUMBERS = 6;

const { earth, moon } = SOLAR_STATES;
/** km³/s². */
export const TRACKED_GM: readonly number[] = TRACKED.map((name) =>
  name === 'earth' ? earth.gm + moon.gm : SOLAR_STATES[name].gm,
);

export class Track {
  /** Date of the first sample, s since 2000. */
  start = 0;
  #count = 0;
  readonly #samples = new Float64Array(MAX_SAMPLES * TRACKED.length * NUMBERS);
  readonly #system: SolarSystem = buildSolarSystem({ moon: false, integrator: gaussRadau({ tolerance: 1e-6 }) });

  /** Date of the last sample, s since 2000. */
  get end(): number {
    return this.start + (this.#count - 1) * SPACING;
  }

  /** Starts again from the present state of a game. */
  begin(game: SolarGame): void {
    const { Position, Velocity } = this.#system.world.components;
    for (const name of TRACKED) {
      const id = this.#system.ids[name] as number;
      const state = game.bodyState(name);
      const isPair = name === 'earth' && game.system.ids.moon !== undefined;
      const position = isPair ? centre(state.position, game.bodyState('moon').position) : state.position;
      const velocity = isPair ? centre(state.velocity, game.bodyState('moon').velocity) : state.velocity;
      for (const axis of ['x', 'y', 'z'] as const) {
        Position[axis][id] = position[axis];
        Velocity[axis][id] = velocity[axis];
      }
    }
    this.start = game.clock.now;
    this.#count = 0;
    this.#record();
  }

  /** Computes up to `days` ahead, at most until `end`. @returns whether the end is reached */
  extend(end: number, days: number): boolean {
    const until = Math.min(end, this.start + (MAX_SAMPLES - 1) * SPACING);
    for (let done = 0; done < days && this.end < until; done += SPACING / DAY) {
      step(this.#system.world, SPACING);
      this.#record();
    }
    return this.end >= until;
  }

  /** Writes position, km, and velocity, km/s, of a body at a date within the track. @param body index in `TRACKED` */
  at(body: number, date: number, out: Float64Array): void {
    const place = Math.min(Math.max(0, (date - this.start) / SPACING), this.#count - 1);
    const first = Math.min(Math.floor(place), Math.max(0, this.#count - 2));
    const t = place - first;
    const a = (first * TRACKED.length + body) * NUMBERS;
    const b = Math.min(first + 1, this.#count - 1) * TRACKED.length * NUMBERS + body * NUMBERS;
    const s = this.#samples;
    const [t2, t3] = [t * t, t * t * t];
    for (let i = 0; i < 3; i++) {
      const [p, q] = [s[a + i], s[b + i]];
      const [v, w] = [SPACING * s[a + i + 3], SPACING * s[b + i + 3]];
      out[i] = p + t * v + t2 * (3 * (q - p) - 2 * v - w) + t3 * (2 * (p - q) + v + w);
      out[i + 3] = s[a + i + 3] + t * (s[b + i + 3] - s[a + i + 3]);
    }
  }

  destroy(): void {
    destroyWorld(this.#system.world);
  }

  #record(): void {
    const { Position, Velocity } = this.#system.world.components;
    let at = this.#count * TRACKED.length * NUMBERS;
    for (const name of TRACKED) {
      const id = this.#system.ids[name] as number;
      for (const { x, y, z } of [Position, Velocity]) {
        this.#samples[at++] = x[id];
        this.#samples[at++] = y[id];
        this.#samples[at++] = z[id];
      }
    }
    this.#count++;
  }
}

/** Centre of mass of Earth and Moon. */
function centre(a: Vector, b: Vector): Vector {
  return sum(scaled(a, earth.gm / (earth.gm + moon.gm)), b, moon.gm / (earth.gm + moon.gm));
}

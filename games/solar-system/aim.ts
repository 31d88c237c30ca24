/**
 * Aims a burn at a body: three more probes, each with a velocity that differs a little along one axis, tell how the place
 * at the time of the closest approach depends on the velocity, and Newton's method removes the distance. A step that makes
 * it worse is halved.
 */
import { burnAxes, type State } from './flight.ts';
import { Prediction } from './prediction.ts';
import type { Track } from './track.ts';
import { cross, dot, lengthOf, scaled, sum, unit, type Vector, vector } from './vectors.ts';

/** Difference of velocity of the other probes, km/s. */
const NUDGE = 1e-4;
/** Largest change of one step, km/s. */
const MAX_CHANGE = 0.4;
const MAX_ROUNDS = 14;
const MIN_FACTOR = 1 / 64;

export interface AimOrder {
  /** The probe before the burn. */
  readonly probe: State;
  readonly sun: State;
  /** Forward, outward and north, km/s. */
  readonly amounts: readonly number[];
  /** Date of the burn and of the end of the mission, s since 2000. */
  readonly now: number;
  readonly end: number;
  /** Index in `TRACKED`. */
  readonly target: number;
  /** How far before the target, on its orbit, the probe shall pass, km; negative behind it. */
  readonly ahead: number;
  /** The search ends when the probe passes within this distance of where it shall, km. */
  readonly reach: number;
}

export class AimSearch {
  /** The best amounts so far, and how far from its aim the probe passes, km. */
  amounts: readonly number[] = [];
  miss = Number.POSITIVE_INFINITY;
  isDone = true;
  /** Whether the probe passes as ordered. */
  isReached = false;
  readonly #track: Track;
  readonly #single: Prediction;
  readonly #four: Prediction;
  readonly #body = new Float64Array(6);
  #order: AimOrder | undefined;
  #trial: readonly number[] = [];
  #change = vector();
  #factor = 1;
  #rounds = 0;
  #isProbing = false;

  constructor(track: Track) {
    this.#track = track;
    this.#single = new Prediction(track);
    this.#four = new Prediction(track, 4);
  }

  begin(order: AimOrder): void {
    this.#order = order;
    this.#trial = order.amounts;
    this.amounts = order.amounts;
    this.miss = Number.POSITIVE_INFINITY;
    this.#rounds = 0;
    this.isDone = false;
    this.isReached = false;
    this.#try();
  }

  cancel(): void {
    this.isDone = true;
  }

  /** Goes on by some steps of its probes. @returns whether the search has ended */
  advance(steps: number): boolean {
    if (this.isDone) return true;
    if (this.#isProbing) {
      if (this.#four.advance(Math.ceil(steps / 2))) this.#takeStep();
    } else if (this.#single.advance(steps)) this.#judge();
    return this.isDone;
  }

  destroy(): void {
    this.#single.destroy();
    this.#four.destroy();
  }

  #velocities(amounts: readonly number[]): readonly Vector[] {
    const { probe, sun } = this.#order as AimOrder;
    const axes = burnAxes(probe, sun);
    const velocity = axes.reduce((v, axis, i) => sum(v, axis, amounts[i]), probe.velocity);
    return [velocity, ...axes.map((axis) => sum(velocity, axis, NUDGE))];
  }

  #try(): void {
    const { probe, now, end } = this.#order as AimOrder;
    this.#isProbing = false;
    this.#single.start(probe.position, this.#velocities(this.#trial), now, end);
  }

  /** Compares a trial with the best so far, and prepares what comes next. */
  #judge(): void {
    const { probe, now, target, ahead, reach } = this.#order as AimOrder;
    const miss = Math.abs(this.#single.closest[target] - Math.abs(ahead));
    if (miss < this.miss) {
      this.miss = miss;
      this.amounts = this.#trial;
      this.isReached = miss < reach;
      if (this.isReached || ++this.#rounds > MAX_ROUNDS) {
        this.isDone = true;
        return;
      }
      this.#factor = 1;
      this.#isProbing = true;
      this.#four.start(probe.position, this.#velocities(this.amounts), now, this.#single.closestAt[target]);
      return;
    }
    this.#factor /= 2;
    if (this.#factor < MIN_FACTOR) this.isDone = true;
    else this.#tryChange();
  }

  /** Computes the change that Newton's method wants. */
  #takeStep(): void {
    const { target, ahead } = this.#order as AimOrder;
    this.#track.at(target, this.#single.closestAt[target], this.#body);
    const [x, y, z, vx, vy, vz] = this.#body;
    const wanted = sum(vector(x, y, z), unit(vector(vx, vy, vz)), ahead);
    const places = [0, 1, 2, 3].map((i) => sum(this.#four.probe(i).position, wanted, -1));
    const columns = [1, 2, 3].map((i) => scaled(sum(places[i], places[0], -1), 1 / NUDGE)) as [Vector, Vector, Vector];
    const change = solve(columns, scaled(places[0], -1));
    if (change === undefined) {
      this.isDone = true;
      return;
    }
    this.#change = scaled(change, Math.min(1, MAX_CHANGE / lengthOf(change)));
    this.#tryChange();
  }

  #tryChange(): void {
    const { x, y, z } = this.#change;
    const [a, b, c] = this.amounts;
    this.#trial = [a + this.#factor * x, b + this.#factor * y, c + this.#factor * z];
    this.#try();
  }
}

/** Solves three equations by Cramer's rule. @param columns of the matrix */
function solve([a, b, c]: [Vector, Vector, Vector], right: Vector): Vector | undefined {
  const determinant = dot(a, cross(b, c));
  // Columns that nearly lie in a plane determine nothing.
  const scale = lengthOf(a) * lengthOf(b) * lengthOf(c);
  if (!(Math.abs(determinant) > 1e-9 * scale)) return undefined;
  return scaled(vector(dot(right, cross(b, c)), dot(a, cross(right, c)), dot(a, cross(b, right))), 1 / determinant);
}

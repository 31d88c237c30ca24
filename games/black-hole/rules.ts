/**
 * The rules of the game, applied to the world after every step.
 *
 * - If the ship's centre enters a horizon, it costs one of three lives and the layout of holes changes.
 * - Crossing the goal line gives as many points as there are holes, so n levels give n (n + 1) / 2; the next level has one hole more.
 * - A ship that leaves the stage restarts below the same holes at no cost.
 * - No layout lets a ship through that only climbs, so that each needs a swing-by.
 * - After a fall, a goal or an exit the engine is off and the game holds its breath; the next flight begins at the next input.
 * - The player may ask for a new layout at any time.
 * - Bonus points are separate from the score: one for every slingshot of a flight that reaches the goal, and up to five for unused fuel; none if the layout was changed in the level.
 */
import { keepState, markImmutable } from '@principia/physics';
import { BLACK_HOLE, type BlackHole } from '@principia/scenes';
import { FlightRecord } from './flight-record.ts';
import { type Push, thrustOf } from './heading.ts';
import { opensToOneKey } from './one-key-flight.ts';

export const LIVES = 3;
/** Change of velocity of a full tank, m/s; a climb without holes takes 100. */
export const TANK = 250;
/** The first level with moving holes. */
export const FIRST_MOVING_LEVEL = 5;
/** A slingshot is an approach within the first distance, in radii, that ends beyond the second. */
const SLING = { near: 3, far: 6 } as const;
const FUEL_BONUS = 5;
/** Time between the end of a flight and the start of the next, s. */
export const BREATH = 0.9;
/** Indices of the numbers that change in every step. */
const [FUEL, SPENT, WAIT] = [0, 1, 2];

/** An event for pictures and sounds. */
export interface GameEvent {
  readonly kind: 'fall' | 'goal' | 'left' | 'redraw' | 'sling' | 'empty' | 'over' | 'launch';
  readonly tick: number;
  readonly x: number;
  readonly y: number;
  readonly points: number;
}

/** The options that the player may change. */
export interface RuleOptions {
  /** The first level; default 1. */
  readonly level?: number;
  readonly fuel: boolean;
  readonly moving: boolean;
}

const MAX_EVENTS = 32;

export class Rules {
  /** Waiting for the first input, flying, holding its breath after a flight, or lost all lives. */
  phase: 'ready' | 'flying' | 'breath' | 'over' = 'ready';
  /** Holes of the next flight: the same, another layout of this level, or those of the next level. */
  next: 'same' | 'other' | 'level' = 'same';
  /** The player has launched a ship in this game. */
  hasBegun = false;
  lives = LIVES;
  score = 0;
  /** Whether the autopilot has flown in this game. */
  isAssisted = false;
  bonus = 0;
  /** Levels cleared. */
  dodged = 0;
  /** Layout changes in this level; any of them cancels the bonus. */
  redraws = 0;
  /** Slingshots of this flight. */
  slings = 0;
  /** Slingshots of all flights that reached the goal. */
  slingshots = 0;
  /** Thrust that the player asks for. */
  push: Push | undefined;
  /** Number of events so far, and the last few events. */
  eventCount = 0;
  readonly events: GameEvent[] = [];
  options: RuleOptions;
  /** The path of the present flight, or of the last one until the next is prepared. */
  readonly record = new FlightRecord();
  /**
   * Change of velocity left in the tank and spent in this flight, m/s, and time left to wait, s. A typed array, because
   * snapshots copy it without garbage.
   */
  readonly #delta = new Float64Array([TANK, 0, 0]);
  readonly #thrust = { x: 0, y: 0 };
  readonly #scene: BlackHole;
  /** Holes within slingshot distance of the ship. */
  readonly #near = new Set<number>();

  constructor(scene: BlackHole, options: RuleOptions) {
    this.#scene = scene;
    this.options = options;
    keepState(scene.world, this, this.#delta, this.#near, this.record.state);
  }

  /** Change of velocity left in the tank, m/s. */
  get fuel(): number {
    return this.#delta[FUEL];
  }

  set fuel(left: number) {
    this.#delta[FUEL] = left;
  }

  /** Change of velocity spent in this flight, m/s. */
  get spent(): number {
    return this.#delta[SPENT];
  }

  get firstLevel(): number {
    return this.options.level ?? 1;
  }

  /** Number of holes of the level. */
  get level(): number {
    return Math.min(BLACK_HOLE.most, this.dodged + 1);
  }

  /** Points for reaching the goal now. */
  get goalPoints(): number {
    return this.dodged + 1;
  }

  get movingHoles(): number {
    return this.options.moving && this.level >= FIRST_MOVING_LEVEL ? Math.ceil((this.level - 2) / 3) : 0;
  }

  /** Starts a new game with the first layouts of the seed. */
  restart(): void {
    const dodged = this.firstLevel - 1;
    Object.assign(this, {
      lives: LIVES,
      score: 0,
      bonus: 0,
      slingshots: 0,
      dodged,
      hasBegun: false,
      isAssisted: false,
    });
    this.#scene.rewind();
    this.#newHoles(true);
    this.#newFlight();
  }

  launch(): void {
    if (this.phase !== 'ready') return;
    this.phase = 'flying';
    this.hasBegun = true;
    this.#emit('launch', 0);
  }

  /** Changes the layout at the player's request. */
  redraw(): void {
    if (this.phase === 'over') return;
    this.#emit('redraw', 0);
    this.redraws++;
    this.#newHoles(false);
    this.#newFlight();
  }

  /** Runs before the step: applies thrust while there is fuel. */
  steer(dt: number): void {
    const { world, ship } = this.#scene;
    if (this.phase === 'breath') this.#wait(dt);
    const push = this.phase === 'flying' && this.hasFuel ? this.push : undefined;
    const { x, y } = thrustOf(push, this.#thrust);
    world.components.Thrust.x[ship] = x;
    world.components.Thrust.y[ship] = y;
    if (push === undefined) return;
    const cost = Math.sqrt(x * x + y * y) * dt;
    this.#delta[SPENT] += cost;
    if (!this.options.fuel) return;
    this.fuel = Math.max(0, this.fuel - cost);
    if (!this.hasFuel) this.#emit('empty', 0);
  }

  get hasFuel(): boolean {
    // Rounding may leave about 1e-9 m/s in the tank.
    return !this.options.fuel || this.fuel > 1e-9;
  }

  /** Runs after the step: detects falls, the goal and the edge of the stage, at most one of them per step. */
  judge(): void {
    if (this.phase !== 'flying') {
      this.#holdShip();
      return;
    }
    const { world, ship } = this.#scene;
    const { x, y } = world.components.Position;
    this.record.add(x[ship], y[ship]);
    if (this.#hasFallen()) {
      this.#emit('fall', 0);
      this.#loseLife();
    } else if (y[ship] > BLACK_HOLE.goal) {
      this.#win();
    } else if (x[ship] < 0 || x[ship] > BLACK_HOLE.width || y[ship] < 0) {
      this.#emit('left', 0);
      this.#holdBreath('same');
    }
  }

  /** A fall counts once even where discs overlap. */
  #hasFallen(): boolean {
    const { world, ship, holeIds } = this.#scene;
    const { Position, Collider } = world.components;
    const x = Position.x[ship];
    const y = Position.y[ship];
    let fallen = false;
    for (let i = 0; i < holeIds.length; i++) {
      const id = holeIds[i];
      const dx = Position.x[id] - x;
      const dy = Position.y[id] - y;
      const square = dx * dx + dy * dy;
      const radius = Collider.radius[id];
      if (square <= radius * radius) fallen = true;
      else if (square < (SLING.near * radius) ** 2) this.#near.add(id);
      else if (square > (SLING.far * radius) ** 2 && this.#near.delete(id)) {
        this.slings++;
        this.#emit('sling', 1);
      }
    }
    return fallen;
  }

  #win(): void {
    const { goalPoints } = this;
    this.#emit('goal', goalPoints);
    this.score += goalPoints;
    const saved = this.options.fuel ? Math.floor((FUEL_BONUS * this.fuel) / TANK) : 0;
    if (this.redraws === 0) this.bonus += this.slings + saved;
    this.slingshots += this.slings;
    this.dodged++;
    this.#holdBreath('level');
  }

  #loseLife(): void {
    this.lives--;
    if (this.lives > 0) {
      this.#holdBreath('other');
      return;
    }
    this.phase = 'over';
    this.push = undefined;
    this.#holdShip();
    this.#emit('over', this.score);
  }

  /** Ends the flight: the ship stays where it is, its engine off, until the next one is prepared. */
  #holdBreath(next: 'same' | 'other' | 'level'): void {
    this.phase = 'breath';
    this.push = undefined;
    this.next = next;
    this.#delta[WAIT] = BREATH;
    this.#holdShip();
  }

  #wait(dt: number): void {
    this.#delta[WAIT] -= dt;
    if (this.#delta[WAIT] > 0) return;
    if (this.next !== 'same') this.#newHoles(this.next === 'level');
    this.#newFlight();
  }

  /** @param isNewLevel resets the count of layout changes */
  #newHoles(isNewLevel: boolean): void {
    if (isNewLevel) this.redraws = 0;
    const scene = this.#scene;
    scene.redraw(this.level, this.movingHoles, (holes) => !opensToOneKey(holes, scene.isSteep));
  }

  /** Prepares a ship at the start. */
  #newFlight(): void {
    this.phase = 'ready';
    this.push = undefined;
    this.#scene.placeShip(BLACK_HOLE.start.x, BLACK_HOLE.start.y);
    this.fuel = TANK;
    this.#delta[SPENT] = 0;
    this.slings = 0;
    this.#near.clear();
    this.record.clear();
  }

  /** Keeps the ship at the start before an input, and where its flight ended after it. */
  #holdShip(): void {
    const { world, ship, placeShip } = this.#scene;
    const { x, y } = world.previous.Position;
    world.components.Thrust.x[ship] = 0;
    world.components.Thrust.y[ship] = 0;
    if (this.phase === 'ready') placeShip(BLACK_HOLE.start.x, BLACK_HOLE.start.y);
    else placeShip(x[ship], y[ship]);
  }

  #emit(kind: GameEvent['kind'], points: number): void {
    const { world, ship } = this.#scene;
    const { x, y } = world.components.Position;
    this.events.push(markImmutable({ kind, tick: world.tick, x: x[ship], y: y[ship], points }));
    if (this.events.length > MAX_EVENTS) this.events.shift();
    this.eventCount++;
  }
}

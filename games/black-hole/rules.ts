/**
 * The rules of the game, applied to the world after every step.
 *
 * - A centre of the ship inside a horizon costs one of three lives; the holes are drawn anew.
 * - The goal line gives as many points as there are holes, so that n levels give n (n + 1) / 2; then there is one more.
 * - Whoever leaves the stage starts again below the same holes, for free.
 * - Other holes may be wished for at any time, free of charge.
 * - Bonus points, apart from the score: one for every slingshot of a flight that reaches the goal, and up to five for
 *   fuel left over; none where other holes were wished for in the level.
 */
import { keepState, markImmutable } from '@principia/physics';
import { BLACK_HOLE, type BlackHole } from '@principia/scenes';
import { type Heading, thrustOf } from './heading.ts';

export const LIVES = 3;
/** Change of velocity that a full tank gives, m/s: a climb without holes takes 100. */
export const TANK = 250;
/** From this level on some of the holes move. */
export const FIRST_MOVING_LEVEL = 5;
/** A slingshot is a visit within the first of these distances, in radii, that ends beyond the second. */
const SLING = { near: 3, far: 6 } as const;
const FUEL_BONUS = 5;

/** What happened, for pictures and sounds. */
export interface News {
  readonly kind: 'fall' | 'goal' | 'left' | 'redraw' | 'sling' | 'empty' | 'over' | 'launch';
  readonly tick: number;
  readonly x: number;
  readonly y: number;
  readonly points: number;
}

/** What the player may change about the rules. */
export interface RuleOptions {
  readonly fuel: boolean;
  readonly moving: boolean;
}

const KEPT_NEWS = 32;

export class Rules {
  /** The ship waits for the first input, flies, or is lost for good. */
  phase: 'ready' | 'flying' | 'over' = 'ready';
  lives = LIVES;
  score = 0;
  bonus = 0;
  /** Levels cleared. */
  dodged = 0;
  /** Wishes for other holes in this level: after one it gives no bonus. */
  redraws = 0;
  slings = 0;
  heading: Heading | undefined;
  /** News so far, and the last few of them. */
  newsCount = 0;
  readonly news: News[] = [];
  options: RuleOptions;
  /** Change of velocity left in the tank and spent in this flight, m/s: in cells, which snapshots copy without garbage. */
  readonly #delta = new Float64Array([TANK, 0]);
  readonly #scene: BlackHole;
  /** Holes the ship is near to. */
  readonly #near = new Set<number>();

  constructor(scene: BlackHole, options: RuleOptions) {
    this.#scene = scene;
    this.options = options;
    keepState(scene.world, this, this.#delta, this.#near);
  }

  /** Change of velocity left in the tank, m/s. */
  get fuel(): number {
    return this.#delta[0];
  }

  set fuel(left: number) {
    this.#delta[0] = left;
  }

  /** Change of velocity spent in this flight, m/s. */
  get spent(): number {
    return this.#delta[1];
  }

  /** The number of holes, which is the prize of the level. */
  get level(): number {
    return Math.min(BLACK_HOLE.most, this.dodged + 1);
  }

  /** Points that the goal gives now. */
  get prize(): number {
    return this.dodged + 1;
  }

  get movingHoles(): number {
    return this.options.moving && this.level >= FIRST_MOVING_LEVEL ? Math.ceil((this.level - 2) / 3) : 0;
  }

  /** A new game, with the first holes of the seed. */
  restart(): void {
    Object.assign(this, { phase: 'ready', lives: LIVES, score: 0, bonus: 0, dodged: 0 });
    this.#scene.rewind();
    this.#newHoles();
  }

  launch(): void {
    if (this.phase !== 'ready') return;
    this.phase = 'flying';
    this.#tell('launch', 0);
  }

  /** The player asks for other holes. */
  redraw(): void {
    if (this.phase === 'over') return;
    this.#tell('redraw', 0);
    this.redraws++;
    this.#newHoles(false);
  }

  /** Before the step: pushes the ship as the player steers, while there is fuel. */
  steer(dt: number): void {
    const { world, ship } = this.#scene;
    const cost = BLACK_HOLE.thrust * dt;
    const isPushing = this.phase === 'flying' && this.heading !== undefined && this.hasFuel;
    const push = thrustOf(isPushing ? this.heading : undefined);
    world.components.Thrust.x[ship] = push.x;
    world.components.Thrust.y[ship] = push.y;
    if (!isPushing) return;
    this.#delta[1] += cost;
    if (!this.options.fuel) return;
    this.fuel = Math.max(0, this.fuel - cost);
    if (!this.hasFuel) this.#tell('empty', 0);
  }

  get hasFuel(): boolean {
    // A sum of many small shares may leave a billionth of one.
    return !this.options.fuel || this.fuel > 1e-9;
  }

  /** After the step: falls, the goal, the edge of the stage. At most one of them a step. */
  judge(): void {
    if (this.phase !== 'flying') {
      this.#hold();
      return;
    }
    const { world, ship, placeShip } = this.#scene;
    const { x, y } = world.components.Position;
    if (this.#hasFallen()) {
      this.#tell('fall', 0);
      this.#loseLife();
    } else if (y[ship] > BLACK_HOLE.goal) {
      this.#win();
    } else if (x[ship] < 0 || x[ship] > BLACK_HOLE.width || y[ship] < 0) {
      this.#tell('left', 0);
      placeShip(BLACK_HOLE.start.x, BLACK_HOLE.start.y);
      this.#newFlight();
    }
  }

  /** However many discs overlap there, it is one fall. */
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
        this.#tell('sling', 1);
      }
    }
    return fallen;
  }

  #win(): void {
    const { prize } = this;
    this.#tell('goal', prize);
    this.score += prize;
    const saved = this.options.fuel ? Math.floor((FUEL_BONUS * this.fuel) / TANK) : 0;
    if (this.redraws === 0) this.bonus += this.slings + saved;
    this.dodged++;
    this.#newHoles();
  }

  #loseLife(): void {
    this.lives--;
    if (this.lives > 0) {
      this.#newHoles(false);
      return;
    }
    this.phase = 'over';
    this.heading = undefined;
    this.#hold();
    this.#tell('over', this.score);
  }

  /** @param isNewLevel no other holes were wished for yet */
  #newHoles(isNewLevel = true): void {
    if (isNewLevel) this.redraws = 0;
    this.#scene.redraw(this.level, this.movingHoles);
    this.#scene.placeShip(BLACK_HOLE.start.x, BLACK_HOLE.start.y);
    this.#newFlight();
  }

  #newFlight(): void {
    this.fuel = TANK;
    this.#delta[1] = 0;
    this.slings = 0;
    this.#near.clear();
  }

  /** Before the first input the ship rests at the start; after the last life it rests where it fell. */
  #hold(): void {
    const { world, ship, placeShip } = this.#scene;
    const { x, y } = world.previous.Position;
    world.components.Thrust.x[ship] = 0;
    world.components.Thrust.y[ship] = 0;
    if (this.phase === 'ready') placeShip(BLACK_HOLE.start.x, BLACK_HOLE.start.y);
    else placeShip(x[ship], y[ship]);
  }

  #tell(kind: News['kind'], points: number): void {
    const { world, ship } = this.#scene;
    const { x, y } = world.components.Position;
    this.news.push(markImmutable({ kind, tick: world.tick, x: x[ship], y: y[ship], points }));
    if (this.news.length > KEPT_NEWS) this.news.shift();
    this.newsCount++;
  }
}
